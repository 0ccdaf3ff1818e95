#pragma once

#include <string>
#include <vector>

#include "lessons/page/page.hpp"
#include "tests/lessons/settings/rules.hpp"

namespace byhand::tests {

/// What one picture shows wrongly: bodies and heads of arrows that the edge of their panel or of the page cuts
/// off, letters beyond the page, and labels that cover each other.
std::vector<Finding> out_of_frame(const course::Drawing& draw, const std::string& caption);

/// The same for all pictures of a page, and of each sequence for nine frames, the first of which shows a body.
std::vector<Finding> out_of_frame(const course::Page& page);

}  // namespace byhand::tests
