#include "lessons/site/live/space_window.hpp"

namespace byhand::site {

renderer::SvgCanvas::DrawWindow space_window() { return {}; }

}  // namespace byhand::site
