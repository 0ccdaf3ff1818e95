#pragma once

#include <string>
#include <vector>

#include "lessons/page/page.hpp"
#include "renderer/chart.hpp"

namespace byhand::tests {

/// A rule that a page breaks, and the words that break it.
struct Finding {
  std::string rule, words;
};

/// What one item says, one string for each part that is read by itself: a paragraph, an option, a caption.
std::vector<std::string> passages(const course::Item& item);

/// The rules for words: numbers have a meaning, and one is not many. A number that the reader set may have any
/// size: `given` lists these as they were typed.
std::vector<Finding> broken_rules(const std::string& words, const std::vector<std::string>& given = {});

/// The rules for a chart: it shows something, and more than rounding unless the caption says so.
std::vector<Finding> broken_rules(const renderer::Chart& chart, const std::string& caption);

/// All rules for a page: those above, claims that hold, and answers that stay apart.
std::vector<Finding> broken_rules(const course::Page& page, const std::vector<std::string>& given = {});

}  // namespace byhand::tests
