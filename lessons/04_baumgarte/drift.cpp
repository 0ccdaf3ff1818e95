// Step 1: drift, and the law of how it grows.

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::baumgarte {
namespace {

constexpr double spiral_seconds = 4;

/// The radii that JV = 0 leads through [m]: each step adds the square of its way, and |v||d| stays.
std::vector<double> radii(double radius, double speed, double h, int steps) {
  std::vector<double> squares{radius * radius};
  for (int i = 0; i < steps; ++i)
    squares.push_back(squares.back() + std::pow(h * speed * radius, 2) / squares.back());
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

/// The angle of one step round the circle at first, ωh [1].
double turn_of(const Setting& setting) { return setting.speed() * setting.h() / setting.length; }

struct SpiralFilm {
  Track run;
  double length;
  Chart beside;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.52, 20);
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
    renderer::draw(canvas, pictures::grown_to(beside, time), right.lowered(60));
  }
};

Chart law_of_drift(const Setting& setting) {
  const double length = setting.length, speed = setting.speed();
  Chart chart{.x = {.label = "time (s)", .scale = Scale::logarithmic},
              .y = {.label = "C/L", .scale = Scale::logarithmic}};
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
      expected.y.push_back(laws::drifted_radius(length, speed, h, sample.time) / length - 1);
    }
    chart.curves.push_back(measured);
    chart.curves.push_back(expected);
  }
  return chart;
}

}  // namespace

