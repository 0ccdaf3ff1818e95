#pragma once

#include "lessons/08_where_methods_fail/setting.hpp"

namespace byhand::failures {

/// The film of an explicit spring beyond its limit: its mode grows by the same factor in each step.
void growing_mode(course::Page& page);

}  // namespace byhand::failures
