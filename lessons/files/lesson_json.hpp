#pragma once

#include <string>

#include "lessons/files/bookmark.hpp"
#include "lessons/files/options.hpp"
#include "lessons/files/output_folder.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/page/recording.hpp"

namespace byhand::course {

/// What manifest.json says of a run beside its files: step, options, method, OpenGL, commit and compiler. There
/// are no dates and no names of machines: the same options give the same bytes, except in the clocked files.
/// `step` is the label of its only step; empty: the whole lesson.
std::string made_by(const Lesson& lesson, const Options& options, const std::string& step, const std::string& gl);

std::string to_json(const Manifest& manifest);

/// The manifest of a lesson or of a site; that of nothing if the text is neither.
Manifest manifest_from_json(const std::string& text);

/// The predictions of the pages, in order, for a course's own quiz: a list of objects with `lesson`, `step`,
/// `ask`, `answer`, `unit`, `tolerance`, `wrong` (each with `value` and `reply`), `hints` and `right`.
std::string questions(const Lesson& lesson, const std::vector<RecordedStep>& steps);

/// {"step":"3a","finished":false}
std::string to_json(const Bookmark& bookmark);

/// The default bookmark if the text is not JSON.
Bookmark bookmark_from_json(const std::string& text);

}  // namespace byhand::course
