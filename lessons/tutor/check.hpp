#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/told.hpp"

namespace byhand::tutor {

/// The claims of all steps as a table with a line that counts them.
std::string check_table(const std::vector<Told>& lesson);

/// The claims that are false, one a line; empty if all is well.
std::string false_claims(const Lesson& lesson, const std::vector<Told>& told);

}  // namespace byhand::tutor
