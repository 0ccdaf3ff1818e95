// Step 1: an inequality, and what has to be kept at zero or above.

#include <cmath>

#include "lessons/05_contact/standing_box.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"
#include "solver/constraints/contact.hpp"

namespace byhand::contact {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double stand_seconds = 2.3, lift = 0.3;  // [s], [m]
constexpr int shown_sweeps = 8;

/// What a box is stood with, and what it is called.
struct Stand {
  std::string name;
  StandingBox box;
};

/// r²m/I of a corner against the centre: how much more easily a push there moves the corner than the whole box.
double leverage(double width) { return 3 * width * width / (width * width + 1); }

/// What a step of increments that are clamped one by one leaves of the fall: the speed upwards over gh.
double leftover(double width) {
  const double s = leverage(width);
  return s < 1 ? s * (1 - s) / ((1 + s) * (1 + s)) : 0;
}

double speed_after_a_step(const Setting& setting, double width, Clamp clamp) {
  StandingBox box(width, setting.mass, setting.h, 100, clamp);
  box.step();
  return box.velocity()[1] / (gravity * setting.h);
}

std::vector<Tick> sweep_ticks() {
  std::vector<Tick> ticks;
  for (int i = 1; i <= shown_sweeps; ++i) ticks.push_back({static_cast<double>(i), say("@", i)});
  return ticks;
}

Chart over_sweeps(const Setting& setting) {
  Chart chart{.x = {.label = "sweeps (1)", .ticks = sweep_ticks()}, .y = {.label = "λ (mgh)"}};
  for (const Clamp clamp : {Clamp::each, Clamp::sum}) {
    StandingBox box(setting.width, setting.mass, setting.h, shown_sweeps, clamp);
    const auto by_sweep = box.step();
    for (std::size_t corner = 0; corner < 2; ++corner) {
      Curve curve{.label = say("@, @ row", clamp == Clamp::sum ? "sum" : "each", corner == 0 ? "first" : "second"),
                  .style = CurveStyle::line_and_markers};
      for (std::size_t i = 0; i < by_sweep.size(); ++i) {
        curve.x.push_back(static_cast<double>(i + 1));
        curve.y.push_back(by_sweep[i][corner] / (setting.mass() * gravity * setting.h()));
      }
      chart.curves.push_back(std::move(curve));
    }
  }
  chart.references.push_back({.value = 0.5, .label = "half the weight"});
  return chart;
}

void draw_stand(Canvas& canvas, const Stand& stand, const Rectangle& frame, double weight) {
  const Rectangle below{frame.x, frame.y, frame.width, frame.height - 60};
  canvas.look_at_page();
  canvas.text({frame.centre().x(), frame.top() - 26}, stand.name, {.size = 21});
  canvas.clip(below);
  canvas.look(fit({-0.9, -0.3, 1.8, 1.9}, below, 0));
  pictures::draw(canvas, pictures::shapes_of(stand.box.scene()));
  const auto& contacts = stand.box.scene().all<Contact>();
  for (std::size_t i = 0; i < stand.box.lambda().size(); ++i) {
    const Pose<PlaneBody>& pose = stand.box.scene().bodies().pose[contacts[i].at.body2];
    const Point at =
        anchor<PlaneBody, double>(pose, in_world<PlaneBody, double>(pose, contacts[i].at.arms.second));
    if (stand.box.lambda()[i] > 0)
      canvas.vector(at, Point(0, stand.box.lambda()[i] / weight), {palette::force, 0.7, "mgh"});
  }
  canvas.clip({});
  canvas.look_at_page();
}

}  // namespace

