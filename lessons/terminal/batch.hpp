#pragma once

#include <vector>

#include "lessons/files/options.hpp"
#include "lessons/files/picture_writer.hpp"
#include "lessons/page/recording.hpp"

namespace byhand::course {

/// Runs the whole lesson, or the one step that `options` names, without prompts. Returns the exit status.
int run_batch(const Lesson& lesson, const Options& options);

/// Writes lesson.md beside the pictures if the steps are those of a whole lesson, and manifest.json last.
void finish_output(const Lesson& lesson, const std::vector<RecordedStep>& steps, const Options& options,
                   bool whole, PictureWriter& pictures);

/// Draws and writes every picture of the page.
void write_pictures(const Page& page, PictureWriter& pictures);
}  // namespace byhand::course
