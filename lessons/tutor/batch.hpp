#pragma once

#include <vector>

#include "lessons/tutor/options.hpp"
#include "lessons/tutor/picture_writer.hpp"
#include "lessons/tutor/recording.hpp"

namespace byhand::tutor {

/// Runs the whole lesson, or the one step that `options` names, without prompts. Returns the exit status.
int run_batch(const Lesson& lesson, const Options& options);

/// Writes lesson.md and manifest.json beside the pictures, and prints where.
void write_page(const Lesson& lesson, const std::vector<RecordedStep>& steps, const Options& options,
                const PictureWriter& pictures);

/// Draws and writes every picture of the page.
void write_pictures(const Page& page, PictureWriter& pictures);

/// Creates the lesson's output folder unless only claims are checked. Throws renderer::EnvironmentError if it
/// cannot.
PictureWriter picture_writer(const Lesson& lesson, const Options& options);

}  // namespace byhand::tutor
