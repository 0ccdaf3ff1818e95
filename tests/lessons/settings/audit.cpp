#include "tests/lessons/settings/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>

#include "lessons/files/chart_data.hpp"
#include "lessons/page/html/step_html.hpp"
#include "lessons/page/recording.hpp"
#include "tests/lessons/settings/frame.hpp"
#include "tests/lessons/settings/judgements.hpp"
#include "tests/lessons/settings/numbers.hpp"
#include "tests/lessons/settings/pictures.hpp"
#include "tests/lessons/settings/watchdog.hpp"

namespace byhand::tests {
namespace {

using course::ParameterRecord;
using course::Step;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// All that a page says and draws in its charts.
std::string everything_on(const course::Page& page) {
  std::string all;
  for (const course::Item& item : page.items()) {
    for (const std::string& words : passages(item)) all += words + "\n";
    if (const auto* figure = std::get_if<course::Figure>(&item))
      if (const auto* chart = std::get_if<renderer::Chart>(&figure->picture)) all += course::csv(*chart);
  }
  return all;
}

}  // namespace

Audit::Audit(course::Lesson& lesson, Extent extent) : lesson_(lesson), extent_(std::move(extent)) {
  for (const Step& step : lesson_.steps()) {
    const bool turns = std::any_of(lesson_.parameters().begin(), lesson_.parameters().end(),
                                   [&](const ParameterRecord& p) { return may_depend(step, p); });
    if ((!turns && !extent_.all_steps) || (!extent_.step.empty() && step.label != extent_.step)) continue;
    steps_[step.label].page = try_step(step, {}).value_or("");
  }
  until_ = 0.5 * extent_.seconds;
  try_ends();
  until_ = INFINITY;
  try_all(extent_.also);
  try_all(suggestions(lesson_.closing()));
  until_ = 0.9 * extent_.seconds;
  try_random();
  until_ = extent_.seconds;
  if (extent_.pairs) try_pairs();
  if (extent_.all_steps && extent_.step.empty()) try_foreign_parameters();
}

void Audit::try_ends() {
  auto parameters = lesson_.parameters();
  std::shuffle(parameters.begin(), parameters.end(), std::mt19937(extent_.seed));
  for (const ParameterRecord& p : parameters) {
    bool used = false;
    for (const Step& step : lesson_.steps()) {
      if (!may_depend(step, p) || !steps_.contains(step.label)) continue;
      StepState& state = steps_[step.label];
      state.depends.insert(p.name);
      bool changes = false;
      for (const std::string& end : ends(p)) {
        const auto page = try_step(step, {{p.name, end}});
        // Where there was no time to look, it may depend on it.
        changes = changes || !page || *page != state.page;
      }
      if (!changes) state.depends.erase(p.name);
      used = used || changes;
    }
    if (!used && extent_.all_steps && extent_.step.empty())
      report("", command("", {{p.name, ends(p).front()}}), {"no step says anything else", p.described(p.initial)});
  }
}

void Audit::try_all(const std::vector<Suggestion>& all) {
  for (const auto& [label, setting] : all)
    for (const Step& step : lesson_.steps())
      if ((label.empty() || label == step.label) && !relevant(step, setting).empty()) try_step(step, setting);
}

void Audit::try_random() {
  std::mt19937 random(extent_.seed);
  const auto fixed = [&](const ParameterRecord& p) {
    return std::any_of(extent_.base.begin(), extent_.base.end(), [&](const auto& s) { return s.first == p.name; });
  };
  for (int i = 0; i < extent_.random; ++i) {
    Setting setting;
    for (const ParameterRecord& p : lesson_.parameters())
      if (!fixed(p)) setting.emplace_back(p.name, any_value(p, random));
    for (const Step& step : lesson_.steps())
      if (!relevant(step, setting).empty()) try_step(step, setting);
  }
}

void Audit::try_pairs() {
  std::vector<Setting> pairs;
  const auto& parameters = lesson_.parameters();
  for (auto a = parameters.begin(); a != parameters.end(); ++a)
    for (auto b = std::next(a); b != parameters.end(); ++b)
      for (const std::string& of_a : ends(*a))
        for (const std::string& of_b : ends(*b)) pairs.push_back({{a->name, of_a}, {b->name, of_b}});
  // So that each seed tries others where there is no time for all.
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(extent_.seed));
  for (const Setting& pair : pairs)
    for (const Step& step : lesson_.steps())
      if (relevant(step, pair).size() == 2) try_step(step, pair);
}

