#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/bookmark.hpp"
#include "lessons/tutor/options.hpp"
#include "lessons/tutor/recording.hpp"

namespace byhand::tutor {

/// manifest.json: the options, method and OpenGL version that made the files beside it. It holds no dates and no
/// names of machines: the same options give the same bytes, except in the files that it lists as clocked.
std::string manifest(const Lesson& lesson, const std::vector<RecordedStep>& steps, const Options& options,
                     const std::string& gl);

/// The predictions of the pages, in order, for a course's own quiz: a list of objects with `lesson`, `step`,
/// `ask`, `answer`, `unit`, `tolerance`, `wrong` (each with `value` and `reply`), `hints` and `right`.
std::string questions(const Lesson& lesson, const std::vector<RecordedStep>& steps);

/// {"step":"3a","finished":false}
std::string to_json(const Bookmark& bookmark);

/// The default bookmark if the text is not JSON.
Bookmark bookmark_from_json(const std::string& text);

}  // namespace byhand::tutor
