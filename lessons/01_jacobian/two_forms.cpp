#include "lessons/01_jacobian/picture.hpp"
#include "lessons/scenes/pendulum.hpp"

// ½(d² − L²) or |d| − L: the same impulse, another λ, and what happens when C and J are taken from two of them.
namespace byhand::lesson01 {
namespace {

//! [mixed]
/// A rod with the C of (2) and the J of |d| − L: each is right, but not together.
template <class Model>
struct Mixed : Distance<Model> {
  Jacobian<Model, 1> jacobian(const Pose<Model>& pose1, const Pose<Model>& pose2) const {
    return NormalisedDistance<Model>{this->at, this->length}.jacobian(pose1, pose2);
  }
};
//! [mixed]

constexpr double share = 0.01;  // of the rod's length that it is too long at first

/// The stretches [m] of a bob at rest in weightlessness while Baumgarte's cure with `beta` acts.
template <template <class> class Rod>
std::vector<double> stretches(double length, double mass, double beta, double h, int steps) {
  Simulation<PlaneParticle> simulation{{}, {.solver = GaussSeidel{.sweeps = 1}, .drift = Baumgarte{.beta = beta}}};
  Scene<PlaneParticle>& scene = simulation.scene;
  scene.gravity.setZero();
  scene.add_body(Linear<PlaneParticle>(0, 0), fixed<PlaneParticle>());
  scene.add_body(Linear<PlaneParticle>((1 + share) * length * from_straight_down<PlaneParticle>(0.6)),
                 with_mass<PlaneParticle>(mass));
  Rod<PlaneParticle> rod;
  rod.at = {0, 1};
  rod.length = length;
  scene.add(rod);
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) {
    all.push_back(scene.bodies().pose[1].position.norm() - length);
    if (i < steps) simulation.step(h);
  }
  return all;
}

/// Which share of the stretch the first step removes.
template <template <class> class Rod>
double gain(double length, const Settings& set) {
  const auto stretch = stretches<Rod>(length, set.mass, set.beta, set.h, 1);
  return 1 - stretch[1] / stretch[0];
}

/// The same on paper for a stretch s: (2) has C/d = s (2L + s) / (2(L + s)), |d| − L has C = s, mixed C = s (2L +
/// s) / 2.
double squared_on_paper(double beta) { return beta * (2 + share) / (2 * (1 + share)); }
double mixed_on_paper(double beta, double length) { return beta * length * (2 + share) / 2; }

renderer::Chart gains(const Settings& set) {
  renderer::Curve squared{
      .label = "(2) with (14)", .style = renderer::CurveStyle::markers, .colour = palette::constraint};
  renderer::Curve normalised{
      .label = "|d| − L with n", .style = renderer::CurveStyle::markers, .colour = palette::velocity};
  renderer::Curve mixed{.label = "(2) with n", .style = renderer::CurveStyle::markers, .colour = palette::force};
  renderer::Curve flat{.label = "β", .style = renderer::CurveStyle::theory};
  renderer::Curve steep{.label = "β·L", .style = renderer::CurveStyle::theory};
  for (int i = 0; i <= 12; ++i) {
    const double length = 0.25 * std::pow(2, i / 2.0);
    const auto add = [length](renderer::Curve& curve, double gained) {
      curve.x.push_back(length);
      curve.y.push_back(gained);
    };
    // Both forms lie on β: taken in turn, so that neither hides the other.
    if (i % 2 == 0)
      add(squared, gain<Distance>(length, set));
    else
      add(normalised, gain<NormalisedDistance>(length, set));
    add(mixed, gain<Mixed>(length, set));
    add(flat, set.beta);
    add(steep, mixed_on_paper(set.beta, length));
  }
  return {.x = {.label = "length of the rod (m)", .scale = renderer::Scale::logarithmic},
          .y = {.label = "share of the stretch removed in a step", .scale = renderer::Scale::logarithmic},
          .curves = {mixed, squared, normalised, flat, steep},
          .references = {{renderer::Reference::Across::y, 2, "beyond 2 it diverges"}}};
}

}  // namespace

