#pragma once

#include <string>
#include <string_view>

#include "lessons/page/html/escaped.hpp"

namespace byhand::site {

/// One paragraph of an item's prose, whose *emphasis*, **strong** and `code` become elements. "(14)" links to
/// equation 14 of the article unless the paragraph is a link itself.
enum class Links { equations, none };
std::string inline_html(std::string_view words, Links links = Links::equations);

/// Prose with paragraphs and lists (see course::Page).
std::string prose_html(std::string_view words);

/// Prose without its marks, for a search and for attributes.
std::string plain_text(std::string_view words);

}  // namespace byhand::site
