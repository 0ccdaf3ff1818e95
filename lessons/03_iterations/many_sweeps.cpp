// Step 4: how errors shrink from sweep to sweep.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/textbook.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::iterations {
namespace {

struct Named {
  std::string name;
  GaussSeidel solver;
};
const std::array<Named, 3> orders{{{"top-down", {.warm_start = false, .order = SweepOrder::natural}},
                                   {"bottom-up", {.warm_start = false, .order = SweepOrder::reverse}},
                                   {"red–black", {.warm_start = false, .order = SweepOrder::coloured}}}};

/// Every number of sweeps up to twenty, where the orders differ, then about sixty up to `last`.
std::vector<int> sweep_counts(int last) {
  std::vector<int> counts;
  for (int i = 1; i <= last; i += i < 20 ? 1 : 1 + last / 60) counts.push_back(i);
  return counts;
}

/// The error [gh] over sweeps, each point a solve of its own.
template <class Solver>
renderer::Curve curve_of(std::string label, const Solver& solver, const Knobs& knobs,
                         const std::vector<int>& counts) {
  renderer::Curve curve{.label = std::move(label)};
  for (const int count : counts) {
    curve.x.push_back(count);
    curve.y.push_back(error_after(count, solver, knobs.chain(), knobs.h) / knobs.fall());
  }
  return curve;
}

/// The same for the step that comes after `seconds` of warm steps with the reader's number of sweeps.
renderer::Curve warm_curve(double seconds, const Knobs& knobs, const std::vector<int>& counts) {
  Simulation simulation{rod_chain<PlaneParticle>(knobs.chain()),
                        VelocityStepping{.solver = GaussSeidel{.sweeps = knobs.sweeps}, .drift = NoDriftCure{}}};
  while (simulation.time < seconds) simulation.step(knobs.h);
  renderer::Curve curve{.label = "top-down, warm"};
  for (const int count : counts) {
    auto next = simulation;
    next.method.solver = GaussSeidel{.sweeps = count};
    next.step(knobs.h);
    const double error = residual(next.work.system, next.scene.bodies().velocity) / knobs.fall();
    curve.x.push_back(count);
    curve.y.push_back(error > 1e-15 ? error : NAN);
  }
  return curve;
}

renderer::Curve theory(std::string label, double factor, const std::vector<int>& counts) {
  renderer::Curve curve{.label = std::move(label), .style = renderer::CurveStyle::theory};
  for (const int count : counts) {
    curve.x.push_back(count);
    curve.y.push_back(std::pow(factor, count));
  }
  return curve;
}

}  // namespace

