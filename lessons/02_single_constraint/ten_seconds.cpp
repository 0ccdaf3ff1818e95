#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"

namespace byhand::single_constraint {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double seconds = 10;

struct Film {
  Swing run;
  SimplePendulum exact;
  double length;
  Chart below;

  void draw(Canvas& canvas, double time) const {
    const auto [above, under] = canvas.page().inset(20).split_rows(0.62, 10);
    double reach = length;
    double top = 0.1 * length;
    for (const Sample& sample : run) {
      reach = std::max(reach, sample.position.norm());
      top = std::max(top, sample.position.y());
    }
    canvas.look(fit({-reach, -reach, 2 * reach, reach + top}, above, 24));
    std::vector<Point> trail;
    for (const Sample& sample : run)
      if (sample.time <= time + 1e-9 && sample.time > time - 1) trail.emplace_back(sample.position);
    const Point ghost = length * from_straight_down<PlaneParticle>(exact.angle(time));
    const Point now = at(run, time).position;
    canvas.line({0, 0}, ghost, {palette::theory, 2, Dash::dashed});
    canvas.disc(ghost, 15 / canvas.camera().scale, {palette::paper, {palette::theory, 2}});
    canvas.trail(trail, {palette::velocity, 3});
    pictures::draw(canvas, {.bobs = {{now, 1}}, .rods = {{{0, 0}, now}}, .anchors = {{0, 0}}});
    canvas.look_at_page();
    canvas.text({above.x + 10, above.top() - 16}, say("@ s", Value(std::floor(time * 10) / 10, 3)),
                {.size = 22, .anchor = Anchor::left, .bold = true});
    canvas.text({above.right() - 10, above.top() - 16},
                say("rod @ m", Value(std::round(now.norm() * 1000) / 1000, 4)),
                {.size = 22, .colour = palette::constraint, .anchor = Anchor::right, .bold = true});
    canvas.text({above.right() - 10, above.top() - 44}, "dashed: the exact pendulum",
                {.size = 18, .colour = palette::theory, .anchor = Anchor::right});
    renderer::draw(canvas, pictures::grown_to(below, time), under);
  }
};

}  // namespace

void ten_seconds(const Setting& setting, Page& page) {
  const double length = setting.length(), mass = setting.mass(), h = setting.h(),
               scale = mass * gravity() * length;
  const Swing run = swing(setting, h, seconds);
  const SimplePendulum exact(radians(setting.release()), length, gravity());
  const Sample &first = run.front(), &last = run.back();
  const double stretch = last.position.norm() / length - 1, change = last.energy - first.energy;

  page.text(
      R"(Here is the whole step; nothing of it is hidden. Two of its lines wait for later: the λ of the last step
      (lesson 3) and the bias b (lesson 4), which is 0 here.)");
  page.excerpt("solver/step.cpp", "step");
  page.text("Let it run for @ seconds from @°, beside the exact pendulum, with C of (2) beneath.", seconds,
            setting.release());

  const Chart C{.x = {.label = "time (s)"},
                .y = {.label = "C (m²)"},
                .curves = {{.label = "C",
                            .x = each(run, [](const Sample& s) { return s.time; }),
                            .y = each(run, [](const Sample& s) { return s.C; }),
                            .colour = palette::error}}};
  page.sequence(
      "ten_seconds",
      say(R"(Blue: the article's step with b = 0. Dashed: the exact pendulum. C only ever grows, fastest where the
          bob is fast; after @ s the rod is @ % too long.)",
          seconds, 100 * stretch),
      Seconds{seconds},
      [film = Film{run, exact, length, C}](Canvas& canvas, double time) { film.draw(canvas, time); });

  page.choose(
      {.ask =
           say(R"(After @ s the rod has grown by @ %, and the bob hangs that much lower at times. Has the energy,
               kinetic and potential, risen or fallen?)",
               seconds, 100 * stretch),
       .options = {{"risen", "Every step the next impulse throws the outward part of V away, and ½m·vᵣ² with it."},
                   {"fallen", say(R"(Yes, by @ m·g·L. Each step the next impulse throws away the outward part of V
                                  that the tangent left, and its kinetic energy with it.)",
                                  -change / scale)}},
       .answer = change > 0 ? 0 : 1,
       .hints = {"An impulse that makes JV = 0 takes a part of V away. Does it ever give one?"}});

  double thrown = 0, squares = 0;
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    thrown += run[i].thrown;
    squares += run[i + 1].velocity.squaredNorm();
  }
  page.text(
      R"(Both can be said exactly. C grows by ½|v|²h² in each step, because d·v = 0 leaves only the square. And the
      energy falls by ½m|ΔV|² in each step, where ΔV is all that the step does to V: gravity along the way is paid
      back by the height, and the rod's push does no work on what follows. A sum of squares: this step can lose
      energy and *cannot* gain any. The angle after @ s is @ rad, the exact one @ rad.)",
      seconds, last.angle(), exact.angle(seconds));
  Curve energy{.label = "the step with b = 0",
               .x = each(run, [](const Sample& s) { return s.time; }),
               .y = each(run, [&](const Sample& s) { return (s.energy - first.energy) / scale; }),
               .colour = palette::error};
  Curve still{.label = "exact", .x = {0, seconds}, .y = {0, 0}, .style = CurveStyle::theory};
  page.figure(
      "energy",
      say("Change of energy in units of m·g·L. After @ s it is @: falling, in steps, wherever the bob is fast.",
          seconds, change / scale),
      Chart{.x = {.label = "time (s)"}, .y = {.label = "ΔE/(m·g·L)"}, .curves = {energy, still}});
  page.measure("rod after ten seconds", 100 * stretch, "% too long");
  page.measure("energy after ten seconds", change / scale, "m·g·L");

  page.claim({.quantity = "C at the end",
              .unit = "m²",
              .expected = 0.5 * h * h * squares,
              .source = "½h²·Σ|v|² over all steps",
              .measured = last.C,
              .tolerance = absolute(1e-11 * length * length)});
  page.claim({.quantity = "energy at the end",
              .unit = "J",
              .expected = -thrown,
              .source = "−½m·Σ|ΔV|² over all steps",
              .measured = change,
              .tolerance = absolute(1e-11 * scale)});
  const double ratio = gravity() / length * h * h;
  const double half = swing(setting, h / 2, 2).back().C, whole = swing(setting, h, 2).back().C;
  page.claim({.quantity = "C after 2 s with h, over C with h/2",
              .unit = "1",
              .expected = 2,
              .source = "law of the drift, Ċ ≈ ½hv²",
              .measured = whole / half,
              .tolerance = absolute(10 * std::sqrt(ratio)),
              .claimed = ratio <= 0.0025,
              .range = "h·√(g/L) ≤ 0.05"});
}

}  // namespace byhand::single_constraint
