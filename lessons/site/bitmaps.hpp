#pragma once

#include <string>

namespace byhand::site {

/// Markup in which each bitmap of an SVG is loaded once it is seen: an HTML image within the SVG, for SVG's own is
/// loaded with the page.
std::string loaded_when_seen(std::string markup);

/// The same markup with SVG's own images again, for what is not a web page.
std::string loaded_at_once(std::string markup);

}  // namespace byhand::site
