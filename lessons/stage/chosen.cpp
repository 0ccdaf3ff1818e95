#include "lessons/stage/chosen.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/catalogue/code.hpp"
#include "lessons/stage/request.hpp"

namespace byhand::stage {
namespace {

using course::Page;
using course::Value;

constexpr double pace = 1e10;  // instructions a second, of two cores, that a search is reckoned with
constexpr double soon = 8;     // after which an answer is given if there is one [s]

/// An answer of the chooser and what it is the answer to.
struct Answer {
  std::string name, asked;
  Point point;
};

constexpr double least_told = 1e-12;  // [m]: less is rounding

std::string number_of(double value, Error error) {
  return course::say("@@", Value(value, 2), unit_of(error) == "1" ? "" : " " + std::string(unit_of(error)));
}

/// "drift", "trajectory after 1 s": what is read at one moment says when.
std::string when_and_what(Error error, const Request& request) {
  const bool once = needs_truth(error) || error == Error::contact;
  return once ? course::say("@ after @ s", std::string(name_of(error)), Value(request.problem.compared_at(), 2))
              : std::string(name_of(error));
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
  return fmt::format("{}", fmt::join(parts, between));
}

std::string asked_for(const Request& request) {
  std::vector<std::string> parts;
  for (const auto& [error, limit] : request.limits)
    parts.push_back(fmt::format("{} of at most {}", when_and_what(error, request), number_of(limit, error)));
  return joined(parts, " and ");
}

/// "drift 0.01 m": an error of a run.
std::string error_of(const Point& point, Error error, const Request& request) {
  return fmt::format("{} {}", when_and_what(error, request), number_of(point[error], error));
}

std::string errors_of(const Point& point, const Request& request) {
  std::vector<std::string> parts;
  for (const auto& [error, limit] : request.limits)
    if (point.has(error)) parts.push_back(error_of(point, error, request));
  return joined(parts, ", ");
}

/// The cheapest, and what keeps half and a tenth of the limits, which may be the same.
std::vector<Answer> answers_of(const Choice& choice) {
  std::vector<Answer> answers{{"cheapest", "cheapest", choice.best.point}};
  const auto add = [&](const std::string& name, const std::string& asked, const Point& point) {
    Answer& last = answers.back();
    if (same_setting(last.point, point))
      last.name += ", " + name, last.asked += "; " + asked;
    else
      answers.push_back({name, asked, point});
  };
  if (choice.robust) add("robust", "robust: half of each limit", *choice.robust);
  if (choice.finer) add("ten times better", "ten times better", *choice.finer);
  return answers;
}

/// "gravity differs", "first speed and gravity differ".
std::string varied_in_words(const Request& request) {
  std::vector<std::string> varied = request.problem.scene().varied;
  std::ranges::replace(varied, "speed", "first speed");
  return joined(varied, " and ") + (varied.size() == 1 ? " differs" : " differ");
}

/// What a run gets wrong that was not asked about, by more than a tenth.
std::string warnings_of(const Point& point, const Request& request) {
  std::vector<std::string> parts;
  for (const Error error : errors) {
    const bool length = error == Error::drift || error == Error::trajectory;
    const double bad = length ? 0.1 * request.problem.size() : 0.1;
    if (needs_truth(error) && !(request.problem.reference().uncertainty < 0.025 * request.problem.size()))
      continue;
    if (error != Error::contact && point.has(error) && point[error] > bad && !request.limits.contains(error))
      parts.push_back(error_of(point, error, request));
  }
  return joined(parts, ", ");
}

/// "trajectory and reaction": the errors of this scene that a run was not held against.
std::string not_measured(const Point& point, const Request& request) {
  std::vector<std::string> parts;
  for (const Error error : errors)
    if (has(request.problem.scene(), error) && needs_truth(error) && !point.has(error))
      parts.emplace_back(name_of(error));
  return joined(parts, " and ");
}

/// How much larger what varies may be; "" where nothing does.
std::string margin_in_words(const Choice& choice, const Request& request) {
  if (request.problem.scene().varied.empty()) return "";
  const char* stress = request.problem.scene().stress == "speed" ? "the first speed" : "gravity";
  if (std::isinf(choice.margin))
    return course::say(
        "It still holds at the largest value of @ that was tried, up to a thousand times the present one.",
        stress);
  if (std::isnan(choice.margin))
    return course::say(
        "How much larger @ may be was not found: it takes more than a tenth of the work of the choice, or the "
        "true motion is not known there.",
        stress);
  return course::say(
      "Of larger values of @, tried @, the first at which it fails is @ times as large. Between these values "
      "it was not tried.",
      stress, strides_of_margin, Value(choice.margin, 3));
}

std::string looks_further_with(double patience) {
  return course::say("With --set patience=@ it looks further.", patience);
}

/// What ends "No setting was found that keeps a tenth of each limit".
std::string why_not_tighter(const Request& request, double part, bool at_its_bound, double patience) {
  const auto limit = request.limits.find(Error::trajectory);
  if (limit != request.limits.end() &&
      !well_known(request.problem.reference().uncertainty, {{Error::trajectory, part * limit->second}}))
    return course::say(": the true motion is known to @ m only.",
                       Value(request.problem.reference().uncertainty, 2));
  if (!at_its_bound) return ".";
  return ", within the time that the search takes. " + looks_further_with(10 * std::max(patience, usual_patience));
}

/// The starts that are not among those of the verifications.
std::string left_out_in_words(const Choice& choice) {
  constexpr const char* others =
      " @ other starts are left out@: from there the true motion is not known to a quarter of what is asked for.";
  if (choice.verified.left_out > 0) return course::say(others, choice.verified.left_out, "");
  if (choice.left_out > 0) return course::say(others, choice.left_out, " for half or a tenth of the limits");
  return "";
}

void show_answers(Page& page, const Request& request, const Choice& choice, double patience) {
  const std::vector<Answer> answers = answers_of(choice);
  std::vector<std::vector<std::string>> rows;
  for (const Answer& one : answers)
    rows.push_back({one.asked, one.point.described(), errors_of(one.point, request),
                    course::say("@", Value(one.point.cost, 2))});
  page.table({"asked for", "method, for 1/60 s", "its errors from the file's own start", "instructions, by price"},
             rows);
  const std::string kind = request.problem.start().row_kind();
  if (kind == "boxes in space" || kind.starts_with("joined shapes"))
    page.text(
        "Where boxes touch in space, or what touches is joined, a price may be a third off, and of some that "
        "tumble "
        "twice that.");
  if (const std::string bad = warnings_of(choice.best.point, request); !bad.empty())
    page.text(
        "**Warning:** the cheapest keeps what is asked, but gets other things wrong: @. Limit these in the file's "
        "\"accuracy\" if they matter.",
        bad);
  if (const std::string errors = not_measured(choice.best.point, request); !errors.empty())
    page.text("Its errors of @ were not measured, as the file does not limit them.", errors);
  for (const auto& [found, part, asked] : {std::tuple{choice.robust.has_value(), 0.5, "half of each limit"},
                                           {choice.finer.has_value(), 0.1, "a tenth of each limit"}})
    if (!found)
      page.text("No setting was found that keeps @ from all starts@", asked,
                why_not_tighter(request, part, choice.at_its_bound, patience));
  if (choice.at_its_bound && choice.robust && choice.finer)
    page.text("The search ended with its time, so that others may be cheaper, most of all for half and a tenth. @",
              looks_further_with(10 * std::max(patience, usual_patience)));
  if (const auto limit = request.limits.find(Error::trajectory); limit != request.limits.end()) {
    page.text("The true motion is known to @ m. That counts as error of the trajectory besides.",
              Value(std::max(least_told, choice.best.point.uncertainty), 2));
    if (request.last_motion < 0.1 * limit->second)
      page.text(
          "In the last tenth of the time no body moves further than @ m from where it ends. So this trajectory "
          "says where the scene ends, not how it gets there.",
          Value(std::max(least_told, request.last_motion), 2));
  }
  if (request.problem.scene().varied.empty())
    page.text(
        "Run for @ s from the file's own start, which has neither weight nor first speeds that could vary, the "
        "cheapest kept what is asked. @ runs were made.",
        Value(choice.verified.seconds, 3), choice.spent.runs);
  else
    page.text(
        "Run for @ s from @ starts (the file's own and others whose @ by up to a twentieth), the cheapest "
        "kept what is asked in @@.@@ @ runs were made.",
        Value(choice.verified.seconds, 3), choice.verified.starts, varied_in_words(request),
        choice.verified.within,
        choice.verified.certified()
            ? ": of such starts more than 95 % do, with 95 % confidence"
            : course::say(", where @ would have to before 95 % of such starts are certain", certain),
        left_out_in_words(choice), further_in_words(choice.verified), choice.spent.runs);
  if (const std::string margin = margin_in_words(choice, request); !margin.empty()) page.text("@", margin);
  page.clocked("chosen", "Time for 1/60 s on this machine.", [=] {
    renderer::Chart chart{.y = {.label = "time (µs)"}};
    renderer::Bars bars;
    for (const Answer& one : answers) {
      chart.bar_names.push_back(one.name);
      bars.values.push_back(
          1e-3 * nanoseconds_a_frame(request.problem, one.point.family->setting(one.point.knobs), 0.05));
    }
    chart.bars = {bars};
    return chart;
  });
  for (const Answer& one : answers)
    page.code("C++, " + one.name, code_of(one.point.family->setting(one.point.knobs)));
  std::string others;
  for (const Candidate& one : choice.runners_up)
    if (one.reached)
      others +=
          course::say("\n- @, × @", one.point.described(), Value(one.point.cost / choice.best.point.cost, 2));
  if (!others.empty()) page.text("@", "Other methods that keep it, by cost:" + others);
  page.claim("starts from which the cheapest keeps what is asked", static_cast<double>(choice.verified.within),
             "1", course::is(static_cast<double>(choice.verified.starts), "all of them", course::absolute(0)));
}

/// What came nearest where no method keeps the request from all beginnings.
std::string nearest_in_words(const Choice& choice) {
  const Point& best = choice.best.point;
  if (best.outcome == Outcome::too_slow)
    return course::say("Nothing that was tried kept it; the last was @, which costs more than this search allows.",
                       best.described());
  if (best.outcome != Outcome::good || !std::isfinite(choice.best.excess))
    return best.reason.empty() ? "None of the runs that were watched to the end did its duty."
                               : fmt::format("The run by {}: {}.", best.described(), best.reason);
  if (choice.best.excess <= 1)
    return course::say(
        "From the file's own start @ keeps it, with @ of the error that is allowed. No method was found that also "
        "keeps it from each of the others, which differ by up to a twentieth.",
        best.described(), Value(choice.best.excess, 2));
  return course::say(
      "Of the runs that were watched to the end @ came nearest from the file's own start, with @ times the error "
      "that is asked for.",
      best.described(), Value(choice.best.excess, 2));
}

}  // namespace

void show_chosen(Page& page, const SceneFile& file, double patience) {
  const Request request = request_of(file);
  for (const std::string& note : request.notes) page.text("@", note);
  if (request.seconds < 0.99 * file.duration)
    page.text(request.broke ? "**Warning:** at @ s of the scene's @ s a fine step has no answer, so runs are "
                              "watched until then. What a method does afterwards is not known."
                            : "The scene is large: runs are watched for @ s of its @ s.",
              Value(request.seconds, 2), file.duration);
  if (std::abs(file.step - frame) > 1e-9 * frame)
    page.text(
        "The file's step of @ s is not asked about: each method takes what steps it needs in a frame of 1/60 s.",
        Value(file.step, 3));
  page.text("**You ask:** which is the cheapest method with @?", asked_for(request));
  page.text(
      "Besides, a run has to do its duty: no joint opens and nothing sinks in by more than a tenth of the "
      "smallest "
      "body, @and where the energy of the true motion is known, a run never has more than the most of that and "
      "@ % of its scale, and from the file's own start it ends within as much of it.",
      request.problem.scene().rests ? "nothing leaves its place by more than half of it, " : "",
      Value(100 * energy_astray, 2));
  const double open = request.problem.start().separation();
  if (const auto drift = request.limits.find(Error::drift); drift != request.limits.end() && open > drift->second)
    return page.text(
        "**No run of this file can keep that**: as it begins, a joint is open or bodies overlap by @ m already.",
        Value(open, 2));
  if (const auto energy = request.limits.find(Error::energy);
      energy != request.limits.end() && request.taken > energy->second)
    return page.text(
        "**No run of this file can keep that**: its first velocities pull joints apart, and the first step of any "
        "method, which ends that, takes @ of the energy's scale.",
        Value(request.taken, 2));
  const auto chosen_within = [&](double seconds) {
    Search search{.most = seconds * pace, .all_errors = false};
    search.verification = search.most / 10;
    search.enough = search.most;
    search.side_by_side = [&](int count, const std::function<void(int)>& work) {
      page.side_by_side(count, [&](int i) { return work(i), 0; });
    };
    return choose(request.problem, {.limits = request.limits}, search);
  };
  Choice choice = chosen_within(std::min(soon, patience));
  // Nothing yet: it takes all that the reader allows; for what may be cheaper, what is allowed on purpose.
  const bool goes_on = !choice.reached || patience > usual_patience;
  if (goes_on && choice.at_its_bound && patience > 2 * soon) {
    Choice longer = chosen_within(patience - soon);
    if (longer.reached || !choice.reached) choice = std::move(longer);
  }
  if (choice.reached) {
    show_answers(page, request, choice, patience);
  } else if (choice.at_its_bound) {
    page.text("**Nothing was found yet that reaches that**, in the @ runs that --set patience=@ allows. @ @",
              choice.spent.runs, patience, nearest_in_words(choice), looks_further_with(10 * patience));
  } else {
    page.text("**No method was found that reaches that.** @", nearest_in_words(choice));
  }
  std::string refused;
  for (const Point& point : choice.passed)
    if (point.outcome == Outcome::refused) refused += fmt::format("\n- {}: {}", point.family->name, point.reason);
  if (!refused.empty()) page.text("@", "Methods that cannot run this scene:" + refused);
}

}  // namespace byhand::stage
