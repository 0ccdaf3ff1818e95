#pragma once

#include <vector>

#include "tests/lessons/settings/settings.hpp"

namespace byhand::tests {

/// Settings of a lesson at which one of its sentences was false once.
std::vector<Suggestion> once_false(int lesson);

}  // namespace byhand::tests
