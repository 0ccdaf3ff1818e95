#pragma once

#include <string>

#include "lessons/tutor/items.hpp"

namespace byhand::site {

/// A picture as an SVG element. Ids in it begin with `name`; `words` describe it to readers who do not see it.
std::string drawn(const std::string& name, const std::string& caption, const std::string& words,
                  const tutor::Drawing& drawing);
std::string drawn(const tutor::Figure& figure, const std::string& words);

}  // namespace byhand::site
