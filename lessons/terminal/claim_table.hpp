#pragma once

#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::course {

/// All claims as a table, with a last line that counts the verdicts.
std::string claim_table(const std::vector<RecordedStep>& steps);

/// One line for each false claim; empty if there is none.
std::string false_claims(const Lesson& lesson, const std::vector<RecordedStep>& steps);

}  // namespace byhand::course
