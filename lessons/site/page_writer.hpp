#pragma once

#include <vector>

#include "lessons/tutor/options.hpp"
#include "lessons/tutor/recording.hpp"

namespace byhand::site {

/// Writes the page of a lesson, NN_slug.html, and its digest for the site's other pages, NN_slug.json, into the
/// folder of the site. Its pictures are those that a PictureWriter has written into NN_slug/ beside it.
void write_page(const tutor::Lesson& lesson, const std::vector<tutor::RecordedStep>& steps,
                const std::filesystem::path& folder);

}  // namespace byhand::site
