#pragma once

#include <string>
#include <string_view>

namespace byhand::renderer {

/// A PNG file as a URL that holds it, for pages and SVG (RFC 2397, base64).
std::string data_url(std::string_view png);

}  // namespace byhand::renderer
