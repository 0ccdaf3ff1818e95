#pragma once

#include <string>
#include <vector>

#include "lessons/site/digest.hpp"

namespace byhand::site {

/// The laws of failure as one table that fits a printed page: each law's formula, where it was held against an
/// experiment, and the step of the lesson that measures it.
std::string law_table(const std::vector<Digest>& lessons);

}  // namespace byhand::site
