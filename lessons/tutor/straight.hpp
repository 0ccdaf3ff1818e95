#pragma once

#include <vector>

#include "lessons/tutor/options.hpp"
#include "lessons/tutor/studio.hpp"
#include "lessons/tutor/told.hpp"

namespace byhand::tutor {

/// The whole lesson (or the one step that `options` names) without a prompt. Returns the exit status.
int run_straight(const Lesson& lesson, const Options& options);

/// Writes lesson.md and manifest.json beside the pictures that were drawn, and says where.
void publish(const Lesson& lesson, const std::vector<Told>& told, const Options& options, const Studio& studio);

/// Draws and writes every picture of the page.
void write_pictures(const Page& page, Studio& studio);

Studio studio_of(const Lesson& lesson, const Options& options);

}  // namespace byhand::tutor
