// Part of step 2: a film of a walk along work–precision curves.

#include "lessons/09_what_accuracy_costs/walking_down.hpp"

#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/pictures/acts.hpp"

namespace byhand::accuracy {
namespace {

using Spot = renderer::Point;

constexpr int halvings = 4;

/// A method at one step: its place on the chart, and the bob at the end of each frame.
struct Walked {
  byhand::Point point;
  std::vector<Spot> bob;
};

Spot in_the_plane(const Eigen::Vector3d& p) { return {p.x(), p.y()}; }

Walked walked(const Problem& problem, const Family& family, const Knobs& knobs) {
  AnyScene scene = problem.start();
  const byhand::Setting setting = family.setting(knobs);
  scene.use(setting.method);
  Walked all{measure(problem, family, knobs), {in_the_plane(scene.placements()[1].position)}};
  for (long i = 0; i < std::lround(problem.compared_at() / frame); ++i) {
    for (int step = 0; step < setting.steps; ++step) scene.step(frame / setting.steps);
    all.bob.push_back(in_the_plane(scene.placements()[1].position));
  }
  return all;
}

/// The share of a logarithmic axis at which a value lies.
double on_axis(const std::pair<double, double>& range, double value) {
  return std::log(value / range.first) / std::log(range.second / range.first);
}

struct WalkFilm {
  pictures::Acts acts;
  std::array<std::vector<Walked>, 2> methods;  // by the halvings of the step
  std::array<Colour, 2> colours;
  std::vector<Spot> exact;  // the bob's true place at the end of each frame
  Chart chart;
  double length;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.56, 30, 0.8);
    const auto [above, below] = left.split_rows(0.45, 14);
    const std::size_t present = acts.now(time);
    const double share = acts.share(present, time);
    const auto now = static_cast<std::size_t>(std::lround(share * static_cast<double>(exact.size() - 1)));
    const auto [scene, lens] = above.split_columns(0.55, 16);
    canvas.look(fit({-1.1 * length, -1.1 * length, 2.2 * length, 1.3 * length}, scene, 6));
    canvas.path(exact, {palette::theory, 1.6, Dash::dotted});
    const Spot bob = methods[0][present].bob[now];
    pictures::draw(canvas, {.bobs = {{bob, 1}}, .rods = {{{0, 0}, bob}}, .anchors = {{0, 0}}});
    draw_lens(canvas, lens, present, now);

    canvas.look_at_page();
    const Rectangle inner = renderer::draw(canvas, chart, below);
    const ChartRanges over = ranges(chart);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto place = [&](std::size_t i) {
        const byhand::Point& point = methods[m][i].point;
        return Spot(inner.x + inner.width * on_axis(over.x, point[Error::trajectory]),
                    inner.y + inner.height * on_axis(over.y, point.cost));
      };
      const Spot from = place(present == 0 ? 0 : present - 1), at = from + share * (place(present) - from);
      canvas.disc(at, 9, {colours[m], {palette::ink, 2}});
    }
    acts.draw(canvas, right, time);
  }

  /// What is around the bob's true place, at one scale in all acts.
  void draw_lens(Canvas& canvas, const Rectangle& into, std::size_t act, std::size_t now) const {
    const double reach = 1.25 * methods[0][0].point[Error::trajectory];
    const Rectangle window{into.x, into.y + 30, into.width, into.height - 30};
    canvas.look_at_page();
    canvas.rectangle(window, {fade(palette::paper, 0), {palette::muted, 1.6}});
    Camera camera = fit({-reach, -reach, 2 * reach, 2 * reach}, window, 4);
    camera.centre = exact[now];
    canvas.look(camera);
    canvas.clip(window);
    canvas.path(exact, {palette::theory, 1.6, Dash::dotted});
    canvas.line(exact[now], methods[0][act].bob[now], {palette::error, 4});
    const double dot = 8 / camera.scale;
    canvas.disc(exact[now], dot, {palette::paper, {palette::theory, 2}});
    for (std::size_t m = methods.size(); m-- > 0;)
      canvas.disc(methods[m][act].bob[now], dot * (m == 0 ? 1 : 0.6), {colours[m], {palette::ink, 1.4}});
    canvas.clip({});
    canvas.look_at_page();
    const double bar = std::pow(10, std::floor(std::log10(reach)));
    const Spot end(window.right(), into.y + 12);
    canvas.line(end - Spot(bar * camera.scale, 0), end, {palette::ink, 2.5});
    canvas.text(end - Spot(bar * camera.scale + 8, 0), say("close-up of the bob; bar: @ mm", Value(1000 * bar, 2)),
                {.size = 16, .colour = palette::muted, .anchor = Anchor::right});
  }
};

}  // namespace

void walking_down(const Problem& problem, Page& page) {
  const std::array<const Family*, 2> families{&family_named("direct"), &family_named("RATTLE")};
  const std::array names{"symplectic Euler", "RATTLE"};
  WalkFilm film{.acts = pictures::Acts({}),
                .methods = {},
                .colours = {pictures::colour_of("direct"), pictures::colour_of("RATTLE")},
                .exact = {},
                .chart = {.x = {.label = "position error (m)", .scale = Scale::logarithmic},
                          .y = {.label = "cost (instructions per frame)", .scale = Scale::logarithmic}},
                .length = problem["length"]};
  const auto exact = problem.scene().exact(problem);
  for (long i = 0; i <= std::lround(problem.compared_at() / frame); ++i)
    film.exact.push_back(in_the_plane(exact(static_cast<double>(i) * frame).positions[0]));
  for (std::size_t m = 0; m < families.size(); ++m) {
    Curve curve{
        .label = names[m], .style = CurveStyle::line_and_markers, .place = pictures::place_of(families[m]->name)};
    for (int i = 0; i <= halvings; ++i) {
      Knobs knobs{.substeps = 1 << i};
      if (m == 0) knobs.cure = Cure::baumgarte, knobs.strength = 1;
      film.methods[m].push_back(walked(problem, *families[m], knobs));
      curve.x.push_back(film.methods[m].back().point[Error::trajectory]);
      curve.y.push_back(film.methods[m].back().point.cost);
    }
    film.chart.curves.push_back(std::move(curve));
  }
  std::vector<pictures::Acts::Act> acts;
  for (std::size_t i = 0; i <= halvings; ++i) {
    const auto error = [&](std::size_t m, std::size_t of) { return film.methods[m][of].point[Error::trajectory]; };
    const auto millimetres = [&](std::size_t m) { return Value(1000 * error(m, i), 2); };
    acts.push_back(
        {say("h = 1/@ s: Euler @ mm, RATTLE @ mm", 60 << i, millimetres(0), millimetres(1)),
         i == 0 ? say("Symplectic Euler (blue) and RATTLE (green), @ s: how far the bob is from its true place.",
                      problem.compared_at())
                : say("Half the step: the errors are divided by @ and @.", Value(error(0, i - 1) / error(0, i), 2),
                      Value(error(1, i - 1) / error(1, i), 2)),
         palette::ink});
  }
  film.acts = pictures::Acts(std::move(acts));
  const double seconds = film.acts.seconds();
  page.sequence(
      "walking_down",
      say(R"(A walk along two work–precision curves, from one step a frame to @. Above: the pendulum by symplectic
                    Euler, and a close-up of the bob's true place (grey) at a fixed scale.)",
          1 << halvings),
      Seconds{seconds}, [shown = std::move(film)](Canvas& canvas, double time) { shown.draw(canvas, time); });
}

}  // namespace byhand::accuracy