void Audit::try_foreign_parameters() {
  std::mt19937 random(extent_.seed);
  for (const Step& step : lesson_.steps()) {
    Setting foreign;
    for (const ParameterRecord& p : lesson_.parameters())
      if (!may_depend(step, p)) foreign.emplace_back(p.name, any_value(p, random));
    if (foreign.empty()) continue;
    std::string page;
    findings(step, foreign, page);
    ++runs_;
    if (page != steps_[step.label].page)
      report(step.label, command(step.label, foreign), {"answers() gives its parameter to another step", page});
  }
}

bool Audit::may_depend(const Step& step, const ParameterRecord& parameter) const {
  return parameter.step.empty() || parameter.step == step.label;
}

Setting Audit::relevant(const Step& step, const Setting& setting) const {
  const auto state = steps_.find(step.label);
  Setting all;
  if (state != steps_.end())
    std::copy_if(setting.begin(), setting.end(), std::back_inserter(all),
                 [&](const auto& s) { return state->second.depends.contains(s.first); });
  return all;
}

std::optional<std::string> Audit::try_step(const Step& step, const Setting& setting) {
  StepState& state = steps_[step.label];
  const Setting shown = relevant(step, setting);
  if (!state.wanted.insert(shown).second) return {};
  const bool beyond = std::any_of(shown.begin(), shown.end(), [&](const auto& s) {
    return std::find(extent_.beyond.begin(), extent_.beyond.end(), s) != extent_.beyond.end();
  });
  if (beyond || (state.tried > 0 && state.seconds >= until_)) return {};
  ++state.tried;
  ++runs_;
  const double begin = processor_seconds();
  const std::string repeat = command(step.label, shown);
  std::string page;
  {
    const Watchdog watchdog(repeat);
    for (Finding& finding : findings(step, shown, page)) report(step.label, repeat, std::move(finding));
  }
  state.seconds += processor_seconds() - begin;
  return page;
}

std::vector<Finding> Audit::findings(const Step& step, const Setting& setting, std::string& page) {
  try {
    for (const ParameterRecord& p : lesson_.parameters()) lesson_.set(p.name, p.typed(p.initial));
    for (const auto& [name, value] : extent_.base) lesson_.set(name, value);
    std::vector<std::string> given;
    for (const auto& [name, value] : setting) lesson_.set(name, value);
    for (const ParameterRecord& p : lesson_.parameters()) given.push_back(p.typed(p.value));
    const course::RecordedStep recorded = record_step(lesson_, step, true);
    page = everything_on(recorded.page);
    // Throws for a formula that is no MathML.
    const auto no_picture = [](const auto&) { return site::Shown{}; };
    site::step_html(recorded, {.figure = no_picture, .film = no_picture});
    std::vector<Finding> found = broken_rules(recorded.page, given);
    if (extent_.judgements)
      std::ranges::move(unclaimed_judgements(recorded.page, given), std::back_inserter(found));
    if (extent_.frames) std::ranges::move(out_of_frame(recorded.page), std::back_inserter(found));
    if (extent_.pictures) std::ranges::move(blank_pictures(recorded.page, pictures_), std::back_inserter(found));
    return found;
  } catch (const std::exception& error) {
    page = error.what();
    return {{"exit status", error.what()}};
  }
}

void Audit::report(const std::string& step, const std::string& repeat, Finding finding) {
  const std::string words = without_numbers(finding.words);
  const auto known = std::find_if(failures_.begin(), failures_.end(), [&](const Failure& f) {
    return f.step == step && f.finding.rule == finding.rule && without_numbers(f.finding.words) == words;
  });
  if (known == failures_.end())
    failures_.push_back({step, repeat, std::move(finding), 1});
  else
    ++known->settings;
}

std::string Audit::command(const std::string& step, const Setting& setting) const {
  Setting all = extent_.base;
  std::erase_if(all, [&](const auto& s) {
    return std::any_of(setting.begin(), setting.end(), [&](const auto& other) { return other.first == s.first; });
  });
  all.insert(all.end(), setting.begin(), setting.end());
  return fmt::format("./lessons/run {}{}{}", lesson_.number(), step.empty() ? "" : " --step " + step,
                     options(all));
}

std::vector<std::string> Audit::left_out() const {
  std::vector<std::string> lines;
  for (const auto& [label, state] : steps_)
    if (const auto wanted = static_cast<int>(state.wanted.size()); state.tried < wanted)
      lines.push_back(fmt::format("step {} at {} of {} settings, for want of time", label, state.tried, wanted));
  return lines;
}

std::string Audit::time_taken() const {
  double all = 0;
  std::pair<double, std::string> longest;
  for (const auto& [label, state] : steps_) {
    all += state.seconds;
    longest = std::max(longest, {state.seconds, label});
  }
  return fmt::format("{:.0f} s, {:.0f} s of them for step {}", all, longest.first, longest.second);
}

}  // namespace byhand::tests
