#include "lessons/02_single_constraint/plain_figure.hpp"
#include "lessons/02_single_constraint/plain_step.hpp"
#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::single_constraint {
namespace {

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

  page.text("The article's whole step for the bob, in seven lines, with the equations beside them:");
  page.excerpt("lessons/02_single_constraint/plain_step.cpp", "step");
  page.choose(
      {.ask = say(
           R"(Let the solver swing the bob for @ seconds from @°. The rod grows by @ %, so at the lowest point the bob
                  is lower than it should be. Has the energy, kinetic and potential together, risen or fallen?)",
           seconds, setting.release(), course::small_error(100 * stretch, 4)),
       .options = {{"risen",
                    R"(A rod cannot give energy: the impulse takes the part of V along d away, and with it the
                             kinetic energy of that part.)"},
                   {"fallen", say(R"(It has fallen by @ m·g·L. Each step moves the bob off the circle, and the next
                                  impulse takes the outward part of V away, with its kinetic energy.)",
                                  course::small_error(-change / scale, 4))},
                   {"that depends on h", "h sets only how much: what a step loses is a square, never negative."}},
       .answer = change > 0 ? 0 : 1,
       .hints = {"What does an impulse that makes JV = 0 do to the part of V along d?",
                 "Kinetic energy is ½m(v_along² + v_across²).", "v_along becomes 0, v_across stays."}});

  page.figure(
      "plain_step",
      say("The seven lines, @ s from @°: C never falls, and the energy never rises.", seconds, setting.release()),
      chart_of(plain_step, {.L = length, .m = mass, .release = radians(setting.release()), .h = h}));
  page.text(
      R"(The solver does the same for any bodies and constraints (`advance` in solver/advance.hpp). Here are its @ seconds
      from @°, with C of (2) beneath.)",
      seconds, setting.release());

  const Chart C{
      .x = {.label = "time (s)"},
      .y = {.label = "C (m²)"},
      .curves = {
          {.label = "", .x = each(run, &Sample::time), .y = each(run, &Sample::C), .colour = palette::error}}};
  page.sequence(
      "ten_seconds",
      "Blue: the article's step with b = 0. Dashed: the exact pendulum. C grows fastest where the bob is fastest.",
      Seconds{seconds},
      [film = Film{run, exact, length, C}](Canvas& canvas, double time) { film.draw(canvas, time); });

  double thrown = 0, squares = 0;
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    thrown += run[i].thrown;
    squares += run[i + 1].velocity.squaredNorm();
  }
  page.text(
      R"(After @ s the bob is at @°, the exact pendulum at @°. C and the energy follow exact laws. Each step makes C larger by ½|v|²h² and the energy smaller by ½m|ΔV|², where ΔV is
      the whole change of V, by gravity and impulse together. Both are squares: with b = 0 this step loses energy and
      *cannot* gain any. A step that stops before its rows agree (lesson 3), starts from old λ, or has b ≠ 0 can.)",
      seconds, Value(last.angle() * 180 / pi, 3), Value(exact.angle(seconds) * 180 / pi, 3));
  page.derivation(
      "What a step does to C and to the energy",
      {{"(2) after the move, with d′ = d + hv", "C′ − C = ½|d + hv|² − ½|d|²",
        R"(C' - C = \tfrac12|d + hv|^2 - \tfrac12|d|^2)"},
       {"d·v = JV = 0 after the solve", "C′ − C = ½h²|v|²", R"(C' - C = \tfrac12 h^2|v|^2)"},
       {"kinetic energy, with v = V′ after the solve and ΔV = V′ − V", "½m|V′|² − ½m|V|² = mV′·ΔV − ½m|ΔV|²",
        R"(\tfrac12 m|V'|^2 - \tfrac12 m|V|^2 = mV'\cdot\Delta V - \tfrac12 m|\Delta V|^2)"},
       {"mΔV = mgh + λd, and d·V′ = 0", "mV′·ΔV = mg·(hV′)", R"(mV'\cdot\Delta V = mg\cdot(hV'))"},
       {"the bob moves by hV′: gravity's work equals the loss of potential energy", "E′ − E = −½m|ΔV|²",
        R"(E' - E = -\tfrac12 m|\Delta V|^2)"}});

  say_where_else(page);
  page.measure("rod after ten seconds", 100 * stretch, "% too long");
  page.measure("change of energy in ten seconds", change / scale, "m·g·L");

  Vec2 x{first.position.x(), first.position.y()}, v{first.velocity.x(), first.velocity.y()};
  for (std::size_t i = 0; i + 1 < run.size(); ++i) plain_step(x, v, mass, {0, -gravity()}, h);
  page.claim("position after ten seconds: the seven lines against the solver",
             (Vector(x.x, x.y) - last.position).norm(), "m",
             is(0, "the same step; its rounding grows with the number of steps",
                absolute(1e-11 * static_cast<double>(run.size()) * last.position.norm())));
  double least_rise = INFINITY, largest_gain = -INFINITY;
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    least_rise = std::min(least_rise, run[i + 1].C - run[i].C);
    largest_gain = std::max(largest_gain, run[i + 1].energy - run[i].energy);
  }
  page.claim("least change of C in a step", least_rise, "m²",
             is_at_least(-1e-14 * last.position.squaredNorm(), "½h²|v|² ≥ 0, but for rounding"));
  page.claim("largest change of energy in a step", largest_gain, "J",
             is_at_most(1e-13 * scale * (last.position.norm() / length), "−½m|ΔV|² ≤ 0, but for rounding"));
  page.claim("C at the end", last.C, "m²",
             is(0.5 * h * h * squares, "½h²·Σ|v|² over all steps", absolute(1e-11 * length * length)));
  page.claim("change of energy in ten seconds", change, "J",
             is(-thrown, "−½m·Σ|ΔV|² over all steps", absolute(1e-11 * scale)));
  const double ratio = gravity() / length * h * h;
  const double half = swing(setting, h / 2, 2).back().C, whole = swing(setting, h, 2).back().C;
  // from near the top, lost energy shifts the swing
  page.claim(
      "C after 2 s with h, over C with h/2", whole / half, "1",
      is(2, "ΔC = ½h²v² a step, so Ċ ≈ ½hv²", absolute(10 * std::sqrt(ratio))),
      where(Quantity("h·√(g/L)", std::sqrt(ratio)) <= 0.05, Quantity("release", setting.release, "°") <= 150));
}

}  // namespace byhand::single_constraint
