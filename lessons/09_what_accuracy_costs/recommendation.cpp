// Step 7: ask the program.

#include "lessons/catalogue/chooser.hpp"

#include <fmt/format.h>

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/catalogue/code.hpp"
#include "lessons/catalogue/tidy.hpp"
#include "lessons/catalogue/tuning.hpp"

namespace byhand::accuracy {
namespace {

constexpr std::size_t shown = 4;  // runners-up
constexpr double finest = 1e-11;  // of errors other than drift: less is rounding

/// The scene that is asked about, and what was set that it does not have.
struct Asked {
  Problem problem;
  std::vector<std::string> ignored;
};

Asked problem_of(const Setting& setting) {
  const std::string name = setting.scene;
  struct Number {
    const char* name;
    double value, initial;
  };
  const std::vector<Number> numbers{{"links", static_cast<double>(setting.links()), Initial::links},
                                    {"end_mass", setting.end_mass(), Initial::end_mass},
                                    {"mass", setting.mass(), Initial::mass},
                                    {"length", setting.length(), Initial::length},
                                    {"boxes", static_cast<double>(setting.boxes()), Initial::boxes},
                                    {"top_mass", setting.top_mass(), Initial::top_mass},
                                    {"base", static_cast<double>(setting.base()), Initial::base},
                                    {"kick", 0.02, 0.02}};  // or a stack that merely looks settled stands
  Values values;
  std::vector<std::string> ignored;
  for (const Number& number : numbers) {
    const auto& has = named_scene(name).parameters;
    if (std::any_of(has.begin(), has.end(), [&](const SceneParameter& one) { return one.name == number.name; }))
      values[number.name] = number.value;
    else if (number.value != number.initial)
      ignored.emplace_back(number.name);
  }
  return {Problem(name, values), ignored};
}

/// All errors that are limited; 1 mm of drift where nothing is asked for.
std::map<Error, double> limits_of(const Setting& setting) {
  std::map<Error, double> limits;
  for (const auto& [error, limit] :
       {std::pair{Error::drift, setting.drift()}, std::pair{Error::trajectory, setting.trajectory()},
        std::pair{Error::energy, setting.energy()}, std::pair{Error::momentum, setting.momentum()},
        std::pair{Error::reaction, setting.reaction()}})
    if (limit > 0) limits[error] = limit;
  if (limits.empty() && setting.budget() == 0) limits[Error::drift] = 1e-3;
  return limits;
}

std::string unit(Error error) { return unit_of(error) == "1" ? "" : " " + std::string(unit_of(error)); }

bool is_length(Error error) { return error == Error::drift || error == Error::trajectory; }

/// "a drift", "an energy".
std::string with_article(Error error) {
  const std::string name(name_of(error));
  return (name.front() == 'e' ? "an " : "a ") + name;
}

/// "a drift error of at most 0.001 m and an energy …".
std::string asked_for(const std::map<Error, double>& limits, const Problem& problem) {
  std::string text;
  for (const auto& [error, limit] : limits)
    text += say("@@ error of at most @@@", text.empty() ? "" : " and ", with_article(error), limit, unit(error),
                needs_truth(error) ? say(" at @ s", Value(problem.compared_at(), 3)) : "");
  return text;
}

std::string in_words(double value, Error error) {
  if (value < finest) return "rounding only";
  return say("@@", Value(value, 2), unit(error));
}

std::string cost_in_words(const byhand::Point& point) {
  return say("@ instructions per frame", Value(point.cost, 3));
}

/// Errors over the asked limit, of a candidate's run.
std::string reached_in_words(const byhand::Point& point, const std::map<Error, double>& limits) {
  std::string text;
  for (const auto& [error, limit] : limits)
    if (point.has(error))
      text += say("@@ @", text.empty() ? "" : ", ", std::string(name_of(error)), in_words(point[error], error));
  return text;
}

/// What law 18 asks of plain sweeps, and what this run has.
std::string law_18(const LawLimit& limit, const Knobs& knobs) {
  const double worth = static_cast<double>(knobs.passes) * knobs.substeps * knobs.substeps;
  return say("Law 18: sweeps × substeps² must exceed @; here that is @@", limit.number, worth,
             limit.sweeps == 1 || worth >= limit.sweeps ? std::string()
             : knobs.relaxation != 1                    ? say(", enough with ω = @", Value(knobs.relaxation, 3))
                                                        : std::string(", and the stack stood all the same"));
}

/// What the scene's law says of it.
std::string by_law(const LawLimit& limit, const byhand::Point& best) {
  if (limit.law == 7)
    return limit.substeps == 1
               ? say("Law 7 alone would allow one step a frame (@, where 1 is the limit)", limit.number)
               : say("Law 7 estimates @ (@ at one step a frame, where 1 is the limit)@",
                     several(limit.substeps, "substep"), limit.number,
                     best.knobs.substeps < limit.substeps ? "; the run held with fewer" : "");
  if (limit.law == 18)
    return best.family->exact
               ? say("Law 18 asks sweeps for more than @; by law 20 an exact solve holds any column", limit.number)
               : law_18(limit, best.knobs);
  if (limit.law == 13)
    return say("Law 13: at one step a frame it turns by @ a step, and the error grows with that angle",
               limit.number);
  return "No law of lesson 8 limits this scene; the answer was found by runs alone";
}

/// Why the recommended run is not cheaper, by its law's number and by runs.
std::string why(const byhand::Choice& choice, const std::map<Error, double>& limits) {
  std::string text = by_law(choice.limit, choice.best.point);
  if (choice.coarser) {
    const byhand::Point& coarser = *choice.coarser;
    text +=
        say(". In the run with @: @", several(coarser.knobs.substeps, "substep"),
            coarser.outcome != Outcome::good ? coarser.reason
            : limits.empty()                 ? cost_in_words(coarser)
                                             : reached_in_words(coarser, limits) +
                                   (excess(coarser, limits) <= 1 ? ", but not from all initial conditions" : ""));
  }
  return text;
}

/// What else this run gets wrong, and how badly.
void show_errors(Page& page, const byhand::Point& best, const Problem& problem, bool asked) {
  std::vector<std::vector<std::string>> rows;
  std::string warnings;
  for (const Error error : errors) {
    if (!best.has(error)) continue;
    const double bad = is_length(error) ? problem.size() / 10 : 0.1;
    rows.push_back({std::string(name_of(error)), in_words(best[error], error), best[error] > bad ? "bad" : ""});
    if (best[error] > bad) warnings += say("@@", warnings.empty() ? "" : ", ", std::string(name_of(error)));
  }
  page.table({"error of this run", "how much", ""}, rows);
  if (!warnings.empty())
    page.text("**Warning:** it @, but is bad in: @. Set limits for these too if they matter.",
              asked ? "meets your limits" : "has the least drift found", warnings);
}

std::string runners_up(const byhand::Choice& choice, const std::map<Error, double>& limits) {
  std::string lines;
  for (std::size_t i = 0; i < std::min(choice.runners_up.size(), shown); ++i) {
    const auto& [reached, point, excess] = choice.runners_up[i];
    if (!reached) continue;
    lines += say("\n- @: @ (×@)@", point.described(), cost_in_words(point),
                 Value(point.cost / choice.best.point.cost, point.cost < 2 * choice.best.point.cost ? 3 : 2),
                 limits.empty() ? say(", drift @", in_words(point[Error::drift], Error::drift)) : "");
  }
  return lines;
}

std::string passed(const byhand::Choice& choice) {
  std::string lines;
  for (const byhand::Point& point : choice.passed)
    if (point.outcome == Outcome::refused) lines += fmt::format("\n- {}: {}", point.family->name, point.reason);
  return lines;
}

/// A parameter's name without underscores.
std::string in_prose(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string margin_in_words(const byhand::Choice& choice, const Problem& problem, bool limited) {
  const std::string &stress = problem.scene().stress, name = in_prose(stress);
  if (std::isnan(choice.margin)) return "";
  if (!limited && choice.best.point[Error::drift] <= finest_drift) return "";  // twice of rounding is no limit
  if (std::isinf(choice.margin))
    return say("It still holds at the largest @ that was tried, up to a thousand times the present one.", name);
  const auto& all = problem.scene().parameters;
  const std::string unit =
      std::find_if(all.begin(), all.end(), [&](const SceneParameter& one) { return one.name == stress; })->unit;
  return say(
      "Of larger values of the @, tried @, the first at which it no longer meets @ is @@, @. Between these values "
      "it was not tried.",
      name, strides_of_margin, limited ? "your limits" : "twice this drift",
      Value(choice.margin * problem[stress], 3),
      unit == "1"   ? ""
      : unit == "°" ? unit
                    : " " + unit,
      choice.margin < 1.1 ? say("@ % above its present value", Value(100 * (choice.margin - 1), 1))
                          : say("@ times the present value", Value(choice.margin, 2)));
}

/// "all methods were tried up to 370 000 instructions per frame, …". The others have no time left where the exact
/// ones took it.
std::string searched_in_words(const byhand::Choice& choice) {
  const auto up_to = [](double cost) {
    return std::isinf(cost) ? std::string("within the time that you allow")
                            : say("up to @ instructions per frame", Value(cost, 2));
  };
  const std::string exactly = "XPBD and those that solve each step exactly",
                    until = up_to(choice.searched_exactly);
  if (choice.searched == 0) return say("only @ were tried, @", exactly, until);
  return say("all methods were tried @@", up_to(choice.searched),
             choice.searched_exactly > choice.searched ? say(", and @ @", exactly, until) : std::string());
}

/// Some forty seconds of two cores [instructions].
constexpr double most_of_a_search = 6e11;

/// How sure the answer is: where all of n starts go well, with 95 % confidence a share above 0.05^(1/n) of them
/// does.
std::string certainty(const byhand::Choice& choice, const std::map<Error, double>& limits) {
  const Verification& verified = choice.verified;
  std::string text =
      say("Verified: run for @ s from @ initial conditions, its own and others within 5 % of it, it @ in all.",
          verified.seconds, verified.starts, limits.empty() ? "held" : "met your limits");
  text +=
      verified.certified()
          ? " So with 95 % confidence more than 95 % of such starts go well."
          : say(" That is **not yet certified**: with 95 % confidence more than @ % of such starts go well. It "
                "would take @ starts to say 95 %, and each is a long run.",
                Value(100 * std::pow(0.05, 1.0 / verified.starts), 2), certain);
  return text + further_in_words(verified) +
         say(" @ runs were made; @.@", choice.spent.runs, searched_in_words(choice),
             choice.at_its_bound
                 ? say(" That took all that a search may, @ instructions, so that others may be cheaper.",
                       Value(most_of_a_search, 2))
                 : std::string());
}

/// The limit that a run comes nearest to.
std::pair<Error, double> binding(const byhand::Point& run, const std::map<Error, double>& limits) {
  const auto share = [&](const auto& one) { return run.has(one.first) ? run[one.first] / one.second : 0; };
  return *std::max_element(limits.begin(), limits.end(),
                           [&](const auto& a, const auto& b) { return share(a) < share(b); });
}

/// Where an error of rounding is drawn: at the next decade below the others and the limit.
double floor_of(const byhand::Choice& choice, Error error, double limit) {
  double least = limit;
  const auto look = [&](const byhand::Point& point) {
    if (point.has(error) && point[error] > finest) least = std::min(least, point[error]);
  };
  look(choice.best.point);
  for (std::size_t i = 0; i < std::min(choice.runners_up.size(), shown); ++i) look(choice.runners_up[i].point);
  for (const auto& tighter : {choice.robust, choice.finer})
    if (tighter) look(*tighter);
  return std::isfinite(least) ? std::pow(10, std::floor(std::log10(0.5 * least))) : finest;
}

renderer::Chart chart_of(const byhand::Choice& choice, const Problem& problem,
                         const std::map<Error, double>& limits) {
  using namespace renderer;
  const auto binds =
      limits.empty() ? std::pair{Error::drift, double{INFINITY}} : binding(choice.best.point, limits);
  const Error error = binds.first;
  const double limit = binds.second;
  Chart chart{.title = title_of(problem),
              .x = {.label = say("@@", std::string(name_of(error)),
                                 unit_of(error) == "1" ? "" : say(" (@)", std::string(unit_of(error)))),
                    .scale = Scale::logarithmic},
              .y = {.label = "cost (instructions per frame)", .scale = Scale::logarithmic}};
  const double floor = floor_of(choice, error, limit);
  const auto add = [&](const byhand::Point& point, const std::string& label) {
    if (!point.has(error)) return;
    chart.curves.push_back({.label = label,
                            .x = {std::max(point[error], floor)},
                            .y = {point.cost},
                            .style = CurveStyle::markers,
                            .place = pictures::place_of(point.family->name)});
  };
  add(choice.best.point, choice.best.point.described());
  for (std::size_t i = 0; i < std::min(choice.runners_up.size(), shown); ++i)
    add(choice.runners_up[i].point, choice.runners_up[i].point.described());
  const auto another = [&](const std::optional<byhand::Point>& point) {
    return point && !same_setting(*point, choice.best.point);
  };
  if (another(choice.robust)) add(*choice.robust, "half: " + choice.robust->described());
  if (another(choice.finer)) add(*choice.finer, "a tenth: " + choice.finer->described());
  if (!limits.empty())
    chart.references.push_back({.axis = renderer::Reference::Across::x, .value = limit, .label = "asked for"});
  if (std::any_of(chart.curves.begin(), chart.curves.end(), [=](const Curve& one) { return one.x[0] == floor; }))
    chart.references.push_back({.axis = renderer::Reference::Across::x, .value = floor, .label = "or less"});
  return chart;
}

/// Whether any method does its least in a frame within its budget.
bool finishes_a_frame(const Problem& problem, const Wish& wish) {
  return std::any_of(families().begin(), families().end(), [&](const Family& family) {
    const byhand::Point least =
        measure(problem, family, with_cure({}, family.cures.front()), {.seconds = frame, .reference = false});
    return least.cost > 0 && least.cost <= wish.budget(family);
  });
}

std::string data_of(const byhand::Choice& choice, const Problem& problem) {
  std::vector<byhand::Point> points{choice.best.point};
  for (const Candidate& one : choice.runners_up) points.push_back(one.point);
  for (const byhand::Point& one : choice.passed) points.push_back(one);
  for (const auto& tighter : {choice.robust, choice.finer})
    if (tighter) points.push_back(*tighter);
  return tidy_head() + tidy_rows(problem, points, errors);
}

}  // namespace

void recommendation(Page& page, const Setting& setting) {
  const auto [problem, ignored] = problem_of(setting);
  const std::map<Error, double> limits = limits_of(setting);
  page.text(
      R"(No chart answers for *your* scene, but the program does. It starts from the laws of lesson 8, which
      estimate how many substeps or sweeps are needed. From there it runs every method with all its choices, and
      recommends the cheapest run that meets your limits.)");
  for (const std::string& name : ignored)
    page.text("A @ has no @: the value that you set is ignored.", problem.scene().title, name);
  for (const auto& [error, limit] : limits)
    if (!has(problem.scene(), error)) {
      page.text("Here the program has no answer: @ is not conserved by a @, so it has no such error.",
                std::string(name_of(error)), problem.scene().title);
      return;
    }
  for (const auto& [error, limit] : limits)
    if (const double least = error == Error::drift ? finest_drift : finest; limit < least) {
      page.text("Here the program has no answer: @ error below @@ cannot be told from rounding.",
                with_article(error), least, unit(error));
      return;
    }
  for (const auto& [error, limit] : limits)
    if (limit >= (is_length(error) ? std::max(problem.size(), 1e-3) : 1))
      page.text("A limit of @@ on @ is as wide as the scene itself: almost any run that holds together keeps it.",
                limit, unit(error), std::string(name_of(error)));
  const bool by_clock = setting.budget() > 0;
  const std::string within =
      by_clock ? say(" within @ µs a frame by this machine's clock", setting.budget() * 1e6) : "";
  page.text(limits.empty()
                ? say("**You ask:** @. Which method has the least drift@?", in_prose(description(problem)), within)
                : say("**You ask:** @. Which is the cheapest method with @@?", in_prose(description(problem)),
                      asked_for(limits, problem), within));

  Search search{.most = most_of_a_search};
  search.side_by_side = [&](int count, const std::function<void(int)>& work) {
    page.side_by_side(count, [&](int i) { return work(i), 0; });
  };
  Wish wish{.limits = limits};
  const auto time_of = [&problem = problem](const byhand::Point& point) {
    return nanoseconds_a_frame(problem, point.family->setting(point.knobs), 0.05);
  };
  std::map<const Family*, double> pace;  // of each method, instructions a nanosecond, here and now
  if (by_clock) {
    double quickest = 0;
    for (const Family& family : families()) {
      Knobs knobs = first_knobs(problem, family, family.cures.front(), 4);
      byhand::Point probe = measure(problem, family, knobs, {.reference = false});
      while (probe.outcome != Outcome::good && probe.outcome != Outcome::refused && knobs.substeps < 64) {
        knobs.substeps *= 4;
        probe = measure(problem, family, knobs, {.reference = false});
      }
      if (probe.outcome == Outcome::good) pace[&family] = probe.cost / time_of(probe);
      quickest = std::max(quickest, pace[&family]);
    }
    // What cannot be timed is allowed the most; the answer is timed again.
    for (auto& [family, instructions] : pace)
      if (instructions == 0) instructions = quickest > 0 ? quickest : 4;
    wish.budget = [&pace, nanoseconds = 1e9 * setting.budget()](const Family& family) {
      return pace.at(&family) * nanoseconds;
    };
  }
  byhand::Choice choice = choose(problem, wish, search);
  double nanoseconds = by_clock && choice.reached ? time_of(choice.best.point) : NAN;
  for (int again = 0; again < 2 && nanoseconds > 1e9 * setting.budget(); ++again) {
    // What takes longer than its method's pace said slows that pace.
    pace[choice.best.point.family] = 0.95 * choice.best.point.cost / nanoseconds;
    choice = choose(problem, wish, search);
    nanoseconds = choice.reached ? time_of(choice.best.point) : NAN;
  }
  const byhand::Point& best = choice.best.point;

  if (choice.reached) {
    page.text("**Answer:** @: @@. @", best.described(), cost_in_words(best),
              by_clock ? say(", @ µs by the clock", Value(nanoseconds / 1000, 3)) : "",
              margin_in_words(choice, problem, !limits.empty()));
    page.text("**Why:** @.", why(choice, limits));
    show_errors(page, best, problem, !limits.empty());
    page.text(certainty(choice, limits));
    if (const std::string others = runners_up(choice, limits); !others.empty())
      page.text("Runners-up:\n" + others);
    for (const auto& [tighter, asked] : {std::pair{choice.robust, "With half of each limit, as a margin"},
                                         {choice.finer, "For a tenth of each limit"}})
      if (!limits.empty())
        page.text("**@:** @", asked,
                  tighter && same_setting(*tighter, best) ? std::string("the same run.")
                  : tighter
                      ? say("@, for @ (×@), from as many starts.", tighter->described(), cost_in_words(*tighter),
                            Value(tighter->cost / best.cost, tighter->cost < 2 * best.cost ? 3 : 2))
                      : std::string("no method was found to keep that from as many starts for up to a "
                                    "hundred times the cost."));
    page.code("The answer for your own program", code_of(best.family->setting(best.knobs)));
  } else if (by_clock && !finishes_a_frame(problem, wish)) {
    page.text("**No method finishes a frame within @ µs**, so no run could be made. Allow more time.",
              setting.budget() * 1e6);
  } else {
    page.text(choice.at_its_bound
                  ? "**No method was found yet that reaches that**, in all that a search may take: @.@"
                  : "**No method was found that reaches that**: @.@",
              searched_in_words(choice),
              best.outcome == Outcome::good && std::isfinite(choice.best.excess) && !limits.empty()
                  ? say(" The nearest is @ for @, with @ times the error that you allow.", best.described(),
                        cost_in_words(best), Value(choice.best.excess, 2))
              : best.outcome == Outcome::good ? std::string()
                                              : " No run held to the end.");
  }
  if (const std::string out = passed(choice); !out.empty())
    page.text(problem.scene().duty == Duty::hold ? "Methods that cannot do this scene:\n" + out
                                                 : say("Left out: @.", without_contacts()));

  if (choice.reached) {
    const std::string caption =
        limits.empty()
            ? "The best run of each method within the time allowed."
            : say(R"(The cheapest run of each method that meets the limits, and the nearest run of each other method
                  that held. Left of “asked for”, a run meets the limit on its @@.)",
                  std::string(name_of(binding(best, limits).first)),
                  limits.size() > 1 ? ", the tightest one; the other errors are in the data" : "");
    if (by_clock)
      page.clocked("choice", caption, [=, p = problem] { return chart_of(choice, p, limits); });
    else
      page.figure("choice", caption, chart_of(choice, problem, limits), data_of(choice, problem));
    page.measure("its cost a frame", best.cost, "1");
  }
  for (const auto& [error, limit] : limits) {
    const byhand::Point again = choice.reached ? measure(problem, *best.family, best.knobs) : byhand::Point{};
    page.claim(std::string(name_of(error)) + " of what is recommended, run again",
               again.has(error) ? again[error] : INFINITY, std::string(unit_of(error)),
               is_at_most(limit, "asked for"), Condition{choice.reached, "targets that are reached"});
  }
  page.claim("initial conditions from which it meets the limits", static_cast<double>(choice.verified.within), "1",
             is(static_cast<double>(choice.verified.starts), "all of them", absolute(0)),
             Condition{choice.reached, "targets that are reached"});
  page.text(
      R"(Ask again for your own scene: any scene of this lesson by name, one or more errors (`drift`, `trajectory`,
      `energy`, `momentum`, `reaction`), and a `budget` of time a frame, such as 200us.)");
}

}  // namespace byhand::accuracy
