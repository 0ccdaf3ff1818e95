#pragma once

#include <string>

#include "lessons/page/items.hpp"

namespace byhand::site {

/// A film as one SVG file that a browser, or a slide, plays again and again: 15 pictures a second, but at most
/// `most` of them; pictures that stand for steps, three a second. What is in space is drawn half as fine.
std::string film_file(const course::Sequence& film, int most = 150);

}  // namespace byhand::site
