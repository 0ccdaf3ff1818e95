// Step 5: stacks and pyramids, which have to stand before any error of theirs counts.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

void contacts(Page& page) {
  const Problem stack("stack", {{"boxes", 10}, {"kick", 0.02}}), pyramid("pyramid", {{"base", 6}, {"kick", 0.02}});
  const std::vector<Error> watched{Error::drift, Error::trajectory, Error::contact};
  constexpr double most_of_stack = 1.5e5, most_of_pyramid = 3e5;  // instructions per frame
  const Survey &column = survey(page, stack, watched, most_of_stack, 80),
               &wall = survey(page, pyramid, watched, most_of_pyramid, 50);
  page.text(
      R"(Contacts have bounds, and here the right motion is simple: none. Ten boxes stand on each other and are kicked,
      the top at @ m/s and each other in proportion to its height: a stack that only looks stable does not survive that. A fallen stack has few
      contacts left and is cheap, so a run counts only if, for @ s, every box stays within half a box of its place. The
      error is then the largest distance of a box from its place after @ s.)",
      stack["kick"], stack.scene().duration, stack.scene().time);
  show(page, "stack_trajectory", column, Error::trajectory);
  const auto ended = [](const Survey& survey, double most) {
    return say("How the runs ended (cost limit: @ instructions per frame):\n", most) + failures(survey);
  };
  page.text(ended(column, most_of_stack));

  int swept = 0, standing = 0, regularised = 0;
  for (const byhand::Point& point : wall.points()) {
    regularised +=
        point.family->name == "direct" && point.knobs.regularisation > 0 && point.outcome != Outcome::too_slow;
    if (point.family->name == "Gauss–Seidel" && point.outcome != Outcome::too_slow) {
      ++swept;
      standing += point.outcome == Outcome::good;
    }
  }
  page.text(
      R"(A pyramid stands by its shape: of the @ Gauss–Seidel runs within the cost limit, @ hold it. The methods differ in how deep the boxes
      sink into one another, and in cost. The loops of the pyramid fill the factor of a direct solve, and its rows
      are redundant, so the solve needs regularisation@.)",
      swept, standing, regularised == 0 ? "; with it, it costs more than the limit here" : "");
  show(page, "pyramid_drift", wall, Error::drift);
  page.text(ended(wall, most_of_pyramid));
  std::vector<std::string_view> others;
  for (const Family& family : families())
    if (family.name != "direct") others.push_back(family.name);
  const double at = 1e-3, column_direct = least_cost(page, column, Error::trajectory, at, {"direct"}),
               column_other = least_cost(page, column, Error::trajectory, at, others),
               wall_direct = least_cost(page, wall, Error::drift, at, {"direct"}),
               wall_other = least_cost(page, wall, Error::drift, at, others);
  const auto compared = [](double direct, double other) {
    if (!std::isfinite(direct) && !std::isfinite(other)) return std::string("no method on the chart will do");
    if (!std::isfinite(direct))
      return say(
          "the direct solve does not do it within the limit, and the best other method costs @ instructions per "
          "frame",
          Value(other, 3));
    if (!std::isfinite(other))
      return say("only the direct solve will do, for @ instructions per frame", Value(direct, 3));
    return direct < other
               ? say("the direct solve costs @ instructions per frame, the best other method @ times as much",
                     Value(direct, 3), Value(other / direct, 2))
               : say("the direct solve costs @ times as much as the best other method", Value(direct / other, 2));
  };
  page.text(
      R"(To keep the stack in its place within a millimetre, @. To keep the pyramid's boxes from sinking deeper than
      that, @. @)",
      compared(column_direct, column_other), compared(wall_direct, wall_other),
      page.verdict(
          {{.when = where(Quantity("stack: direct over others", column_direct / column_other) < 1,
                          Quantity("pyramid: others over direct", wall_other / wall_direct) < 1),
            .say =
                R"(In these two scenes that agrees with the rule of lesson 3: solve systems without loops directly, the others
                         by sweeps.)"}}));

  const Knobs whole = with_cure({}, Cure::baumgarte);
  const byhand::Point once = measure(stack, family_named("direct"), whole),
                      swept_once = measure(stack, family_named("Gauss–Seidel"), {});
  page.claim("the stack, solved directly in one step a frame: farthest box",
             once.has(Error::trajectory) ? once[Error::trajectory] : INFINITY, "m", is_at_most(0.01, "it stands"));
  page.claim("the stack, one sweep a frame: when a box has left its place by half a box",
             swept_once.outcome == Outcome::fell ? swept_once.seconds : INFINITY, "s",
             is_at_most(stack.scene().duration, "law of creep (lesson 8): too few sweeps, so it falls"));
  page.claim("the stack at a millimetre: cost of the best other method, over the direct solve",
             column_other / column_direct, "1", is_at_least(1, "a column has no loops (lesson 3)"),
             Condition{std::isfinite(column_other), "stacks where another method reaches it"});
}

}  // namespace byhand::accuracy
