#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::single_constraint {
namespace {

/// A rigid rod that swings from a hinge: what is seen of it at the beginning of a step.
struct RodSample {
  double time, angle;  // [s], [rad]
  Vector end;          // of the rod [m]
  Vector hinge_force;  // of the step [N]
};

std::vector<RodSample> swing_rod(const Setting& setting, double angle, double h, double seconds) {
  Simulation simulation{hinged_rod(angle, setting.length(), setting.mass()), one_row_solved()};
  std::vector<RodSample> samples;
  const auto steps = static_cast<int>(std::lround(seconds / h));
  for (int i = 0; i <= steps; ++i) {
    const Vector centre = simulation.scene.bodies().pose[1].position;
    const PlaneRotation<double> rotation = simulation.scene.bodies().pose[1].rotation;
    simulation.step(h);
    const auto lambda = simulation.impulse(0);
    samples.push_back(
        {i * h, std::atan2(rotation.sin, rotation.cos), Vector(2 * centre), Vector(lambda[0], lambda[1]) / h});
  }
  return samples;
}

// The rigid rod and its curve.
const Colour rigid = palette::series(4);

/// Twice the time between the first two passages through the lowest point [s].
double measured_period(const std::vector<RodSample>& samples) {
  std::vector<double> passages;
  for (std::size_t i = 1; i < samples.size() && passages.size() < 2; ++i) {
    const RodSample &a = samples[i - 1], &b = samples[i];
    if ((a.angle > 0) != (b.angle > 0) && std::abs(a.angle) < 1.5)
      passages.push_back(a.time + (b.time - a.time) * a.angle / (a.angle - b.angle));
  }
  return passages.size() == 2 ? 2 * (passages[1] - passages[0]) : 0;
}

void draw_both(Canvas& canvas, const Sample& bob, const RodSample& rod, double length, const Chart& chart) {
  const auto [scene, beside] = canvas.page().inset(20).panels(0.56);
  canvas.look(fit({-1.25 * length, -1.3 * length, 2.5 * length, 2.4 * length}, scene, 10));
  pictures::draw(canvas, {.bobs = {{bob.position, 1}}, .rods = {{{0, 0}, bob.position}}});
  pictures::draw(canvas, {.links = {{{0, 0}, rod.end}}, .anchors = {{0, 0}}},
                 {.bodies = {mix(palette::paper, rigid, 0.55), {palette::ink, 1.8}}});
  draw(canvas, pictures::grown_to(chart, bob.time), beside);
}

}  // namespace

void rigid_rod(const Setting& setting, Page& page) {
  const double length = setting.length(), mass = setting.mass(), h = setting.h(),
               start = radians(setting.release());
  const CompoundPendulum exact(start, length, mass, gravity());
  const SimplePendulum bob(start, length, gravity());
  page.text(
      R"(A bob in the plane has two components of velocity. Spread the same @ kg evenly along the rod and it can turn:
      now there is a third component, ω, and an inertia I = mL²/12 about the centre. The constraint is a pin of two
      rows (the hinge may move neither along x nor along y), and its J has the arms of (14).)",
      mass);
  page.excerpt("solver/constraints/pin.hpp", "jacobian");

  const auto level = swing_rod(setting, pi / 2, h, h);
  const double share = level[0].hinge_force.y() / (mass * gravity());
  page.predict(
      {.ask =
           R"(The rod is released from horizontal. What force does the hinge carry at the moment of release, in
              units of the weight m·g?)",
       .answer = share,
       .unit = "m·g",
       .tolerance = 0.02,
       .wrong =
           {{0.5,
             say("Each end carries half when the rod is supported at both; here the centre accelerates at @ g.",
                 1 - share)},
            {1, "Then the centre would not fall."}},
       .hints =
           {"The part of the weight that the hinge does not carry makes the centre fall. How fast does it fall?",
            "Take moments about the hinge: (mL²/3)·α = m·g·L/2.",
            "α = 3g/(2L), and the centre is L/2 from the hinge."},
       .hinted = 0.25,
       .right = say("The centre accelerates downwards at @ g, so @ m·g of the weight is not held.", 1 - share,
                    1 - share)});

  const double end = 1.05 * exact.period();
  const auto rod = swing_rod(setting, start, h, end);
  const Swing bobs = swing(setting, h, end);
  const double shown = std::min(end, 4.0);  // of the film [s]
  const auto in_film = [&](auto samples) {
    std::erase_if(samples, [&](const auto& sample) { return sample.time > shown + 1e-9; });
    return samples;
  };
  Curve turned =
            curve("rod", in_film(rod), &RodSample::time, [](const RodSample&s) { return s.angle * 180 / pi; }),
        swung = curve("bob", in_film(bobs), &Sample::time, [](const Sample&s) { return s.angle() * 180 / pi; });
  turned.colour = rigid;
  swung.colour = palette::constraint;
  const Curve rod_exact = pictures::theory("exact", 0, shown, [&](double t) { return exact.angle(t) * 180 / pi; }),
              bob_exact = pictures::theory("", 0, shown, [&](double t) { return bob.angle(t) * 180 / pi; });
  const Chart chart{
      .x = {.label = "time (s)"}, .y = {.label = "angle (°)"}, .curves = {turned, swung, rod_exact, bob_exact}};

  page.sequence("rod_and_bob_swing",
                "The same length and mass, let go together: a bob on a massless rod (blue) and a rigid rod "
                "(olive), which swings "
                "as fast as a bob on two thirds of its length would.",
                Seconds{shown}, [=](Canvas& canvas, double time) {
                  draw_both(canvas, at(bobs, time), at(rod, time), length, chart);
                });

  using Point2 = PlaneParticle;
  using Rigid = PlaneBody;

  page.text(
      R"(Spreading the mass changes the answer: an exact period of @ s instead of @ s, and a hinge that
      carries @ m·g at first. It costs @ numbers in J instead of @, a 2×2 effective mass instead of one number,
      and a sine and cosine in every step. Use it where bodies turn.)",
      exact.period(), bob.period(), share, Jacobian<Rigid, 2>().matrix.size(),
      Jacobian<Point2, 1>().matrix.size());

  const double coarse = measured_period(rod), fine = measured_period(swing_rod(setting, start, h / 2, end));
  const double step = std::sqrt(1.5 * gravity() / length) * h;
  if (coarse > 0) {
    const Quantity ratio("extrapolated/exact period", (2 * fine - coarse) / exact.period());
    const std::string far =
        say("This h is too large to extrapolate to the exact @ s@.", exact.period(),
            setting.release() > 120 ? ": near the top a small loss of energy shortens the swing a lot" : "");
    page.text("With this h the solver's period is @ s. @", Value(coarse, 4),
              page.verdict({{.when = within(0.98, ratio, 1.02),
                             .say = say("Extrapolated to h = 0 it is @ s.", Value(2 * fine - coarse, 4))},
                            {.when = ratio < 0.98, .say = far},
                            {.when = ratio > 1.02, .say = far}}));
  } else
    page.text("In this run the rod does not pass the lowest point twice, so it has no period to measure.");
  page.claim("share of the weight on the hinge, released from horizontal", share, "m·g",
             is(0.25, "mg − m·¾g", absolute(1e-12)));
  page.claim("period of the rigid rod, from h and h/2 towards h = 0", 2 * fine - coarse, "s",
             is(exact.period(), "elliptic integral, length 2L/3", relative(10 * step * step)),
             where(Quantity("h·√(3g/2L)", step) <= 0.06, Quantity("release", setting.release, "°") <= 120));
}

}  // namespace byhand::single_constraint
