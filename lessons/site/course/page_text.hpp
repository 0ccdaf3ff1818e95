#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace byhand::site {

/// What stands in <main> of a page of the site, without what only a browser with scripts has a use for: fields and
/// links to files.
std::string content_of_page(const std::filesystem::path& page);

void replace_all(std::string& text, std::string_view what, std::string_view by);
/// Replaces every stretch from `begin` to `end`.
void replace_all(std::string& text, std::string_view begin, std::string_view end, std::string_view by);

}  // namespace byhand::site
