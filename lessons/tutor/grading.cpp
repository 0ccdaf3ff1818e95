#include "lessons/tutor/grading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "lessons/tutor/parameter.hpp"

namespace byhand::tutor {
namespace {

std::string without_unit(std::string typed, const std::string& unit) {
  if (!unit.empty() && typed.size() > unit.size() && typed.ends_with(unit))
    typed.resize(typed.size() - unit.size());
  typed.erase(typed.find_last_not_of(' ') + 1);
  return typed;
}

}  // namespace

Grade grade(const Prediction& question, const std::string& typed) {
  double value = 0;
  try {
    value = read_number(without_unit(typed, question.unit));
  } catch (const std::invalid_argument& bad) {
    return {false, false,
            fmt::format("{}: type your prediction{}, or `?` for what else can be typed.", bad.what(),
                        question.unit.empty() || question.unit == "1" ? "" : " in " + question.unit)};
  }
  const auto near = [&](double answer) { return std::abs(value - answer) <= question.tolerance; };
  if (near(question.answer)) return {true, true, question.right};
  for (const WrongAnswer& wrong : question.wrong)
    if (near(wrong.value)) return {false, true, wrong.reply};
  if (near(-question.answer)) return {false, true, "The size is right; think about the sign."};
  return {false, true, value < question.answer ? "It is more than that." : "It is less than that."};
}

Grade grade(const Choice& question, const std::string& typed) {
  for (size_t i = 0; i < question.options.size(); ++i)
    if (typed == std::to_string(i + 1) || typed == question.options[i].words)
      return {static_cast<int>(i) == question.answer, true, question.options[i].reply};
  return {false, false,
          fmt::format("\"{}\" is not one of them: type a number from 1 to {}, or `?` for what else can be typed.",
                      typed, question.options.size())};
}

}  // namespace byhand::tutor
