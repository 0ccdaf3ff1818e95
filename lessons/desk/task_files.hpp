#pragma once

#include <filesystem>

#include "lessons/desk/task.hpp"

namespace byhand::desk {

/// The tasks of a folder, in the order of their files' names.
std::vector<Task> read_tasks(const std::filesystem::path& folder);

}  // namespace byhand::desk
