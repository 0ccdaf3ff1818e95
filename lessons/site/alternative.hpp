#pragma once

#include <string>

#include "lessons/tutor/items.hpp"

namespace byhand::site {

/// What a picture shows, in prose with the numbers, for readers who do not see it. Of a chart that measures
/// running times, which no two runs share, only what is measured. Empty if nothing is known but the caption.
std::string alternative(const tutor::Figure& figure);
std::string alternative(const tutor::Sequence& film);

}  // namespace byhand::site
