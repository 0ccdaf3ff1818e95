#include "lessons/page/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace byhand::course {
namespace {

constexpr int most_core_steps = 7;

bool is_name(const std::string& name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

bool is_slug(const std::string& slug) {
  return slug.size() > 3 && std::isdigit(slug[0]) && std::isdigit(slug[1]) && slug[2] == '_' && is_name(slug);
}

}  // namespace

Lesson::Lesson(About about) : about_(std::move(about)) {
  if (!is_slug(about_.slug))
    throw LessonError(fmt::format("\"{}\" cannot name a lesson: use two digits, _ and a name", about_.slug));
}

int Lesson::number() const { return std::stoi(about_.slug); }

ParameterRecord& Lesson::record(ParameterRecord record) {
  if (is_parameter(record.name)) throw LessonError(fmt::format("the parameter {} is there twice", record.name));
  try {
    record.set(record.typed(record.initial));
  } catch (const std::invalid_argument& bad) {
    throw LessonError(bad.what());
  }
  return parameters_.emplace_back(std::move(record));
}

Parameter<double> Lesson::parameter(std::string name, double initial, std::string unit, Range range,
                                    std::string meaning) {
  return Parameter<double>(
      record({std::move(name), std::move(unit), std::move(meaning), range, initial, initial, false}));
}

Parameter<int> Lesson::parameter(std::string name, int initial, std::string unit, Range range,
                                 std::string meaning) {
  const double value = initial;
  return Parameter<int>(record({std::move(name), std::move(unit), std::move(meaning), range, value, value, true}));
}

Parameter<std::string> Lesson::parameter(std::string name, std::string initial, std::vector<std::string> choices,
                                         std::string meaning) {
  for (const std::string& choice : choices)
    if (!is_name(choice))
      throw LessonError(fmt::format("\"{}\" cannot name a choice: use a-z, 0-9 and _", choice));
  const auto place = std::find(choices.begin(), choices.end(), initial);
  if (place == choices.end())
    throw LessonError(
        fmt::format("the parameter {} begins as \"{}\", which is none of its choices", name, initial));
  const auto value = static_cast<double>(place - choices.begin());
  return Parameter<std::string>(record({.name = std::move(name),
                                        .meaning = std::move(meaning),
                                        .initial = value,
                                        .value = value,
                                        .choices = std::move(choices)}));
}

void Lesson::step(std::string title, StepFunction run) {
  const auto core = std::count_if(steps_.begin(), steps_.end(), [](const Step& s) { return !s.deeper; });
  if (core == most_core_steps)
    throw LessonError(
        fmt::format("\"{}\" is one core step too many: a lesson has at most {}", title, most_core_steps));
  steps_.push_back({std::to_string(core + 1), std::move(title), false, std::move(run)});
}

void Lesson::deeper(std::string title, StepFunction run) {
  if (steps_.empty()) throw LessonError(fmt::format("\"{}\" goes deeper than nothing", title));
  std::string label = steps_.back().label;
  if (steps_.back().deeper)
    ++label.back();
  else
    label += 'a';
  steps_.push_back({std::move(label), std::move(title), true, std::move(run)});
}

void Lesson::answers(const std::vector<std::string>& parameters) {
  if (steps_.empty()) throw LessonError("there is no step yet that could answer to a parameter");
  for (const std::string& name : parameters) {
    const auto found =
        std::find_if(parameters_.begin(), parameters_.end(), [&](const auto& p) { return p.name == name; });
    if (found == parameters_.end())
      throw LessonError(fmt::format("step {} answers to {}, which is no parameter", steps_.back().label, name));
    found->step = steps_.back().label;
  }
}

void Lesson::hold(Hold hold) {
  if (steps_.empty())
    throw LessonError(fmt::format("there is no step yet that could offer {} to hold", hold.name));
  hold.caption = unwrapped(hold.caption);
  steps_.back().hold = std::move(hold);
}

std::string Lesson::step_of(const std::vector<std::pair<std::string, std::string>>& settings) const {
  std::string step;
  for (const auto& [name, value] : settings)
    for (const ParameterRecord& p : parameters_) {
      if (p.name != name) continue;
      if (p.step.empty() || (!step.empty() && step != p.step)) return "";
      step = p.step;
    }
  return step;
}

void Lesson::closing(Closing closing) {
  for (std::string& known : closing.now_you_know) known = unwrapped(known);
  for (Try& attempt : closing.tries) attempt.what = unwrapped(attempt.what);
  closing.next = unwrapped(closing.next);
  closing_ = std::move(closing);
}

bool Lesson::is_parameter(const std::string& name) const {
  return std::any_of(parameters_.begin(), parameters_.end(), [&](const auto& p) { return p.name == name; });
}

void Lesson::set(const std::string& name, std::string_view value) {
  if (parameters_.empty()) throw std::invalid_argument(fmt::format("{}: this lesson has no parameters", name));
  std::string names;
  for (ParameterRecord& p : parameters_) {
    if (p.name == name) return p.set(value);
    names += (names.empty() ? "" : ", ") + p.name;
  }
  throw std::invalid_argument(fmt::format("this lesson has no parameter \"{}\", only {}", name, names));
}

bool Lesson::at_defaults() const {
  return std::all_of(parameters_.begin(), parameters_.end(), [](const auto& p) { return p.value == p.initial; });
}

}  // namespace byhand::course
