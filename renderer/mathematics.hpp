#pragma once

#include <span>
#include <vector>

namespace byhand::renderer {

/// A code point of a label without its markup; `level` is 1 in a superscript, −1 in a subscript.
struct LabelSign {
  char32_t code = 0;
  int level = 0;
};

/// For each sign of a label whether it is set in italics, as the letters of quantities are: v, λ, JV, but not
/// units
/// ("2 m", "t (s)"), words, functions ("cos θ"), the T of a transpose and capital Greek letters.
std::vector<bool> italics(std::span<const LabelSign> label);

}  // namespace byhand::renderer