void two_forms(course::Page& page, const Settings& set) {
  const double length = set.length;
  page.text(
      R"(One can also begin with C = |d| − L, an error in metres (`./lessons/run desk --task 3`). Its l₂ is n = d/|d|:
      (14) divided by the length of d. Both are right. A bob flies outwards and the solver stops it at the end of its
      rod, once with each row (by (17) of lesson 2):)");
  const auto at = pendulum<PlaneParticle>(0.6, length, set.mass);
  const Pose<PlaneParticle>&anchor = at.bodies().pose[0], &bob = at.bodies().pose[1];
  const InverseMass<PlaneParticle>&m1 = at.bodies().inverse_mass[0], &m2 = at.bodies().inverse_mass[1];
  const Velocity<PlaneParticle> still = Velocity<PlaneParticle>::Zero(), flying(set.speed, 0);
  struct Impulse {
    double lambda;
    Linear<PlaneParticle> on_bob;
  };
  const auto stop = [&](const Jacobian<PlaneParticle, 1>& J) {
    const Jacobian<PlaneParticle, 1> W = times_inverse_mass(J, m1, anchor, m2, bob);
    const double lambda = impulse(J, W, still, flying, 0);
    return Impulse{lambda, lambda * J.l2().transpose()};
  };
  const Impulse squared = stop(Distance<PlaneParticle>{{0, 1}, length}.jacobian(anchor, bob));
  const Impulse normalised = stop(NormalisedDistance<PlaneParticle>{{0, 1}, length}.jacobian(anchor, bob));
  page.text(
      R"(
      - from (2): λ = @ N·s/m, the impulse λJᵀ on the bob is @ N·s
      - from |d| − L: λ = @ N·s, the impulse is @ N·s)",
      squared.lambda, vector(squared.on_bob), normalised.lambda, vector(normalised.on_bob));
  page.text(
      R"(The impulse is the same. λ differs by the factor |d|, here @ m, and in its unit, N·s/m instead of N·s: never
      compare the λ of one form with the λ of the other, or with a bound meant for the other.

      Mixing the forms goes wrong as soon as C is used too. Drift correction (lesson 4) demands JV = −(β/h)C, which should remove a share
      β of the error in each step. With C and J of the same form it nearly does. With C from (2)
      and J from |d| − L, an easy mistake when the article's C meets a normalised row, the share is β·L/(1 m): it
      depends on the unit of length!)",
      length);
  page.excerpt("lessons/01_jacobian/two_forms.cpp", "mixed");
  page.figure(
      "gains",
      course::say(
          R"(Share of a stretch (1 % of L) that one step removes, β = @. The matching pairs lie on β, drawn at alternate
                  lengths.)",
          set.beta),
      gains(set));
  const double diverges = 2 / set.beta;
  page.text(
      "On a rod of 1 m nobody would notice, so test with other lengths. @",
      set.beta < 1 && diverges <= 16
          ? course::say("At β = @ the mixed rod overshoots from about L = @ m on and diverges from about @ m on.",
                        set.beta, 1 / set.beta, diverges)
          : course::say("The line β·L reaches 2, where the mixed rod diverges, at L = 2/β: here @ m@.", diverges,
                        diverges > 16 ? ", beyond the figure" : ""));

  const auto own = stretches<Distance>(10, set.mass, 0.2, set.h, 20),
             mixed = stretches<Mixed>(12, set.mass, 0.2, set.h, 5);
  const double size = squared.on_bob.norm();
  page.claim("impulse of both forms, difference", (squared.on_bob - normalised.on_bob).norm(), "N·s",
             is(0, "λ grows by |d| where J shrinks by it", course::absolute(1e-14 * size)));
  page.claim("λ of |d| − L over λ of (2)", normalised.lambda / squared.lambda, "m",
             is(length, "|d|", course::relative(1e-14)));
  page.claim("share removed, (2) with (14)", gain<Distance>(length, set), "1",
             is(squared_on_paper(set.beta), "β(2L + s)/(2(L + s)), s = 1 % of L", course::absolute(1e-11)));
  page.claim("share removed, |d| − L with n", gain<NormalisedDistance>(length, set), "1",
             is(set.beta, "β", course::absolute(1e-11)));
  page.claim("share removed, (2) with n", gain<Mixed>(length, set), "1",
             is(mixed_on_paper(set.beta, length), "βL(1 + s/(2L))", course::absolute(1e-11 * (1 + length))));
  page.claim("10 m rod at β = 0.2 after 20 steps, own J: share left", std::abs(own.back() / own.front()), "1",
             is(std::pow(1 - squared_on_paper(0.2), 20) * (1 + 1e-9), "the first step removes the smallest share",
                course::at_most()));
  page.claim("12 m rod at β = 0.2 after 5 steps, mixed: growth", std::abs(mixed.back() / mixed.front()), "1",
             is(1, "β·L > 2 diverges", course::at_least()));
}

}  // namespace byhand::lesson01
