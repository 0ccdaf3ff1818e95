#include "lessons/practise/judge/unmask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "lessons/practise/judge/judge.hpp"

namespace byhand::practise {
namespace {

Sheet sheet_with(const Exercise& exercise, const Code& code, const std::map<std::string, Numbers>& given) {
  Probe probe(1, 0);
  probe.set(given);
  exercise.probe(probe, code);
  return probe.sheet();
}

const Variant& masked(const Exercise& exercise, const Task& about) {
  const auto found = std::find_if(exercise.variants.begin(), exercise.variants.end(), [&](const Variant& variant) {
    return variant.file == "mutants/" + about.mutant;
  });
  if (found == exercise.variants.end()) throw std::logic_error(exercise.name + " names no mutant to unmask");
  return *found;
}

std::string given_text(const Sheet& sheet) {
  std::string words;
  for (const Line& line : sheet) {
    if (line.kind != Line::Kind::given) continue;
    words += (words.empty() ? "" : " ") + line.name + "=";
    for (std::size_t i = 0; i < line.values.size(); ++i)
      words += fmt::format("{}{:.4g}", i == 0 ? "" : ",", line.values[i]);
  }
  return words;
}

}  // namespace

std::string blind_test(const Exercise& exercise) {
  const Task about = task(exercise);
  return given_text(sheet_with(exercise, masked(exercise, about).code, about.blind));
}

std::string masked_code(const Exercise& exercise) {
  const std::string text = contents_of(exercise.folder() / masked(exercise, task(exercise)).file);
  return text.substr(text.find("#include"));  // after its sentence
}

bool unmask(const Exercise& exercise, const std::string& numbers, std::string& report) {
  const Task about = task(exercise);
  const Variant& mutant = masked(exercise, about);
  auto given = about.blind;
  const Sheet names = sheet_with(exercise, mutant.code, given);
  for (const auto& [name, values] : parse_given(numbers)) {
    const auto known = std::find_if(names.begin(), names.end(), [&, &called = name](const Line& line) {
      return line.kind == Line::Kind::given && line.name == called;
    });
    if (known == names.end())
      throw std::invalid_argument(fmt::format("\"{}\" is not given; these are: {}", name, given_text(names)));
    if (known->values.size() != values.size())
      throw std::invalid_argument(fmt::format("{} has {} number(s)", name, known->values.size()));
    given[name] = values;
  }
  const Sheet right = sheet_with(exercise, exercise.variants.front().code, given),
              wrong = sheet_with(exercise, mutant.code, given);
  const bool same = same_answers(wrong, right);
  report = same ? "It passes this test too: its answers are the right ones for these numbers.\n"
                : fmt::format("Unmasked. {}\n", first_comment(exercise.folder() / mutant.file));
  if (!same)
    for (std::size_t i = 0; i < right.size(); ++i)
      for (std::size_t k = 0; k < right[i].values.size(); ++k)
        if (right[i].kind == Line::Kind::answer && right[i].values[k] != wrong[i].values[k])
          report += fmt::format("  {}: {:.5g}, right is {:.5g} {}\n", right[i].name, wrong[i].values[k],
                                right[i].values[k], right[i].unit);
  return !same;
}

}  // namespace byhand::practise
