#pragma once

#include "lessons/02_single_constraint/setting.hpp"

namespace byhand::single_constraint {

/// A rod, its bobs and what acts on them, seen close enough for arrows of half the rod's length.
struct BobPicture {
  struct Arrow {
    Vector from, by;  // [m]: what is shown, scaled by whoever fills this in
    renderer::Colour colour;
    std::string label;
    double width = 4;
    renderer::Dash dash = renderer::Dash::solid;
    double aside = 0;  // drawn so many points to the left of its way, off a rod that it would cover
  };
  explicit BobPicture(const Pendulum& scene);

  std::string title = {};
  std::vector<Arrow> arrows = {};
  bool guides = true;  // dashed: the way of d beyond the second body, and the tangent

  pictures::Linkage linkage;
  Vector first, second;  // where the two bodies are [m]
};

/// Pictures side by side over the whole page, all at one scale.
void draw(renderer::Canvas& canvas, const std::vector<BobPicture>& pictures);

}  // namespace byhand::single_constraint
