#pragma once

#include <string>
#include <string_view>

namespace byhand::site {

/// Source in C++ as a block of code, its comments marked.
std::string code_html(std::string_view code);

/// A command or a name within a paragraph or a block. Its options stay whole, which a browser would break at a
/// hyphen.
std::string command_html(std::string_view command);

}  // namespace byhand::site
