#include "lessons/page/excerpt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "lessons/page/error.hpp"
#include "lessons/page/source_text.hpp"
#include "lessons/page/words.hpp"

namespace byhand::course {
namespace {

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \r") - first + 1);
}

bool is_marker(const std::string& line) {
  const std::string words = trimmed(line);
  return words.starts_with("//! [") && words.ends_with("]");
}

std::string without_common_indentation(const std::vector<std::string>& lines) {
  size_t indentation = std::string::npos;
  for (const std::string& line : lines) indentation = std::min(indentation, line.find_first_not_of(' '));
  std::string code;
  for (const std::string& line : lines) code += (line.size() > indentation ? line.substr(indentation) : "") + "\n";
  return code;
}

}  // namespace

Excerpt read_excerpt(const std::string& root, const std::string& file, const std::string& tag) {
  const std::optional<std::string> text = source_text(root + "/" + file);
  if (!text)
    throw EnvironmentError(
        fmt::format("The source {} cannot be read: the checkout {} is not complete.", file, root));
  const std::string marker = "//! [" + tag + "]";
  Excerpt excerpt{file, 0, ""};
  std::vector<std::string> lines;
  int number = 0, markers = 0;
  for (const std::string_view part : lines_of(*text)) {
    if (markers == 2) break;
    const std::string line(part);
    ++number;
    if (trimmed(line) == marker) {
      ++markers;
    } else if (markers == 1 && !is_marker(line)) {
      if (lines.empty()) excerpt.line = number;
      lines.push_back(line);
    }
  }
  if (markers < 2 || lines.empty())
    throw LessonError(fmt::format("{} has no lines between two markers \"{}\"", file, marker));
  excerpt.code = without_common_indentation(lines);
  return excerpt;
}

}  // namespace byhand::course
