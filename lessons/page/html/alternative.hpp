#pragma once

#include <string>
#include <string_view>

#include "lessons/page/items.hpp"

namespace byhand::site {

/// What a picture shows beyond its caption, for readers who do not see it.
struct Alternative {
  std::string label;  // one line, with the numbers: "Chart of C (m) over time (s). h = 1/60 s: from 0 to 0.436;
                      // …"; may be empty
  std::string words = {};  // all that is known, in prose with a list; empty if that is no more
};

/// Of a chart it is computed from the data; of a drawing it is the texts in its SVG; of a chart that measures
/// running times, which no two runs share, what is measured.
Alternative alternative(const course::Figure& figure, std::string_view svg);
Alternative alternative(const course::Sequence& film, std::string_view svg);

}  // namespace byhand::site
