// Deeper: the plateau: rows are solved better and better, but the error of the step stays.

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

void what_the_step_hides(Page& page) {
  const Problem problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}});
  const Family& sweeps = family_named("Gauss–Seidel");
  const double beta = 0.2;
  const std::vector<int> counts{1, 2, 4, 8, 16, 32, 64, 256, 1024, 10000};
  const auto points = page.side_by_side(static_cast<int>(counts.size()), [&](int i) {
    return measure(problem, sweeps,
                   {.passes = counts[static_cast<std::size_t>(i)], .cure = Cure::baumgarte, .strength = beta},
                   {.algebraic = true});
  });
  const byhand::Point &some = points[6], &many = points.back();
  const byhand::Point exact =
      measure(problem, family_named("direct"), {.cure = Cure::baumgarte, .strength = beta});

  const byhand::Point& one = points.front();
  const double divided = one[Error::trajectory] / many[Error::trajectory];
  page.choose(
      {.ask =
           say(R"(With @ sweep a step, a double pendulum is @ m off its trajectory after @ s. By what factor do @
                  sweeps a step reduce that?)",
               one.knobs.passes, Value(one[Error::trajectory], 2), problem.scene().time, many.knobs.passes),
       .options =
           {{"1 (not at all)",
             say(R"(@: this is the error of the step. The direct solve of the same steps is @ m off. Change h,
                        not the sweeps.)",
                 divided < 1 ? "It even grows a little" : "Hardly at all", Value(exact[Error::trajectory], 4))},
            {"100", "The error of the solver falls so. But most of this is the error of the step."},
            {"10 000", "The rows are solved to rounding then. But the step is as long as before."}},
       .answer = divided < 10     ? 0
                 : divided < 1000 ? 1
                                  : 2,
       .hints = {"What would a direct solve of the same steps give?",
                 "error = error of the solver + error of the step",
                 "A warm start has made the first small already."}});
  renderer::Chart chart{.title = title_of(problem) + "; one step a frame",
                        .x = {.label = "sweeps a step", .scale = renderer::Scale::logarithmic},
                        .y = {.label = "error (m, m/s)", .scale = renderer::Scale::logarithmic}};
  renderer::Curve algebraic{.label = "algebraic (m/s)", .style = renderer::CurveStyle::line_and_markers},
      trajectory{.label = "trajectory (m)", .style = renderer::CurveStyle::line_and_markers};
  for (const byhand::Point& point : points) {
    algebraic.x.push_back(point.knobs.passes), trajectory.x.push_back(point.knobs.passes);
    algebraic.y.push_back(std::max(point[Error::algebraic], 1e-16));
    trajectory.y.push_back(point[Error::trajectory]);
  }
  chart.curves = {algebraic, trajectory};
  chart.references = {{.axis = renderer::Reference::Across::y,
                       .value = exact[Error::trajectory],
                       .label = "trajectory, solved directly"}};
  page.figure(
      "plateau",
      R"(Errors over the sweeps in a step. In the end the rows are solved to rounding; the trajectory stays as wrong as
      that of the direct solve.)",
      chart);
  const double change = std::abs(points.front()[Error::trajectory] / exact[Error::trajectory] - 1);
  page.text(
      R"(With @ sweep a step the trajectory's error is already within @ % of the direct solve's: a warm start does the
      rest. All further sweeps only solve better a step that is itself wrong. On a work–precision chart such a curve
      turns straight up. So residuals alone do not compare simulations. What helps is a shorter step or a method of
      higher order.)",
      points.front().knobs.passes, Value(100 * change, 2));
  page.claim(say("trajectory, @ sweeps over @", many.knobs.passes, some.knobs.passes),
             many[Error::trajectory] / some[Error::trajectory], "1",
             is(1, "the step's own error", relative(0.03)));
  page.claim(say("trajectory, @ sweeps", many.knobs.passes), many[Error::trajectory], "m",
             is(exact[Error::trajectory], "direct solve of the same steps", relative(1e-6)));
}

}  // namespace byhand::accuracy