void push_only(const Setting& setting, Page& page) {
  const double h = setting.h(), mass = setting.mass(), width = setting.width(), weight = mass * gravity * h;
  const double s = leverage(width), up = speed_after_a_step(setting, width, Clamp::each);

  page.text(
      R"(A rod pulls as willingly as it pushes: its row is an equation, and any λ will do that makes it true. The
      ground only pushes. The article gives its C in (23): with P₁ = x₁ + r₁ and P₂ = x₂ + r₂, the two points that
      are about to touch, it is the gap between them along the normal n:)");
  page.equation(23);
  page.text(
      R"(n points from body 1 to body 2, so C is positive where there is air and negative in overlap. Hold n still
      for the length of a step, differentiate, and (15) is there by inspection. (Swap the bodies and n turns round
      with them: J, C and λ stay what they are.))");
  page.equation(15);
  page.excerpt("solver/constraints/contact.hpp", "jacobian");
  page.text(
      R"(What is wanted of C is no equation. The row may be left alone as long as it opens, and it may push but
      never pull; and where it opens it does not push:)");
  page.formula("JV + b ≥ 0,   λ ≥ 0,   and one of the two is zero",
               R"(JV + b \ge 0, \qquad \lambda \ge 0, \qquad \lambda\,(JV + b) = 0)");
  page.text(
      R"(One such row is easy: solve (17), and if λ is negative, take 0. But a sweep comes by many times, and each
      time (17) gives a *change* of λ. So which is to be kept at zero or above: each change, or their sum? Here are
      both, as this lesson runs them:)");
  page.excerpt("lessons/05_contact/standing_box.cpp", "clamp");
  page.text("Try both on a box that stands on its two lower corners, of @ kg and 1 m high.", setting.mass);
  page.predict(
      {.ask =
           say(R"(A box of @ × 1 m has stood still. Gravity has made its velocity −gh; now its two rows are swept,
               and *each* change is clamped. How fast does the box move up then, in gh?)",
               width),
       .answer = up,
       .unit = "gh",
       .tolerance = 0.015,
       .wrong = {{0, "Row 1 gave its impulse before row 2 spoke, and was not allowed to take any of it back."}},
       .hints =
           {R"(The first row finds the whole fall before it and stops its corner alone. Then the second row adds
               what its own corner still needs. Who takes back what is then too much?)"},
       .right = s < 1 ? say("The first row gave @ of the weight, the second @, and both may only give.",
                            Value(1 / (1 + s), 3), Value(2 * s / (1 + s) / (1 + s), 3))
                      : "This box is so broad that neither row ever has anything to take back."});
  page.figure(
      "two_ways_to_clamp",
      say(R"(λ of the two rows of a @ × 1 m box, sweep by sweep, in units of mgh. Kept as a sum each comes to half
          the weight.)",
          width),
      over_sweeps(setting));
  page.text(
      R"(@ of gh is little, and in each step the same; a box at rest only rattles on it. But gh could be any speed:
      let the boxes *fall* on their two corners from @ m, and what is left over is @ of the speed of the fall, and
      the turn that goes with it.)",
      Value(up, 2), lift, Value(up, 2));
  page.sequence(
      "hop_and_tip",
      say(R"(Three boxes that fall flat from @ m. With each change clamped the square one stands and the slim one
          hops and tips; with the sum clamped it stands. Arrows: λ of the step (mgh is as long as 0.7 m).)",
          lift),
      Seconds{stand_seconds},
      [stands =
           std::vector<Stand>{
               {"1 × 1 m, each clamped", {1, mass, h, setting.sweeps, Clamp::each, lift}},
               {say("@ × 1 m, each clamped", width), {width, mass, h, setting.sweeps, Clamp::each, lift}},
               {say("@ × 1 m, sum clamped", width), {width, mass, h, setting.sweeps, Clamp::sum, lift}}},
       h, weight](Canvas& canvas, double time) mutable {
        const auto frames = canvas.page().inset(16).cells(1, static_cast<int>(stands.size()), 16);
        for (std::size_t i = 0; i < stands.size(); ++i) {
          while (stands[i].box.time() < time - 0.5 * h) stands[i].box.step();
          draw_stand(canvas, stands[i], frames[i], weight);
        }
      });
  page.text(
      R"(The square box is a trap for whoever tests there: nothing at all is to be seen. A push at one corner of it
      turns it so much that the other corner *falls faster*: the rows ask each other for more, never for less, and
      no change is ever negative. The entry of A = JM⁻¹Jᵀ between the two corners decides:)");
  page.formula("A₁₂ = (1 − r²m/I)/m = @/m,   positive for w < 0.71 · height",
               R"(A_{12} = \tfrac1m\left(1 - \tfrac{r^2 m}{I}\right) = \tfrac{@}{m}, \qquad
                  \text{positive for } w < \text{height}/\sqrt2)",
               1 - s);
  page.text(
      R"(So: **the sum is clamped**. A row may take back what it gave, down to zero; a late change that pulls does
      no harm as long as all of them together push. The solver says it once for every bound there is; a contact is
      the interval from 0 to ∞:)");
  page.excerpt("solver/system.hpp", "bound");

  page.measure("speed upwards after one step, each clamped", up, "gh");
  page.claim({.quantity = "speed upwards after one step, each change clamped",
              .unit = "gh",
              .expected = leftover(width),
              .source = "s(1 − s)/(1 + s)², s = r²m/I",
              .measured = up,
              .tolerance = absolute(1e-9),
              .claimed = std::abs(s - 1) > 0.05,
              .range = "r²m/I not within 5 % of 1"});
  page.claim({.quantity = "the same for a 1 × 1 m box",
              .unit = "gh",
              .expected = 0,
              .source = "A₁₂ < 0: no change is ever negative",
              .measured = speed_after_a_step(setting, 1, Clamp::each),
              .tolerance = absolute(1e-9)});
  page.claim({.quantity = "speed after one step, the sum clamped",
              .unit = "gh",
              .expected = 0,
              .source = "it stands",
              .measured = speed_after_a_step(setting, width, Clamp::sum),
              .tolerance = absolute(1e-9),
              .claimed = width >= 0.15,
              .range = "width ≥ 0.15 m: 100 sweeps are enough"});
}

}  // namespace byhand::contact
