#pragma once

#include <string>
#include <vector>

#include "lessons/desk/task.hpp"

namespace byhand::site {

/// The page of the derivation desk with its tasks, desk.html. Its scripts are those that live/build wrote.
/// `exercises`: the site has them.
std::string desk_page(const std::vector<desk::Task>& tasks, bool exercises);

}  // namespace byhand::site
