#include "lessons/page/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lessons/page/grading.hpp"
#include "lessons/page/progress.hpp"

namespace byhand::course {
namespace {

void drop_ambiguous_answers(Prediction& question, bool at_defaults) {
  std::vector<double> answers = {question.answer};
  if (std::isfinite(question.hinted)) answers.push_back(question.hinted);
  std::vector<WrongAnswer> kept;
  for (WrongAnswer& wrong : question.wrong) {
    const auto meets = [&](double other) { return !(std::abs(wrong.value - other) > question.tolerance); };
    if (std::none_of(answers.begin(), answers.end(), meets)) {
      answers.push_back(wrong.value);
      kept.push_back(std::move(wrong));
    } else if (at_defaults) {
      throw LessonError(fmt::format("\"{}\": the answer {} lies within {} of another", question.ask, wrong.value,
                                    question.tolerance));
    }
  }
  question.wrong = std::move(kept);
}

/// An answer that is refused when it is typed as it is printed helps nobody.
void require_acceptable(const Prediction& question) {
  const std::string printed = printed_answer(question);
  if (!grade(question, printed).right)
    throw LessonError(fmt::format("\"{}\": the answer {} would be refused if typed so", question.ask, printed));
}

}  // namespace

RecordedStep record_step(const Lesson& lesson, const Step& step, bool quiet) {
  Progress progress(fmt::format("step {}: {}", step.label, step.title), 0, quiet);
  RecordedStep recorded{&step, {}};
  recorded.page.watch(&progress);
  step.run(recorded.page);
  recorded.page.watch(nullptr);
  for (Item& item : recorded.page.items())
    if (auto* question = std::get_if<Prediction>(&item)) drop_ambiguous_answers(*question, lesson.at_defaults());
  return recorded;
}

void forget_reads(const Lesson& lesson) {
  for (const ParameterRecord& parameter : lesson.parameters()) parameter.was_read = false;
}

std::vector<std::string> reads(const Lesson& lesson) {
  std::vector<std::string> names;
  for (const ParameterRecord& parameter : lesson.parameters())
    if (parameter.was_read) names.push_back(parameter.name);
  return names;
}

void validate(const std::vector<RecordedStep>& steps) {
  bool claimed = false;
  std::set<std::string> names;
  const auto require_new = [&](const std::string& name) {
    if (!names.insert(name).second) throw LessonError(fmt::format("two pictures are called {}", name));
  };
  for (const RecordedStep& recorded : steps) {
    for (const Item& item : recorded.page.items()) {
      if (const auto* figure = std::get_if<Figure>(&item)) require_new(figure->name);
      if (const auto* sequence = std::get_if<Sequence>(&item)) require_new(sequence->name);
      if (const auto* question = std::get_if<Prediction>(&item)) require_acceptable(*question);
      claimed = claimed || std::holds_alternative<Claim>(item);
    }
  }
  if (!claimed) throw LessonError("a lesson needs at least one claim");
}

std::vector<Claim> claims(const Page& page) {
  std::vector<Claim> all;
  for (const Item& item : page.items())
    if (const auto* claim = std::get_if<Claim>(&item)) all.push_back(*claim);
  return all;
}

}  // namespace byhand::course
