// Step 1: drift, and the law of how it grows.

#include <cmath>

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "renderer/canvas.hpp"

namespace byhand::baumgarte {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double spiral_seconds = 4;

/// The radii that JV = 0 leads through [m]: each step adds the square of its way, and |v||d| stays.
std::vector<double> radii(double radius, double speed, double h, int steps) {
  std::vector<double> squares{radius * radius};
  for (int i = 0; i < steps; ++i)
    squares.push_back(squares.back() + std::pow(h * speed * radius, 2) / squares.back());
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

/// The same for small steps [m].
double law(double radius, double speed, double h, double time) {
  return radius * std::pow(1 + 2 * h * speed * speed * time / (radius * radius), 0.25);
}

struct SpiralFilm {
  Track run;
  double length;
  Chart beside;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).split_columns(0.52, 20);
    const double reach = 1.05 * run.back().position.norm();
    canvas.look(fit({-reach, -reach, 2 * reach, 2 * reach}, left, 24));
    std::vector<Point> circle, trail;
    for (int i = 0; i <= 120; ++i)
      circle.emplace_back(length * std::cos(i * pi / 60), length * std::sin(i * pi / 60));
    for (const Sample& sample : run)
      if (sample.time <= time + 1e-9) trail.emplace_back(sample.position);
    const Point now = at(run, time).position;
    canvas.path(circle, {palette::theory, 2, Dash::dashed});
    canvas.trail(trail, {palette::velocity, 3});
    pictures::draw(canvas, {.bobs = {{now, 1}}, .rods = {{{0, 0}, now}}, .anchors = {{0, 0}}});
    canvas.look_at_page();
    canvas.text({left.x, left.top() - 12}, say("@ s", Value(std::floor(time * 10) / 10, 3)),
                {.size = 22, .anchor = Anchor::left, .bold = true});
    canvas.text({left.x, left.y + 12}, "dashed: the circle it should keep to",
                {.size = 18, .colour = palette::theory, .anchor = Anchor::left});
    renderer::draw(canvas, pictures::grown_to(beside, time), right.inset(0, 60));
  }
};

Chart law_of_drift(const Setting& setting) {
  const double length = setting.length(), speed = setting.speed();
  Chart chart{.x = {.label = "time (s)", .scale = Scale::logarithmic},
              .y = {.label = "C/L (1)", .scale = Scale::logarithmic}};
  for (const int cut : {1, 4, 16}) {
    const double h = setting.h() / cut, end = 1000 * setting.h();
    const Track run = circling(setting, speed, NoDriftCure{}, h, static_cast<int>(std::lround(end / h)));
    Curve measured{.label = cut == 1 ? say("h = @ s", typed(h)) : say("h/@", cut), .style = CurveStyle::markers};
    Curve expected{.label = cut == 1 ? "law" : "", .style = CurveStyle::theory};
    for (double i = cut; i < static_cast<double>(run.size()); i = std::ceil(1.6 * i)) {
      const Sample& sample = run[static_cast<std::size_t>(i)];
      measured.x.push_back(sample.time);
      measured.y.push_back(sample.position.norm() / length - 1);
      expected.x.push_back(sample.time);
      expected.y.push_back(law(length, speed, h, sample.time) / length - 1);
    }
    chart.curves.push_back(measured);
    chart.curves.push_back(expected);
  }
  return chart;
}

}  // namespace

