// Step 7: ask the program.

#include "lessons/09_what_accuracy_costs/catalogue/chooser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {
namespace {

using namespace tutor;

constexpr std::size_t shown = 5;  // runners-up

/// The scene that is asked about, with those of the numbers that it has.
Problem problem_of(const Setting& setting) {
  const std::string name = setting.scene;
  const Values numbers{{"links", setting.links()}, {"end_mass", setting.end_mass()},
                       {"mass", setting.mass()},   {"length", setting.length()},
                       {"boxes", setting.boxes()}, {"top_mass", setting.top_mass()},
                       {"base", setting.base()},   {"kick", 0.02}};  // or a stack that merely looks settled stands
  Values values;
  for (const SceneParameter& parameter : named_scene(name).parameters)
    if (const auto found = numbers.find(parameter.name); found != numbers.end()) values.insert(*found);
  return Problem(name, values);
}

/// What is asked for, and what of it is set aside.
struct Question {
  Wish wish;
  std::vector<std::string> aside = {};
};

/// Drift, unless another error is named; of several the first one.
Question question_of(const Setting& setting) {
  Question question{{.error = Error::drift, .accuracy = setting.drift()}};
  Wish& wish = question.wish;
  for (const auto& [error, bound] :
       {std::pair{Error::trajectory, setting.trajectory()}, std::pair{Error::energy, setting.energy()},
        std::pair{Error::momentum, setting.momentum()}, std::pair{Error::reaction, setting.reaction()}}) {
    if (bound == 0) continue;
    if (wish.error != Error::drift)
      question.aside.emplace_back(name_of(error));
    else
      wish.error = error, wish.accuracy = bound;
  }
  if (setting.budget() > 0) {
    wish.accuracy = NAN;
    wish.budget = 1e9 * setting.budget();
    wish.cost = Cost::wall_time;
  }
  return question;
}

/// Whether the scene has that error at all.
bool is_defined(Error error, const NamedScene& scene) {
  return (error != Error::energy || scene.keeps_energy) && (error != Error::momentum || scene.keeps_spin);
}

std::string unit(Error error) { return unit_of(error) == "1" ? "" : " " + std::string(unit_of(error)); }

/// "a drift", "an energy".
std::string article(const std::string& error) { return (error.front() == 'e' ? "an " : "a ") + error; }

std::string error_in_words(const byhand::Point& point, Error error) {
  if (point[error] < 1e-11) return say("@ of rounding only", std::string(name_of(error)));
  return say("@ of @@", std::string(name_of(error)), Value(point[error], 2), unit(error));
}

std::string cost_in_words(const byhand::Point& point, Cost cost) {
  if (cost == Cost::wall_time) return say("@ µs a frame", Value(point.nanoseconds / 1000, 3));
  return point.row_solves == 1 ? "1 row-solve a frame" : say("@ row-solves a frame", Value(point.row_solves, 4));
}

renderer::Chart chart_of(const byhand::Choice& choice, const Problem& problem, const Wish& wish) {
  using namespace renderer;
  Chart chart{.title = title_of(problem),
              .x = {.label = say("@@", std::string(name_of(wish.error)),
                                 unit_of(wish.error) == "1" ? "" : say(" (@)", std::string(unit_of(wish.error)))),
                    .scale = Scale::logarithmic},
              .y = {.label = wish.cost == Cost::wall_time ? "cost (µs a frame)" : "cost (row-solves a frame)",
                    .scale = Scale::logarithmic}};
  const auto add = [&](const byhand::Point& point, const std::string& label) {
    const double cost = cost_of(point, wish.cost);
    chart.curves.push_back({.label = label,
                            .x = {std::max(point[wish.error], 1e-16)},
                            .y = {wish.cost == Cost::wall_time ? cost / 1000 : cost},
                            .style = CurveStyle::markers,
                            .point_labels = {std::to_string(point.knob)}});
  };
  add(choice.best, choice.best.described());
  for (std::size_t i = 0; i < std::min<std::size_t>(choice.runners_up.size(), shown); ++i)
    if (choice.runners_up[i].has(wish.error)) add(choice.runners_up[i], choice.runners_up[i].described());
  if (choice.finer) add(*choice.finer, "a tenth: " + choice.finer->described());
  if (std::isfinite(wish.accuracy))
    chart.references.push_back(
        {.axis = renderer::Reference::Across::x, .value = wish.accuracy, .label = "asked for"});
  else
    chart.references.push_back(
        {.axis = renderer::Reference::Across::y, .value = wish.budget / 1000, .label = "budget"});
  return chart;
}

std::string runners_up(const byhand::Choice& choice, const Wish& wish) {
  std::string lines;
  for (std::size_t i = 0; i < std::min<std::size_t>(choice.runners_up.size(), shown); ++i) {
    const byhand::Point& point = choice.runners_up[i];
    const double times = cost_of(point, wish.cost) / cost_of(choice.best, wish.cost);
    const bool misses = std::isfinite(wish.accuracy) && !(point[wish.error] <= wish.accuracy);
    lines += say("\n- @: @ for @ (×@)@", point.described(), error_in_words(point, wish.error),
                 cost_in_words(point, wish.cost), Value(times, 2), misses ? ", which misses your target" : "");
  }
  return lines;
}

std::string passed(const byhand::Choice& choice) {
  std::string lines;
  for (const byhand::Point& point : choice.passed)
    lines += fmt::format("\n- {}: {}", point.configuration->name, point.reason);
  return lines;
}

std::string margin_in_words(const byhand::Choice& choice, const Problem& problem) {
  const std::string& stress = problem.scene().stress;
  if (std::isinf(choice.margin)) return say("It still does with the largest @ that this scene may have.", stress);
  return say("It no longer does if @ is @ times as large (@).", stress, Value(choice.margin, 2),
             Value(choice.margin * problem[stress], 3));
}

}  // namespace

