// Deeper: where Jacobi diverges.

#include "lessons/03_iterations/knobs.hpp"
#include "renderer/palette.hpp"
#include "solver/constraints/normalised_distance.hpp"

namespace byhand::iterations {
namespace {

/// Where `rods` parallel rods hold a box of unit width, from its middle.
std::vector<double> places(int rods) {
  std::vector<double> x;
  for (int i = 0; i < rods; ++i) x.push_back(static_cast<double>(i) / (rods - 1) - 0.5);
  return x;
}

/// A square box hung on parallel rods, spread evenly over its width.
Scene<PlaneBody> hung_box(int rods, double side, double mass) {
  Scene<PlaneBody> scene;
  const int ceiling = scene.add_body(Linear<PlaneBody>(0, 0), fixed<PlaneBody>());
  const int box = scene.add_body(Linear<PlaneBody>(0, -1.5 * side),
                                 byhand::box<PlaneBody>(mass, Linear<PlaneBody>(side, side)));
  for (const double x : places(rods))
    scene.add(NormalisedDistance<PlaneBody>{
        between<PlaneBody>(scene.bodies(), ceiling, {x * side, 0}, box, {x * side, -side}), side});
  return scene;
}

/// The largest |JV| [m/s] that so many sweeps leave in the step that finds the box at rest.
template <class Solver>
double error_of_box(int sweeps, Solver solver, int rods, const Knobs& knobs) {
  auto scene = hung_box(rods, knobs.length, knobs.mass);
  Work<PlaneBody> work;
  solver.sweeps = sweeps;
  solver.warm_start = false;
  lay_out(scene, solver, work);
  scene.write_rows(work.system, knobs.h());
  add_gravity(scene.state(), scene.gravity, knobs.h());
  solve_rows(solver, scene.state(), work);
  const auto& V = scene.bodies().velocity;
  double largest = 0;
  for (const auto& block : std::get<block_type<PlaneBody, 1, Bound::none>()>(work.system.blocks))
    largest = std::max(largest, std::abs(dot(block.J, V[block.body1], V[block.body2])[0]));
  return largest;
}

double factor(const Jacobi& solver, int rods, const Knobs& knobs) {
  return std::sqrt(error_of_box(6, solver, rods, knobs) / error_of_box(4, solver, rods, knobs));
}

/// The eigenvalue of D⁻¹A for the box falling straight: each rod corrects 1/(1 + m x²/I) of the whole error.
double mu(int rods) {
  double sum = 0;
  for (const double x : places(rods)) sum += 1 / (1 + 6 * x * x);  // I = m/6 for a unit square
  return sum;
}

}  // namespace

void limit_of_jacobi(Page& page, const Knobs& knobs) {
  page.text(
      R"(On a chain Jacobi is slow; on other scenes it can diverge. Hang *one* square box of @ kg on several vertical rods, evenly
      spaced along its top edge.
      Each row sees the falling box and corrects all of its own error; then all impulses act at once. With two or
      three rods that still works; with four the correction is far too large:)",
      knobs.mass);
  renderer::Chart chart;
  chart.x.label = "sweeps";
  chart.y = {.label = "largest error (gh)", .scale = renderer::Scale::logarithmic, .range = {{1e-6, 1e6}}};
  constexpr int last = 20;
  int colour = 0;
  for (const int rods : {2, 3, 4, 8}) {
    renderer::Curve measured{.label = say("@ rods", rods), .style = renderer::CurveStyle::markers};
    renderer::Curve law{.style = renderer::CurveStyle::theory};
    measured.colour = law.colour = renderer::palette::series(colour++);
    for (int sweeps = 1; sweeps <= last; ++sweeps) {
      const double error = error_of_box(sweeps, Jacobi{}, rods, knobs) / knobs.fall();
      if (error < 1e-6 || error > 1e6) break;
      measured.x.push_back(sweeps);
      measured.y.push_back(error);
      law.x.push_back(sweeps);
      law.y.push_back(std::pow(std::abs(1 - mu(rods)), sweeps));
    }
    chart.curves.push_back(measured);
    chart.curves.push_back(law);
  }
  page.figure("limit_of_jacobi",
              "One box on 2, 3, 4 and 8 rods, Jacobi from λ = 0. Markers: measured; dashed: |1 − μ|ⁿ.", chart);
  page.derivation("Where Jacobi diverges",
                  {{"e is the error of λ; the rows see Ae, and each corrects it alone", "change = D⁻¹Ae",
                    R"(\text{change} = D^{-1}Ae)"},
                   {"all changes at once", "e′ = e − D⁻¹Ae", R"(e' = e - D^{-1}Ae)"},
                   {"for an eigenvector, D⁻¹Ae = μe", "e′ = (1 − μ)e", R"(e' = (1 - \mu)\,e)"},
                   {"it shrinks if |1 − μ| < 1", "0 < μ < 2", R"(0 < \mu < 2)"}});
  page.text(
      R"(The largest eigenvalue μ of D⁻¹A decides, where D is the diagonal of A: each sweep multiplies its error by 1 − μ,
      so for μ > 2 it grows. For the box it is Σ 1/(1 + mx²/I), with x a rod's distance from the
      middle and I the moment of inertia: @ with 3 rods, @ with 4. On a chain μ is below 2. The cure is to apply
      only a fraction w of each change (*relaxation*): w < 2/μ, which is @ for 4 rods. Gauss–Seidel needs no cure: the
      second row sees what the first has done.)",
      Value(mu(3), 3), Value(mu(4), 3), Value(2 / mu(4), 3));
  for (const int rods : {2, 3, 4, 8})
    page.claim(say("@ rods: a sweep's factor on the error", rods), factor(Jacobi{}, rods, knobs), "1",
               is(std::abs(1 - mu(rods)), "|1 − μ|, μ = Σ 1/(1 + m x²/I)", relative(1e-9)));
  for (const double share : {0.99, 1.01}) {
    const double relaxation = share * 2 / mu(4);
    page.claim(say("4 rods, relaxed to @", Value(relaxation, 3)),
               factor(Jacobi{.relaxation = relaxation}, 4, knobs), "1",
               is(std::abs(1 - relaxation * mu(4)), "|1 − wμ|", relative(1e-9)));
  }
  page.claim("Gauss–Seidel on 4 rods: error after 20 sweeps",
             error_of_box(20, GaussSeidel{}, 4, knobs) / knobs.fall(), "gh",
             is_at_most(1e-3, "it converges (upper bound)"));
}

}  // namespace byhand::iterations
