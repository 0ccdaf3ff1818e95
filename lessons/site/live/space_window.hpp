#pragma once

#include "lessons/site/live/program.hpp"

namespace byhand::site {

/// What draws scenes in space into the pictures of this page; nothing for a lesson in the plane.
DrawWindows space_windows();

}  // namespace byhand::site
