#include "lessons/site/live/space_window.hpp"

namespace byhand::site {

DrawWindows space_windows() { return {}; }

}  // namespace byhand::site
