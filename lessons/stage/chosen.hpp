#pragma once

#include "lessons/page/page.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::stage {

inline constexpr double usual_patience = 40;  // [s]

/// Asks the chooser which method is the cheapest for what the file wants accurate, which keeps half of that as a
/// margin, and which is ten times as accurate; each with its errors, cost and code. It answers after some 10 s;
/// where it has found nothing by then, or its time was up and the reader allows more than usual, it goes on for as
/// long as the reader's `patience` [s], and shows what comes nearest.
void show_chosen(course::Page& page, const SceneFile& file, double patience);

}  // namespace byhand::stage
