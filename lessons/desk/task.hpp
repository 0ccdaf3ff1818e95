#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace byhand::desk {

/// A worked task: lines of the sheet that come before, those that it starts with, and one way to the goal.
struct Task {
  std::string title, text, exercise;
  std::vector<std::string> before, start, goal;
};

/// From a file of tasks/: a title and text behind "#", lines of a sheet, "start …" and "goal …".
Task read_task(std::string_view file);

}  // namespace byhand::desk
