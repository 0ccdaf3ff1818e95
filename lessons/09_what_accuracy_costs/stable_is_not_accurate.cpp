// Step 3: errors that are kept apart, because a method may have one and not the other.

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::accuracy {
namespace {

constexpr double film_seconds = 6;

/// A pendulum with a method, and what is seen of it.
struct Swing {
  std::string name;
  renderer::Colour colour;
  AnyScene scene;
  byhand::Setting setting;
  renderer::Curve energy;

  Swing(std::string called, renderer::Colour painted, const Problem& problem, const byhand::Setting& chosen)
      : name(std::move(called)), colour(painted), scene(problem.start()), setting(chosen), energy{.label = name} {
    scene.use(setting.method);
    energy.colour = colour;
  }
  /// Goes on to `time`, frame by frame of the scene.
  void go_on(double time, double start) {
    while (scene.time() < time - 0.5 * frame) {
      for (int i = 0; i < setting.steps; ++i) scene.step(frame / setting.steps);
      energy.x.push_back(scene.time());
      energy.y.push_back((scene.energy() - start) / scene.energy_scale());
    }
  }
};

/// The energy of all of them over the whole film.
renderer::Chart energies(std::vector<Swing> swings, double start) {
  renderer::Chart chart{.x = {.label = "time (s)", .range = {{0, film_seconds}}},
                        .y = {.label = "energy, change over mgL"}};
  double least = 0;
  for (Swing& swing : swings) {
    swing.go_on(film_seconds, start);
    least = std::min(least, *std::min_element(swing.energy.y.begin(), swing.energy.y.end()));
    chart.curves.push_back(swing.energy);
  }
  chart.y.range = {{1.1 * least, 0.15}};
  return chart;
}

void draw_swings(renderer::Canvas& canvas, const std::vector<Swing>& swings, const renderer::Chart& chart,
                 const SimplePendulum& exact, double length, double time) {
  const auto [left, right] = canvas.page().inset(20).panels(0.46, 20);
  const auto cells = left.cells(static_cast<int>(swings.size()), 1, 8);
  for (std::size_t i = 0; i < swings.size(); ++i) {
    const Swing& swing = swings[i];
    canvas.look_at_page();
    canvas.text({cells[i].x, cells[i].top() - 12}, swing.name,
                {.size = 19, .colour = swing.colour, .anchor = renderer::Anchor::left, .bold = true});
    canvas.look(renderer::fit({-1.15 * length, -1.15 * length, 2.3 * length, 1.35 * length}, cells[i], 4));
    const double angle = exact.angle(time);
    const renderer::Point true_bob(length * std::sin(angle), -length * std::cos(angle));
    canvas.line({0, 0}, true_bob, {palette::theory, 1.8, renderer::Dash::dashed});
    canvas.disc(true_bob, 0.07 * length, {renderer::fade(palette::paper, 0), {palette::theory, 1.8}});
    const Eigen::Vector3d bob = swing.scene.placements()[1].position;
    canvas.rod({0, 0}, {bob.x(), bob.y()});
    canvas.disc({bob.x(), bob.y()}, 0.07 * length, {swing.colour, {palette::ink, 1.5}});
    canvas.anchor({0, 0});
  }
  canvas.look_at_page();
  renderer::draw(canvas, pictures::grown_to(chart, time), right);
}

}  // namespace

void stable_is_not_accurate(Page& page) {
  const Problem problem("pendulum", {{"length", 2}, {"mass", 3}});
  const double length = problem["length"];
  const Family &xpbd = family_named("XPBD"), &rattle = family_named("RATTLE"), &direct = family_named("direct");

  page.text(
      R"("How accurate is it?" is several questions. *Drift*: how far has a joint opened? *Trajectory*: how far is each
      body from where it should be? *Energy* and *momentum*: how much was lost or gained, over mgL and over the true
      momentum? *Reaction force*: is the force in a joint right? And, of a solver alone, the *algebraic* error: how far
      are the rows from being solved? A method may be very good in one and very bad in another.)");

  const byhand::Point once = measure(problem, xpbd, {}), symmetric = measure(problem, rattle, {});
  const double left = 100 * (1 - once[Error::energy]);
  page.choose(
      {.ask = say(
           R"(XPBD puts the bob back onto its circle in every step, so that over @ s the rod is wrong by rounding only.
                  What happens to the energy mgL with which the bob starts, at one step a frame?)",
           problem.scene().duration),
       .options =
           {{"it is kept within a few per cent", say("The positions are right, but the velocity is a chord that "
                                                     "points out of the circle: @ % is left.",
                                                     Value(left, 2))},
            {"about half of it is lost", say("More: @ % is left.", Value(left, 2))},
            {"most of it is lost",
             say(R"(@ % is left. The velocity of a step is the chord just covered, which points out of the circle.
                 The next projection takes the outward part away, and with it about (ωh)² of the speed, where ω is the bob's angular velocity.)",
                 Value(left, 2))}},
       .answer = left > 90   ? 0
                 : left > 40 ? 1
                             : 2,
       .hints = {
           "From what does XPBD take the velocity?", "v = (x − x₀)/h, with x and x₀ on the circle",
           "A chord points outwards from the tangent at its end. What becomes of that part in the next step?"}});
  page.measure("XPBD, energy left", left, "%");
  const SimplePendulum exact(problem["angle"] * std::numbers::pi / 180, length, problem["gravity"]);
  std::vector<Swing> swings{
      {"XPBD", pictures::colour_of("XPBD"), problem, xpbd.setting({})},
      {"direct, β = 0.2", pictures::colour_of("direct"), problem, direct.setting(with_cure({}, Cure::baumgarte))},
      {"RATTLE", pictures::colour_of("RATTLE"), problem, rattle.setting({})}};
  const double start = problem.start().energy();
  page.sequence(
      "stable_and_wrong",
      say(R"(The first @ s of three stable methods at one step a frame. Dashed: the true motion. Right: the change of
          energy. At the top, XPBD's rod has the right length to rounding throughout.)",
          film_seconds),
      Seconds{film_seconds}, [=, chart = energies(swings, start)](renderer::Canvas& canvas, double time) mutable {
        for (Swing& swing : swings) swing.go_on(time, start);
        draw_swings(canvas, swings, chart, exact, length, time);
      });
  page.claim("XPBD, largest drift", once[Error::drift], "m",
             is_at_most(1e-6 * length, "C = 0 is solved by Newton's method"));
  page.claim("XPBD, energy lost all the same", once[Error::energy], "1",
             is_at_least(0.5, "stable is not accurate"));
  page.claim("RATTLE, largest drift", symmetric[Error::drift], "m",
             is_at_most(1e-12 * length, "C = 0 is solved to rounding"));
  page.claim("RATTLE, largest change of energy, over XPBD's", symmetric[Error::energy] / once[Error::energy], "1",
             is_at_most(0.01, "it swings about the true energy and keeps near it"));
  page.text(
      R"(So first decide which error your scene must not have. A rope bridge in a game must not come apart: drift. A
      clock must keep time: trajectory and energy. A crane must not break its bolts: the reaction force. The appendix
      draws a chart for each error, scene by scene.)");
}

}  // namespace byhand::accuracy