void chooser(Page& page, const Setting& setting) {
  const Problem problem = problem_of(setting);
  const auto [wish, aside] = question_of(setting);
  const bool by_budget = std::isfinite(wish.budget);
  const std::string error(name_of(wish.error));
  page.text(
      R"(No chart answers for *your* scene, but the program does. It runs every method on it, doubles each knob until the
      error is small enough, bisects in between, and recommends what it has run.)");
  if (!aside.empty())
    page.text("You ask for several errors. The program looks for one at a time, here the @; it sets aside: @.",
              error, fmt::format("{}", fmt::join(aside, ", ")));
  if (!is_defined(wish.error, problem.scene())) {
    page.text("Here the program has no answer: @ is not conserved by a @, so it has no such error.", error,
              problem.scene().title);
    return;
  }
  page.text(
      by_budget
          ? say("**You ask:** @. Which method has the least @ error within @ µs a frame by this machine's clock?",
                description(problem), error, setting.budget() * 1e6)
          : say("**You ask:** @. Which is the cheapest method with @ error of at most @@?", description(problem),
                article(error), wish.accuracy, unit(wish.error)));
  const byhand::Choice choice = choose(problem, wish);
  const byhand::Point& best = choice.best;

  if (choice.reached) {
    page.text("**Answer:** @: @ for @. @", best.described(), error_in_words(best, wish.error),
              cost_in_words(best, wish.cost), margin_in_words(choice, problem));
    if (const std::string others = runners_up(choice, wish); !others.empty()) page.text("Runners-up:\n" + others);
    if (choice.finer && cost_of(*choice.finer, wish.cost) <= cost_of(best, wish.cost))
      page.text("It is already ten times more accurate than you ask.");
    else if (choice.finer)
      page.text("Ten times more accuracy would cost @ times as much: @, @.",
                Value(cost_of(*choice.finer, wish.cost) / cost_of(best, wish.cost), 2), choice.finer->described(),
                error_in_words(*choice.finer, wish.error));
    else if (!by_budget)
      page.text("No method here is ten times more accurate.");
  } else if (best.has(wish.error)) {
    page.text(by_budget ? "**No method runs within that budget.** The nearest is @: @ for @."
                        : "**No method here reaches that.** The nearest is @: @ for @.",
              best.described(), error_in_words(best, wish.error), cost_in_words(best, wish.cost));
  } else {
    page.text("**No method here reaches that:** none ran this scene to its end.");
  }
  if (const std::string out = passed(choice); !out.empty())
    page.text("Methods that cannot do this scene or failed:\n" + out);

  const std::string caption =
      R"(The best run of each method; the labels are the values of its knob. Runs left of the dotted line, or below it,
      reach the target.)";
  if (best.has(wish.error)) {
    if (by_budget)
      page.clocked("choice", caption, [=] { return chart_of(choice, problem, wish); });
    else
      page.figure("choice", caption, chart_of(choice, problem, wish));
    if (best[wish.error] >= 1e-11)
      page.measure("error of what is recommended", best[wish.error], std::string(unit_of(wish.error)));
    page.measure("its row-solves a frame", best.row_solves, "1");
  }

  const byhand::Point again = measure(problem, *best.configuration, best.knob, best.tuning);
  page.claim({.quantity = error + " of what is recommended, run again",
              .unit = std::string(unit_of(wish.error)),
              .expected = by_budget ? best[wish.error] : wish.accuracy,
              .source = by_budget ? "the same run" : "asked for",
              .measured = again.has(wish.error) ? again[wish.error] : INFINITY,
              .tolerance = at_most(),
              .claimed = choice.reached,
              .range = "if the target was reached"});
  if (choice.finer)
    page.claim({.quantity = error + " of the finer one",
                .unit = std::string(unit_of(wish.error)),
                .expected = wish.accuracy / 10,
                .source = "a tenth of what was asked for",
                .measured = (*choice.finer)[wish.error],
                .tolerance = at_most()});
  page.text(
      R"(Ask again for your own scene: any scene of this lesson by name, any error (`drift`, `trajectory`, `energy`,
      `momentum`, `reaction`), or a `budget` of time a frame, such as 200us.)");
}

}  // namespace byhand::accuracy
