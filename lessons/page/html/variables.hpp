#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace byhand::site {

/// Bytes of a text that name quantities: JV, λ̇.
struct Variables {
  std::size_t begin, end;
};
/// Those of a paragraph of prose, in their order, by the rules of a picture's labels and those of English: an
/// article "A", "step 7b", "C++", "2D", initials and abbreviations name no quantity.
std::vector<Variables> variables_in(std::string_view prose);

/// Such letters as MathML, each with its accent, as a display has them.
std::string variables_html(std::string_view letters);

}  // namespace byhand::site
