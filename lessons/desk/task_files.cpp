#include "lessons/desk/task_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace byhand::desk {

std::vector<Task> read_tasks(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Task> tasks;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    tasks.push_back(read_task(std::string(std::istreambuf_iterator<char>(file), {})));
  }
  return tasks;
}

}  // namespace byhand::desk
