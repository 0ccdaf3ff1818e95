// Step 5: stacks and walls, where standing is the whole question.

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
      R"(Contacts have bounds, and what should happen is simple: nothing. Ten boxes stand one upon the other; they
      are kicked a little (the topmost with @ m/s), because a stack that only looks settled does not survive it.
      The error is how far any box is from where it stood after @ s, its width being a metre: above about half of
      that the stack lies on the ground.)",
      stack["kick"], stack.scene().time);
  show(page, "stack_trajectory", column, Error::trajectory);
  page.text("Some methods stay away, and say why:\n" + failures(column));
  show(page, "stack_drift", column, Error::drift);

  const Survey& wall = survey(page, pyramid, Error::drift, 5e6);
  page.text(
      R"(A pyramid is another matter. It stands by its shape, so every method that sweeps at all holds it; loops
      fill the factor of a direct solve, which gets dearer; and what the methods differ in is how deep the boxes
      sink into one another.)");
  show(page, "pyramid_drift", wall, Error::drift);
  show_clocked(page, "pyramid_drift_clocked", wall, Error::drift);
  if (const std::string failed = failures(wall); !failed.empty())
    page.text("What cannot or fails here:\n" + failed);
  page.text(
      R"(The rule of lesson 3 stands on both charts: what has no loops (chains, columns) directly, the rest by
      sweeps, and by conjugate ones if it is large.)");

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
       .source = "law B18: fewer sweeps than it takes, so it falls",
       .measured = swept->points.front().has(Error::trajectory) ? swept->points.front()[Error::trajectory] : 1e9,
       .tolerance = at_least()});
}

}  // namespace byhand::accuracy