void many_sweeps(Page& page, const Knobs& knobs) {
  const ChainOptions chain = knobs.chain();
  const double rho = laws::left_by_a_sweep(knobs.links), digit = sweeps_per_digit(rho), h = knobs.h;
  std::array<double, 3> digits{};
  for (int i = 0; i < 3; ++i) digits[i] = sweeps_per_digit(measured_factor(orders[i].solver, chain, h));
  const double jacobi = sweeps_per_digit(measured_factor(Jacobi{.warm_start = false}, chain, h));

  page.text(
      R"(How fast do sweeps converge? Solve the same step (a hanging chain, gravity just added to V) with 1, 2, 3, … sweeps
      and compare the largest error each time. There are four ways, all from λ = 0:

      - *Jacobi*: every row sees the same V, then all act at once. It could run in parallel.
      - *Gauss–Seidel* top-down, bottom-up, or *red–black*: all odd rows, then all even ones (rows of one colour
        share no bob, so these could run in parallel too).)");
  constexpr double same = 1e-6;
  const bool alike = std::abs(digits[1] / digits[0] - 1) < same && std::abs(digits[2] / digits[0] - 1) < same;
  const auto steepest = static_cast<int>(std::min_element(digits.begin(), digits.end()) - digits.begin());
  page.choose(
      {.ask = "After many sweeps, in which order does the error fall most steeply?",
       .options =
           {{"top-down",
             "It differs in the first sweeps only; later the error is smooth, and no order reduces it faster."},
            {"bottom-up",
             R"(It begins one sweep behind: its first sweep stops only the top bob (step 2). Later the error is
                                 smooth along the chain, and no order reduces a smooth error faster.)"},
            {"red–black", "Its rows could run in parallel, which makes a sweep quicker, not more effective."},
            {"all the same", R"(The first sweeps differ. Later only the smoothest error is left, a quarter of a
                                    wave over the whole chain, and every order multiplies it by the same factor.)"}},
       .answer = alike ? 3 : steepest,
       .hints = {
           "After a few sweeps every order has smoothed the errors: neighbours are wrong by nearly the same.",
           "A row sees only its own JV: the difference between its two bobs.",
           "For a smooth error that difference is the same, whichever row comes first."}});

  const double second = 1.0;
  const std::vector<int> counts = sweep_counts(std::max(12, static_cast<int>(4.3 * digit)));
  renderer::Chart chart;
  chart.x.label = "sweeps";
  chart.y.label = "largest error (gh)";
  chart.y.scale = renderer::Scale::logarithmic;
  chart.y.range = {{1e-5, 2}};
  for (std::size_t i = 0; i < orders.size(); ++i) {
    chart.curves.push_back(curve_of(orders[i].name, orders[i].solver, knobs, counts));
    chart.curves.back().place = std::array{pictures::place_of("Gauss–Seidel, cold"), 2, 3}[i];
  }
  chart.curves[1].style = renderer::CurveStyle::markers;  // top-down, a sweep later
  std::vector<int> even;                                  // Jacobi's errors alternate
  for (const int count : counts) even.push_back(2 * ((count + 1) / 2));
  even.erase(std::unique(even.begin(), even.end()), even.end());
  chart.curves.push_back(curve_of("Jacobi", Jacobi{.warm_start = false}, knobs, even));
  chart.curves.back().place = pictures::place_of("Jacobi");
  renderer::Curve warm = warm_curve(second, knobs, counts);
  warm.place = pictures::place_of("Gauss–Seidel");
  const double cold_first = chart.curves[0].y.front(), warm_first = warm.y.front();
  const bool warm_seen = warm_first > chart.y.range->first;
  if (warm_seen) chart.curves.push_back(std::move(warm));
  chart.curves.push_back(theory("cosⁿ(π/2N)", std::sqrt(rho), counts));
  chart.curves.push_back(theory("cos²ⁿ(π/2N)", rho, counts));
  page.figure("error_over_sweeps",
              say(R"(Largest error, @ links. Dashed: the rates of theory, from 1. Jacobi: every second sweep. @@)",
                  knobs.links,
                  alike ? "The three orders of Gauss–Seidel fall with the same slope."
                        : "The three orders of Gauss–Seidel have different slopes here.",
                  warm_seen ? say(" The warm curve is the step after @ s with @ a step.", second,
                                  several(knobs.sweeps, "warm sweep"))
                            : std::string()),
              chart);
  page.text(
      R"(On this scale a straight line means that each sweep multiplies the error by the same *convergence factor* ρ. For N
      equal links hung from an anchor it is cos(π/2N) for Jacobi and its square for Gauss–Seidel in *any* order (derived
      in the next step):)");
  page.formula(
      "ρ = cos²(π/2N) = @ for N = @,   one more digit: ln 10 / −ln ρ = @ sweeps",
      R"(\rho = \cos^2\frac{\pi}{2N} = @ \text{ for } N = @, \qquad \frac{\ln 10}{-\ln\rho} = @ \text{ sweeps per digit})",
      rho, knobs.links, digit);
  const Quantity guess("warm error/cold error", warm_first / cold_first);
  page.text(
      R"(A *warm start* begins with the λ of the step before instead of 0. @ In the long run each sweep multiplies the error by the same ρ, whatever λ it began with: a better guess begins lower but does not fall faster. Step 6 shows
      its worth over many steps.)",
      !warm_seen ? say("After @ s of @ a step the error is already below the bottom of this chart.", second,
                       several(knobs.sweeps, "warm sweep"))
                 : say("After one sweep its error is @ gh, the cold one's @ gh. @", Value(warm_first, 2),
                       Value(cold_first, 2),
                       page.verdict({{.when = guess < 1, .say = "The guess is better than none."},
                                     {.when = guess >= 1,
                                      .say = "Here the guess is no better than none, because so few sweeps leave "
                                             "oscillations (step 6)."}})));
  const double farthest = *std::ranges::max_element(digits, {}, [&](double of) { return std::abs(of - digit); });
  page.claim("sweeps for one more digit, the worst of three orders", farthest, "1",
             is(digit, "ρ = cos²(π/2N)", relative(same)));
  page.claim("the same for Jacobi", jacobi, "1", is(2 * digit, "its factor is √ρ", relative(same)));
}

}  // namespace byhand::iterations
