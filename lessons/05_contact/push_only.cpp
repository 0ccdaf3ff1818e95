// Step 1: an inequality, and what has to be kept at zero or above.

#include "lessons/05_contact/plain_clamp.hpp"
#include "lessons/05_contact/plain_figure.hpp"
#include "lessons/05_contact/standing_box.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/acts.hpp"
#include "lessons/pictures/boxes.hpp"
#include "solver/constraints/contact.hpp"

namespace byhand::contact {
namespace {

constexpr double stand_seconds = 2.3, lift = 0.3;    // [s], [m]
constexpr int shown_sweeps = 8, enough_sweeps = 10;  // with fewer a row has hardly time to take anything back
constexpr double longest_arrow = 1.6;                // [mgh]; the impact of the landing is far beyond

/// A box that is dropped, and its label.
struct Stand {
  std::string name;
  double width;  // [m]
  StandingBox box;
};

/// s = r²m/I of a corner, r half the width: how much of a push there turns the box, beside what moves it.
double leverage(double width) { return 3 * width * width / (width * width + 1); }

/// What a step of increments that are clamped one by one leaves of the fall: the speed upwards over gh.
double leftover(double width) {
  const double s = leverage(width);
  return s < 1 ? s * (1 - s) / ((1 + s) * (1 + s)) : 0;
}

double speed_after_a_step(const Setting& setting, double width, Clamp clamp) {
  StandingBox box(width, setting.mass, setting.h, 400, clamp);
  box.step();
  return without_rounding(box.velocity()[1] / (gravity * setting.h), 1);
}

/// What has become of a box after the film.
std::string fate(StandingBox box) {
  double highest = 0;
  bool landed = false;
  while (box.time() < stand_seconds) {
    box.step();
    const double below = box.scene().bodies().pose[1].position.y() - 0.5;
    landed = landed || std::any_of(box.lambda().begin(), box.lambda().end(), [](double push) { return push > 0; });
    if (landed) highest = std::max(highest, below);
  }
  const double lean = std::abs(box.scene().bodies().pose[1].rotation.sin);
  if (lean > 0.5) return "tips over";
  if (lean > 1e-3) return say("leans by @°", Value(degrees(std::asin(lean)), 2));
  return highest > 1e-3 ? "hops" : "stands";
}

std::vector<Tick> sweep_ticks() {
  std::vector<Tick> ticks;
  for (int i = 1; i <= shown_sweeps; ++i) ticks.push_back({static_cast<double>(i), say("@", i)});
  return ticks;
}

Chart over_sweeps(const Setting& setting) {
  Chart chart{.x = {.label = "sweep", .ticks = sweep_ticks()}, .y = {.label = "λ (mgh)"}};
  for (const Clamp clamp : {Clamp::each, Clamp::sum}) {
    StandingBox box(setting.width, setting.mass, setting.h, shown_sweeps, clamp);
    const auto by_sweep = box.step();
    for (std::size_t corner = 0; corner < 2; ++corner) {
      Curve curve{.label = say("@, @ row", clamp == Clamp::sum ? "sum" : "each", corner == 0 ? "first" : "second"),
                  .style = CurveStyle::line_and_markers};
      for (std::size_t i = 0; i < by_sweep.size(); ++i) {
        curve.x.push_back(static_cast<double>(i + 1));
        curve.y.push_back(by_sweep[i][corner] / (setting.mass * gravity * setting.h()));
      }
      chart.curves.push_back(std::move(curve));
    }
  }
  chart.references.push_back({.value = 0.5, .label = "half the weight"});
  return chart;
}

/// How far each box has turned.
Chart turns(std::vector<Stand> stands) {
  Chart chart{.x = {.label = "time (s)", .range = {{0, stand_seconds}}}, .y = {.label = "turned by (°)"}};
  double low = 0, high = 0;
  for (Stand& stand : stands) {
    Curve curve{.label = stand.name};
    for (; stand.box.time() < stand_seconds; stand.box.step()) {
      const auto& rotation = stand.box.scene().bodies().pose[1].rotation;
      curve.x.push_back(stand.box.time());
      curve.y.push_back(degrees(std::atan2(rotation.sin, rotation.cos)));
    }
    const auto [least, most] = std::minmax_element(curve.y.begin(), curve.y.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
    chart.curves.push_back(std::move(curve));
  }
  const double room = 0.1 * std::max(high - low, 5.0);  // so that rounding looks like none
  chart.y.range = {{low - room, high + room}};
  return chart;
}

void draw_stand(Canvas& canvas, const Stand& stand, const Rectangle& frame, double weight, int number) {
  const Rectangle below{frame.x, frame.y, frame.width, frame.height - 50};
  canvas.look_at_page();
  const TextStyle bold{.size = frame.width < 200 ? 17.0 : 21.0, .colour = palette::series(number), .bold = true};
  canvas.text({frame.centre().x(), frame.top() - 26}, pictures::wrapped(canvas, stand.name, frame.width, bold),
              bold);
  canvas.clip(below);
  const double half = std::max(0.9, 0.6 * stand.width);
  canvas.look(fit({-half, -0.12, 2 * half, 1.5}, below, 0));
  pictures::Shapes shapes = pictures::shapes_of(stand.box.scene());

  pictures::draw(canvas, shapes);
  const auto contacts = stand.box.contacts();
  for (std::size_t i = 0; i < stand.box.lambda().size(); ++i) {
    const Pose<PlaneBody>& pose = stand.box.scene().bodies().pose[contacts[i].at.body2];
    const Point at =
        anchor<PlaneBody, double>(pose, in_world<PlaneBody, double>(pose, contacts[i].at.arms.second));
    if (stand.box.lambda()[i] > 0)
      canvas.vector(at, Point(0, std::min(longest_arrow, stand.box.lambda()[i] / weight)),
                    {palette::force, 0.7, "mgh"});
  }
  canvas.clip({});
  canvas.look_at_page();
}

}  // namespace

void push_only(const Setting& setting, Page& page) {
  const double h = setting.h(), mass = setting.mass, width = setting.width(), weight = mass * gravity * h;
  const double s = leverage(width), up = speed_after_a_step(setting, width, Clamp::each);

  page.text(
      R"(A rod pulls and pushes: its row is an equation, and λ may have either sign. The ground only pushes. The article
      gives the C of a contact in (23). P₁ = x₁ + r₁ and P₂ = x₂ + r₂ are the points that are about to touch, and C is
      the gap between them along the normal n:)");
  page.equation(23);
  page.text(
      R"(n points from body 1 to body 2, so C is positive for a gap and negative for an overlap. Keep n fixed during a
      step and differentiate: the coefficients of v₁, ω₁, v₂, ω₂ are the row (15). (If you swap the bodies, n is
      reversed as well, and J, C and λ stay the same.))");
  page.equation(15);
  page.excerpt("solver/constraints/contact.hpp", "jacobian");
  page.text(
      R"(A contact is not an equation. The two bodies may separate; the row may push but never pull; and where the bodies
      separate it does not push:)");
  page.formula("JV + b ≥ 0,   λ ≥ 0,   and one of the two is zero",
               R"(JV + b \ge 0, \qquad \lambda \ge 0, \qquad \lambda\,(JV + b) = 0)");
  page.text(
      R"(One such row is easy: solve (17), and if λ is negative, take 0. But every sweep visits the row again, and each
      time (17) gives a *change* of λ. Which must stay at zero or above: each change, or the sum of all changes? Try
      both on a box of @ kg, @ m wide and 1 m high, that stands on its two lower corners.)",
      setting.mass, width);
  const std::string explained =
      up > 0
          ? say(R"(The first row alone stops its corner: it gives @ of the weight. The second row then gives another @.
                   Together that is more than the weight, and neither may take anything back: the box rises at @ of
                   gh.)",
                Value(1 / (1 + s), 3), Value(2 * s / (1 + s) / (1 + s), 3), Value(up, 3))
          : "This box is so broad that no row ever has to take anything back: the two end at exactly the weight.";
  page.choose(
      {.ask = R"(The box has stood still, and gravity has made its velocity −gh. Now sweep over its two rows with
                      *each* change clamped at zero. How does the box move after many sweeps?)",
       .options = {{"it still sinks", "A row that finds its corner sinking pushes until it no longer does."},
                   {"it is at rest", up > 0 ? "Then the two would have given exactly the weight." : explained},
                   {"it rises", up > 0 ? explained : "Then one of the two would have given more than its share."}},
       .answer = up > 0 ? 2 : 1,
       .hints = {
           "The first row finds all of the fall and stops its corner alone.",
           R"(A push at one corner changes the rate of the other by A₁₂ λ, A₁₂ = (1 − s)/m with s =
                         r²m/I.)",
           say("Here s = @. After the second row has pushed too, does the first want to take something back?",
               Value(s, 3))}});
  page.text("Both ways to clamp, as this lesson runs them:");
  page.excerpt("lessons/05_contact/standing_box.cpp", "clamp");
  page.figure("two_ways_to_clamp",
              say(R"(λ of the two rows of a @ × 1 m box, sweep by sweep, in units of mgh. With the sum clamped each
          approaches half the weight.)",
                  width),
              over_sweeps(setting));
  if (s < 1)
    page.formula("left over:  s(1 − s)/(1 + s)² · gh = @ gh,   s = r²m/I = @ < 1",
                 R"(\frac{s(1-s)}{(1+s)^2}\,gh = @\,gh \text{ left over},\quad s = \frac{r^2m}{I} = @ < 1)",
                 leftover(width), s);
  else
    page.formula("s = r²m/I = @ ≥ 1:   nothing is left over",
                 R"(s = \frac{r^2m}{I} = @ \ge 1{:}\quad \text{nothing is left over})", s);
  page.derivation(
      "Left over if each change is clamped",
      {{"(19) of a corner, with the arm r of the vertical push", "A₁₁ = A₂₂ = (1 + s)/m",
        R"(A_{11} = A_{22} = \frac{1+s}{m})"},
       {"the arms of the two corners point to opposite sides", "A₁₂ = (1 − s)/m", R"(A_{12} = \frac{1-s}{m})"},
       {"row 1 finds the rate −gh", "λ₁ = mgh/(1 + s)", R"(\lambda_1 = \frac{mgh}{1+s})"},
       {"row 2 then finds −gh + A₁₂λ₁ = −2s gh/(1 + s)", "λ₂ = 2s mgh/(1 + s)²",
        R"(\lambda_2 = \frac{2s\,mgh}{(1+s)^2})"},
       {"row 1 now finds A₁₂λ₂ ≥ 0 for s ≤ 1: it would take some back, and may not", "no further change",
        R"(\text{no further change})"},
       {"speed of the box", "(λ₁ + λ₂)/m − gh = s(1 − s)/(1 + s)² gh",
        R"(\frac{\lambda_1+\lambda_2}{m} - gh = \frac{s(1-s)}{(1+s)^2}\,gh)"}});
  constexpr int sweeps = enough_sweeps;
  std::vector<Stand> stands{{"1 × 1 m, each clamped", 1, {1, mass, h, sweeps, Clamp::each, lift}}};
  if (width != 1)
    stands.push_back({say("@ × 1 m, each clamped", width), width, {width, mass, h, sweeps, Clamp::each, lift}});
  stands.push_back({say("@ × 1 m, sum clamped", width), width, {width, mass, h, sweeps, Clamp::sum, lift}});
  page.text(up > 0 ? R"(For a box at rest this is only @ mm/s. But the same happens at any speed of impact: drop
               the boxes onto their two corners from @ m, and a share of that speed is left over, together with a
               rotation.)"
                   : "Nothing is left over here (@ mm/s). Now drop boxes onto their two corners from @ m.",
            1000 * up * gravity * h, lift);
  std::string fates = say("With each change clamped the square box @", fate(stands[0].box));
  if (width != 1) fates += say(" and the box of @ m @", width, fate(stands[1].box));
  fates += say("; with the sum clamped @ @.", width == 1 ? "it" : say("the box of @ m", width),
               fate(stands.back().box));
  if (std::all_of(stands.begin(), stands.end(), [](const Stand& stand) { return fate(stand.box) == "stands"; }))
    fates = up > 0 ? "All stand: at this width too little is left over to be seen."
                   : "All stand: these boxes are too broad to show the mistake.";
  page.sequence(
      "hop_and_tip",
      say(R"(Boxes fall flat from @ m, with @ a step. @ Arrows: λ of the step (mgh is 0.7 m long; more than @ mgh is
          drawn as that).)",
          lift, several(sweeps, "sweep"), fates, longest_arrow),
      Seconds{stand_seconds}, [stands, h, weight, turned = turns(stands)](Canvas& canvas, double time) mutable {
        const auto [above, under] = canvas.page().inset(16).split_rows(0.6, 10);
        const auto frames = above.cells(1, static_cast<int>(stands.size()), 16);
        for (std::size_t i = 0; i < stands.size(); ++i) {
          while (stands[i].box.time() < time - 0.5 * h) stands[i].box.step();
          draw_stand(canvas, stands[i], frames[i], weight, static_cast<int>(i));
        }
        renderer::draw(canvas, pictures::grown_to(turned, time), under);
      });
  page.text(
      R"(A test with a square box would miss the mistake. A push at one of its corners turns it so much that the other
      corner *falls faster*: each row makes the other ask for more, never for less, and no change is ever negative. The
      entry of A = JM⁻¹Jᵀ between the two corners decides:)");
  page.formula("A₁₂ = (1 − r²m/I)/m = @/m,   positive for w < 0.71 · height",
               R"(A_{12} = \tfrac1m\left(1 - \tfrac{r^2 m}{I}\right) = \tfrac{@}{m}, \qquad
                  \text{positive for } w < \text{height}/\sqrt2)",
               1 - s);
  page.text(
      R"(So **clamp the sum**. A row may take back what it gave, down to zero; a later change may pull as long as the sum
      of all changes pushes. For one row at rest, in the plainest code:)");
  page.excerpt("lessons/05_contact/plain_clamp.cpp", "clamp");
  page.figure(
      "plain_clamp",
      R"(λ of the two rows of a box of ½ × 1 m, sweep by sweep in units of mgh, by these two lines: the first row takes
              back its excess.)",
      chart_of(plain_change));
  page.text(
      R"(Every bound is an interval for the sum λ: from 0 to ∞ for a contact, from −∞ to ∞ for a rod; for friction the
      interval moves:)");
  page.excerpt("lessons/05_contact/on_a_corner.hpp", "bounded");

  page.measure("speed upwards after one step, each clamped", up, "gh");
  page.claim("speed upwards after one step, each change clamped", up, "gh",
             is(leftover(width), "s(1 − s)/(1 + s)², s = r²m/I", absolute(1e-9)),
             Quantity("|r²m/I − 1|", std::abs(s - 1)) > 0.05);
  page.claim("the same for a 1 × 1 m box", speed_after_a_step(setting, 1, Clamp::each), "gh",
             is(0, "A₁₂ < 0: no change is ever negative", absolute(1e-9)));
  page.claim("speed after one step, the sum clamped", speed_after_a_step(setting, width, Clamp::sum), "gh",
             is(0, "it stands", absolute(1e-9)));
  const auto solver = StandingBox(width, mass, h, shown_sweeps, Clamp::sum).step();
  const auto plain = plain_sweeps(plain_change, s, shown_sweeps);
  double apart = 0;
  for (std::size_t i = 0; i < plain.size(); ++i)
    for (std::size_t row = 0; row < 2; ++row)
      apart = std::max(apart, std::abs(solver[i][row] / weight - plain[i][row]));
  page.claim(say("λ of @ by the two lines against the solver", several(shown_sweeps, "sweep")), apart, "mgh",
             is_at_most(1e-9, "the same arithmetic: rounding"));
}

}  // namespace byhand::contact
