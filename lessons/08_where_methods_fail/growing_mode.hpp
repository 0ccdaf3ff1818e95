#pragma once

#include "lessons/tutor/lesson.hpp"

namespace byhand::failures {

/// The film of an explicit spring beyond its limit: its mode grows by the same factor in each step.
void growing_mode(tutor::Page& page);

}  // namespace byhand::failures
