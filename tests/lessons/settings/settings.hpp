#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "lessons/page/lesson.hpp"

namespace byhand::tests {

/// Parameters and their values as a reader types them; the others keep their defaults.
using Setting = std::vector<std::pair<std::string, std::string>>;

/// What a command such as "./lessons/run 4 --step 6b --set sweeps=8" asks of a lesson.
struct Suggestion {
  std::string step;  // empty: all
  Setting setting;
};
Suggestion suggestion(const std::string& command);
/// Those of a lesson's closing.
std::vector<Suggestion> suggestions(const course::Closing& closing);

/// The ends of the range, or each of the choices.
std::vector<std::string> ends(const course::ParameterRecord& parameter);

/// A value in the range with three digits: uniform, or log-uniform where the range spans a decade. A range that
/// begins at zero gives zero now and then, and small numbers as often as large ones.
std::string any_value(const course::ParameterRecord& parameter, std::mt19937& random);

/// The options "--set a=1 --set b=2", each with a blank before it.
std::string options(const Setting& setting);

}  // namespace byhand::tests
