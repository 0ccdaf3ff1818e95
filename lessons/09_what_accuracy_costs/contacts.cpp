// Step 6: stacks and pyramids, where the question is whether they stand.

#include <cmath>

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void contacts(Page& page) {
  const Problem stack("stack", {{"boxes", 10}, {"kick", 0.02}}),
      pyramid("pyramid", {{"base", 10}, {"kick", 0.02}});
  const Survey& column = survey(page, stack, Error::trajectory);
  page.text(
      R"(Contacts have bounds, and the right motion is simple: none. Ten boxes stand on each other and get a slight push
      (the topmost @ m/s), because a stack that only looks settled does not survive one. The error is the largest
      distance of a box from its place after @ s. The boxes are a metre wide: with an error of more than about half a
      metre the stack has fallen.)",
      stack["kick"], stack.scene().time);
  show(page, "stack_trajectory", column, Error::trajectory);
  page.text("Methods that cannot do contacts, and runs that failed:\n" + failures(column));
  show(page, "stack_drift", column, Error::drift);

  const Survey& wall = survey(page, pyramid, Error::drift, 5e6);
  const auto sweeps = [](const Configuration& c) {
    return c.knob == "sweeps" && c.name.find("gradient") == c.name.npos;
  };
  int swept_runs = 0, standing = 0;
  for (const byhand::Point& point : wall.points())
    if (sweeps(*point.configuration) && point.has(Error::trajectory)) {
      ++swept_runs;
      standing += point[Error::trajectory] < 0.5;
    }
  page.text(
      R"(A pyramid stands by its shape: @ runs by sweeps hold it@. The methods differ in how deep the boxes sink into
      one another, and in cost: the loops of the pyramid fill the factor of a direct solve.)",
      standing == swept_runs ? say("all @", swept_runs) : say("@ of the @", standing, swept_runs),
      standing == swept_runs ? "" : ", and in the others a box ends more than half a metre from its place");
  show(page, "pyramid_drift", wall, Error::drift);
  show_clocked(page, "pyramid_drift_clocked", wall, Error::drift);
  if (const std::string failed = failures(wall); !failed.empty())
    page.text("Methods that cannot do contacts, and runs that failed:\n" + failed);
  const auto cheapest = [&](const Survey& survey, Error error, bool direct_ones) {
    return least_cost(survey, error, 1e-3, [=](const Configuration& c) {
      return direct_ones ? c.name.starts_with("direct") : !c.name.starts_with("direct");
    });
  };
  const double column_direct = cheapest(column, Error::trajectory, true),
               column_other = cheapest(column, Error::trajectory, false),
               wall_direct = cheapest(wall, Error::drift, true), wall_other = cheapest(wall, Error::drift, false);
  const auto compared = [](double direct, double other) {
    if (!std::isfinite(direct)) return std::string("no direct solve on the chart reaches that");
    if (!std::isfinite(other)) return std::string("only the direct solve reaches that");
    return direct < other
               ? say("the direct solve costs @ row-solves, the best other method @ times as much",
                     Value(direct, 3), Value(other / direct, 2))
               : say("the direct solve costs @ times as much as the best other method", Value(direct / other, 2));
  };
  page.text(
      R"(To keep the stack in its place within a millimetre, @. To keep the pyramid's boxes from sinking deeper than
      that, @. That agrees with the rule of lesson 3: scenes without loops (chains, columns) directly, others by
      sweeps, large ones by conjugate sweeps.)",
      compared(column_direct, column_other), compared(wall_direct, wall_other));

  const Series* direct = column.find("direct, substeps");
  if (direct && !direct->points.empty()) {
    const byhand::Point& once = direct->points.front();
    page.claim({.quantity = "the stack, solved directly in one step a frame: farthest box",
                .unit = "m",
                .expected = 0.01,
                .source = "it stands",
                .measured = once.has(Error::trajectory) ? once[Error::trajectory] : INFINITY,
                .tolerance = at_most()});
  }
  const Series* swept = column.find("Gauss–Seidel, sweeps");
  page.claim(
      {.quantity = "the stack, one sweep a frame: farthest box",
       .unit = "m",
       .expected = 0.5,
       .source = "law of creep (lesson 8): too few sweeps, so it falls",
       .measured = swept->points.front().has(Error::trajectory) ? swept->points.front()[Error::trajectory] : 1e9,
       .tolerance = at_least()});
  page.claim({.quantity = "the stack at a millimetre: cost of the best other method, over the direct solve",
              .unit = "1",
              .expected = 1,
              .source = "a column has no loops (lesson 3)",
              .measured = column_other / column_direct,
              .tolerance = at_least(),
              .claimed = std::isfinite(column_other),
              .range = "another method reaches it"});
}

}  // namespace byhand::accuracy
