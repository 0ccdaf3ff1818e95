#pragma once

#include <string>
#include <string_view>

namespace byhand::site {

/// Source in C++ as a block of code, its comments marked.
std::string code_html(std::string_view code);

}  // namespace byhand::site
