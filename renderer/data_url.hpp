#pragma once

#include <string>
#include <string_view>

namespace byhand::renderer {

/// Bytes as letters, three as four (RFC 4648).
std::string base64(std::string_view bytes);

/// A PNG file as a URL that holds it, for pages and SVG (RFC 2397, base64).
std::string data_url(std::string_view png);

}  // namespace byhand::renderer
