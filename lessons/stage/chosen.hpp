#pragma once

#include "lessons/page/page.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::stage {

/// Asks the chooser which method is the cheapest for what the file wants accurate, which keeps half of that as a
/// margin, and which is ten times as accurate; each with its errors, cost and code.
void show_chosen(course::Page& page, const SceneFile& file);

}  // namespace byhand::stage