void drift(const Setting& setting, Page& page) {
  const double length = setting.length, speed = setting.speed(), mass = setting.mass, h = setting.h();
  const int steps = static_cast<int>(std::lround(spiral_seconds / h));
  const Track run = circling(setting, speed, NoDriftCure{}, h, steps);
  const std::vector<double> exact = radii(length, speed, h, steps);
  const double C = run.back().position.norm() - length;
  const double lost = 1 - run.back().kinetic / run.front().kinetic;
  const bool visible = C > 0.02 * length;

  page.text(
      R"(In lesson 2 the rod grew longer and longer. Each step moves the bob along the tangent, because JV = 0 asks for
      no more, and the tangent leaves the circle. This growing error, here C = |d| − L in metres, is called *drift*. To
      see it alone, take gravity away: a bob circles at @ m/s on a rod of @ m with h = @ s, and nothing corrects the
      drift (b = 0).)",
      speed, length, setting.h);
  page.choose(
      {.ask = "After a few revolutions the bob is farther out than it should be. What has happened to its kinetic "
              "energy?",
       .options = {{"risen",
                    R"(The bob moved outward, but nothing pushed it outward. The next impulse removes the outward
                    part of V, and its energy ½m·vᵣ² with it.)"},
                   {"the same",
                    R"(The pull is along the rod and the bob moves across it, so no work is done: true in the limit
                    h → 0. After a step of finite size the velocity points a little outward, and the next impulse
                    removes that part.)"},
                   {"fallen",
                    say("The bob has lost @ %. Each impulse removes the outward part of V, and ½m·vᵣ² with it.",
                        Value(100 * lost, 3))}},
       .answer = lost > 0 ? 2 : 0,
       .hints = {"Look at the direction of V just after a step, against the rod's new direction.",
                 "(20) with JV = 0 removes the part of V along the rod and leaves the part across it.",
                 "v² = v_across² + vᵣ², and the impulse sets vᵣ = 0."}});
  Curve measured =
      curve("C", run, &Sample::time, [&](const Sample& s) { return 100 * (s.position.norm() - length); });
  measured.colour = palette::error;
  const Curve expected = pictures::theory(
      "law", 0, spiral_seconds,
      [&](double t) { return 100 * (laws::drifted_radius(length, speed, h, t) - length); }, 60);
  const Chart beside{
      .x = {.label = "time (s)"}, .y = {.label = "C = |d| − L (cm)"}, .curves = {measured, expected}};
  page.sequence("growing_circle",
                say(visible ? R"(A bob on a massless rod, b = 0. The circle opens into a spiral: after @ s the
                              rod is @ cm too long. Right: the error C; dashed, the law below.)"
                            : R"(A bob on a massless rod, b = 0. After @ s the rod is @ cm too long, which is
                              too little to see. Right: the error C; dashed, the law below.)",
                    spiral_seconds, Value(100 * C, 3)),
                Seconds{spiral_seconds}, [film = SpiralFilm{run, length, beside}](Canvas& canvas, double time) {
                  film.draw(canvas, time);
                });
  page.text(
      R"(Lesson 2, step 6 derived the law from two facts. The displacement h·v is at right angles to d, so Pythagoras gives
      the new |d|². The impulse points at the anchor, so the angular momentum m|v||d| stays the same.)");
  page.formula("|d′|² = |d|² + h²|v|²,   |v||d| stays   ⟹   |d| ≈ L (1 + 2hv₀²t/L²)^¼",
               R"(|d'|^2 = |d|^2 + h^2|v|^2, \quad |v||d| = \text{const} \quad\Rightarrow\quad )"
               R"(|d| \approx L\,\bigl(1 + 2hv_0^2t/L^2\bigr)^{1/4})");
  page.formula("at first  Ċ ≈ hv²/2L = @ cm/s",
               R"(\dot C \approx \frac{hv^2}{2L} = @\ \mathrm{cm/s} \text{ at first})",
               100 * h * speed * speed / (2 * length));
  page.text(
      R"(At first the error is proportional to the time, to h and to the centripetal acceleration v²/L. Later it grows with
      the fourth root of time, because the bob slows down as it moves outward. Half the step gives half the early
      drift: smaller steps help, but they never remove it.)");
  const double bend = 2 * turn_of(setting) * turn_of(setting);
  const Quantity at_first("2(vh/L)²", bend), at_last("2v²ht/L² at the end", 1000 * bend);
  const std::string first = page.verdict(
      {{.when = at_first < 0.2, .say = "At first the slope is 1, and dividing h by 4 divides the error by 4."},
       {.when = at_first >= 0.2,
        .say = "The steps are so large that the curve with h bends from its first step on."}});
  const std::string later = page.verdict(
      {{.when = at_last > 2, .say = "Later the curves bend towards the fourth root."},
       {.when = both(at_last <= 2, at_last >= 0.2), .say = "At the end the uppermost curve begins to bend."},
       {.when = at_last < 0.2, .say = "Within this time the curves stay straight."}});
  page.figure("law_of_drift",
              say("Error over time for three steps; points: runs, dashed: the law. @ @", first, later),
              law_of_drift(setting));
  page.measure("C after four seconds", 100 * C, "cm");

  const double turn = turn_of(setting), spread = 1 + 2 * turn * turn * steps, rounding = 1e-12 * steps;
  page.claim(say("rod after @ s", spiral_seconds), run.back().position.norm(), "m",
             is(exact.back(), "|d|² grows by (h|v|)², |v||d| stays", relative(rounding)));
  page.claim("the same from the fourth root", run.back().position.norm(), "m",
             is(laws::drifted_radius(length, speed, h, steps * h), "law of drift: L(1 + 2hv₀²t/L²)^¼",
                relative((std::pow(turn, 4) + turn * turn * std::log(spread) / 2) / (4 * spread) + rounding)));
  page.claim("growth of C in the first step", (run[1].position.norm() - length) / h, "m/s",
             is(h * speed * speed / (2 * length), "law of drift: hv²/2L",
                relative(turn * turn / 4 + 1e-15 / (turn * turn))));
  page.claim("kinetic energy lost, over the energy at first", lost, "1",
             is_at_least(0, "an impulse that makes JV = 0 only removes a part of V"));
  page.claim(
      "kinetic energy at the end", run.back().kinetic, "J",
      is(0.5 * mass * std::pow(speed * length / exact[exact.size() - 2], 2), "|v| = v₀L/|d|", relative(rounding)));
}

}  // namespace byhand::baumgarte
