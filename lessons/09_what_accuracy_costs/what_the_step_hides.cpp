// Step 4: the plateau: rows that are solved ever better, in a step that stays as wrong as it is.

#include <cmath>

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void what_the_step_hides(Page& page) {
  const Problem problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}});
  const Configuration& sweeps = configuration_named("Gauss–Seidel, sweeps");
  const double beta = 0.2;
  const std::vector<int> counts{1, 2, 4, 8, 16, 32, 64, 256, 1024, 10000};
  const auto points = page.side_by_side(static_cast<int>(counts.size()), [&](int i) {
    return measure(problem, sweeps, counts[static_cast<std::size_t>(i)], beta, {.algebraic = true});
  });
  const byhand::Point &some = points[6], &many = points.back();
  const byhand::Point exact = measure(problem, configuration_named("direct, substeps"), 1, beta);

  page.predict(
      {.ask = say(R"(A double pendulum, one step a frame, @ sweeps in each, and its trajectory is @ m off after @
                  s. With @ sweeps: how far off?)",
                  some.knob, Value(some[Error::trajectory], 3), problem.scene().time, many.knob),
       .answer = many[Error::trajectory],
       .unit = "m",
       .tolerance = 0.03 * some[Error::trajectory],
       .wrong = {{0, "The rows are solved to rounding then. The step is still as long as it was."},
                 {some[Error::trajectory] * std::sqrt(static_cast<double>(some.knob) / many.knob),
                  "Sweeps do not buy time: after a few the rows are as good as solved."}},
       .hints = {"What would a direct solve of the same step give?"},
       .right = say(R"(The plateau is the step's own error; the direct solve of the same steps is @ m off. Change
                    h, not the sweeps.)",
                    Value(exact[Error::trajectory], 4))});
  renderer::Chart chart{.title = title_of(problem) + "; one step a frame",
                        .x = {.label = "sweeps a step", .scale = renderer::Scale::logarithmic},
                        .y = {.label = "error (m, m/s)", .scale = renderer::Scale::logarithmic}};
  renderer::Curve algebraic{.label = "algebraic (m/s)", .style = renderer::CurveStyle::line_and_markers},
      trajectory{.label = "trajectory (m)", .style = renderer::CurveStyle::line_and_markers};
  for (const byhand::Point& point : points) {
    algebraic.x.push_back(point.knob), trajectory.x.push_back(point.knob);
    algebraic.y.push_back(std::max(point[Error::algebraic], 1e-16));
    trajectory.y.push_back(point[Error::trajectory]);
  }
  chart.curves = {algebraic, trajectory};
  chart.references = {{.axis = renderer::Reference::Across::y,
                       .value = exact[Error::trajectory],
                       .label = "trajectory, solved directly"}};
  page.figure(
      "plateau",
      R"(More sweeps a step. The rows end up solved to rounding; the trajectory stops where the direct solve of the
      same steps is, and stays.)",
      chart);
  page.text(
      R"(The first few sweeps buy motion, the rest only digits of an answer to the wrong question. On a
      work–precision chart this is a curve that turns straight up. It is also why a comparison by residuals alone
      tells you nothing about a simulation. The cure is in the step: cut it, or take one of a higher order. And the
      error of a step has a sign, so that two of them may cancel: β = @ may beat β = 1 in the angle and lose in the
      energy.)",
      beta);
  page.claim({.quantity = say("trajectory, @ sweeps over @", many.knob, some.knob),
              .unit = "1",
              .expected = 1,
              .source = "the step's own error",
              .measured = many[Error::trajectory] / some[Error::trajectory],
              .tolerance = relative(0.03)});
  page.claim({.quantity = say("trajectory, @ sweeps", many.knob),
              .unit = "m",
              .expected = exact[Error::trajectory],
              .source = "direct solve of the same steps",
              .measured = many[Error::trajectory],
              .tolerance = relative(1e-6)});
}

}  // namespace byhand::accuracy
