#include "lessons/desk/task.hpp"

#include <algorithm>

namespace byhand::desk {

Task read_task(std::string_view file) {
  Task task;
  while (!file.empty()) {
    const std::size_t end = std::min(file.find('\n'), file.size());
    const std::string_view line = file.substr(0, end);
    file.remove_prefix(std::min(end + 1, file.size()));
    const auto behind = [&](std::string_view word) { return std::string(line.substr(word.size())); };
    if (line.starts_with("# exercise: "))
      task.exercise = behind("# exercise: ");
    else if (line.starts_with("# ") && task.title.empty())
      task.title = behind("# ");
    else if (line.starts_with("# "))
      task.text += (task.text.empty() ? "" : " ") + behind("# ");
    else if (line.starts_with("start "))
      task.start.push_back(behind("start "));
    else if (line.starts_with("goal "))
      task.goal.push_back(behind("goal "));
    else if (!line.empty())
      task.before.emplace_back(line);
  }
  return task;
}

}  // namespace byhand::desk
