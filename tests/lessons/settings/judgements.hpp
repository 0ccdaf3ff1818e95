#pragma once

#include <string>
#include <vector>

#include "lessons/page/page.hpp"
#include "tests/lessons/settings/rules.hpp"

namespace byhand::tests {

/// Sentences that judge a computed result and are no verdict of the page: "It stands for 20 s", "8.2 %, hardly
/// more". A number computed by the run is one that neither the reader set (`given`) nor names an equation, a step,
/// a lesson or a law.
std::vector<Finding> unclaimed_judgements(const course::Page& page, const std::vector<std::string>& given);

}  // namespace byhand::tests
