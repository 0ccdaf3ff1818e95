#pragma once

#include <string>
#include <string_view>

namespace byhand::renderer {

/// Text for XML and HTML: <, >, & and " as entities.
std::string escaped(std::string_view text);

/// Bytes as base64 (RFC 4648), without line breaks.
std::string base64(std::string_view bytes);

}  // namespace byhand::renderer