void drift(const Setting& setting, Page& page) {
  const double length = setting.length(), speed = setting.speed(), mass = setting.mass(), h = setting.h();
  const int steps = static_cast<int>(std::lround(spiral_seconds / h));
  const Track run = circling(setting, speed, NoDriftCure{}, h, steps);
  const std::vector<double> exact = radii(length, speed, h, steps);
  const double C = run.back().position.norm() - length, kept = run.back().kinetic / run.front().kinetic;

  page.text(
      R"(Lesson 2 left you with a rod that grew. Each step sends the bob along its tangent, because JV = 0 asks for
      no more, and the tangent leaves the circle. To see that and nothing else, take gravity away: a bob goes round
      at @ m/s on a rod of @ m, h is @ s and nothing cures the drift (b = 0).)",
      speed, length, setting.h);
  Curve measured{.label = "C",
                 .x = each(run, [](const Sample& s) { return s.time; }),
                 .y = each(run, [&](const Sample& s) { return 100 * (s.position.norm() - length); }),
                 .colour = palette::error};
  Curve expected{.label = "law", .style = CurveStyle::theory};
  for (int i = 0; i <= 60; ++i) {
    expected.x.push_back(i * spiral_seconds / 60);
    expected.y.push_back(100 * (law(length, speed, h, expected.x.back()) - length));
  }
  const Chart beside{
      .x = {.label = "time (s)"}, .y = {.label = "C = |d| − L (cm)"}, .curves = {measured, expected}};
  page.sequence(
      "growing_circle",
      say(R"(A bob on a rod without weight, b = 0. The circle opens into a spiral: after @ s the rod is @ cm too
          long. Dashed beside it: the law below.)",
          spiral_seconds, Value(100 * C, 3)),
      Seconds{spiral_seconds},
      [film = SpiralFilm{run, length, beside}](Canvas& canvas, double time) { film.draw(canvas, time); });
  page.choose(
      {.ask = say("The bob is @ % farther out than it should be. What has become of its energy?",
                  Value(100 * C / length, 3)),
       .options = {{"risen",
                    R"(It has gone outward, but nothing pushed it there. Every step the next impulse throws the
                    outward part of V away, and ½m·vᵣ² with it.)"},
                   {"the same",
                    R"(The pull is along the rod and the bob moves across it, so no work is done: true in the
                    limit. A step of finite size leaves the tangent pointing a little outward, and the next impulse
                    throws that part of V away.)"},
                   {"fallen", say(R"(Yes: @ % of it is left. Each impulse throws the outward part of V away, and
                                  ½m·vᵣ² with it.)",
                                  Value(100 * kept, 3))}},
       .answer = kept < 1 ? 2 : 0,
       .hints = {"An impulse that makes JV = 0 takes a part of V away. Does it ever give one?"}});
  page.text(
      R"(The law takes two lines. The way h·v is at right angles to d, so Pythagoras says by how much d² grows; and
      the rod's pull goes through the anchor, so |v||d|, the angular momentum, stays:)");
  page.formula("|d|²  grows by  h²|v|²  a step,   |v||d| stays   ⟹   |d| ≈ L (1 + 2hv₀²t/L²)^¼",
               R"(|d|^2 \mathrel{+}= h^2|v|^2, \quad |v||d| = \text{const} \quad\Rightarrow\quad )"
               R"(|d| \approx L\,\bigl(1 + 2hv_0^2t/L^2\bigr)^{1/4})");
  page.formula("at first  Ċ ≈ hv²/2L = @ cm/s",
               R"(\dot C \approx \frac{hv^2}{2L} = @\ \mathrm{cm/s} \text{ at first})",
               100 * h * speed * speed / (2 * length));
  page.text(
      R"(So the error grows in proportion to time at first, to h and to the centripetal acceleration v²/L, and
      later with the fourth root of time, for the bob gets slower as it gets out. Half the step means half the
      drift: smaller steps help, and never cure.)");
  page.figure(
      "law_of_drift",
      R"(Error over time for three steps. The points are runs, the dashed lines the law: slope 1 at first (each
      quarter of h lowers it by four), bending towards the fourth root.)",
      law_of_drift(setting));
  page.measure("C after four seconds", 100 * C, "cm");

  const double turn = speed * h / length, spread = 1 + 2 * turn * turn * steps, rounding = 1e-12 * steps;
  page.claim({.quantity = say("rod after @ s", spiral_seconds),
              .unit = "m",
              .expected = exact.back(),
              .source = "|d|² grows by (h|v|)², |v||d| stays",
              .measured = run.back().position.norm(),
              .tolerance = relative(rounding)});
  page.claim(
      {.quantity = "the same from the fourth root",
       .unit = "m",
       .expected = law(length, speed, h, steps * h),
       .source = "law B3",
       .measured = run.back().position.norm(),
       .tolerance = relative((std::pow(turn, 4) + turn * turn * std::log(spread) / 2) / (4 * spread) + rounding)});
  page.claim({.quantity = "growth of C in the first step",
              .unit = "m/s",
              .expected = h * speed * speed / (2 * length),
              .source = "law B3: hv²/2L",
              .measured = (run[1].position.norm() - length) / h,
              .tolerance = relative(turn * turn / 4 + 1e-15 / (turn * turn))});
  page.claim({.quantity = "energy at the end",
              .unit = "J",
              .expected = 0.5 * mass * std::pow(speed * length / exact[exact.size() - 2], 2),
              .source = "|v| = v₀L/|d|",
              .measured = run.back().kinetic,
              .tolerance = relative(rounding)});
}

}  // namespace byhand::baumgarte
