#pragma once

#include <string>

#include "lessons/tutor/items.hpp"

namespace byhand::site {

/// Pictures as SVG that can stand alone and within a page, with their alternative text. What is in space is drawn
/// with OpenGL and lies in the SVG as PNG: throws renderer::EnvironmentError without it.
std::string svg(const tutor::Figure& figure);
std::string svg(const tutor::Sequence& film, double time);

}  // namespace byhand::site
