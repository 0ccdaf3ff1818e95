#pragma once

#include "lessons/cases/case.hpp"
#include "lessons/page/lesson.hpp"

namespace byhand::cases {

/// The page of a case: the report, the prediction, the run, the cure, what to take away. Its claims hold every
/// prediction against the run.
course::Lesson page_of(const Folder& folder);

}  // namespace byhand::cases
