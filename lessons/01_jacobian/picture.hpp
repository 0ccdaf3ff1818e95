#pragma once

#include "lessons/01_jacobian/pair.hpp"

namespace byhand::lesson01 {

/// A vector in words: "(1.2, −1.6)"; in LaTeX as well.
course::Value vector(const Linear<PlaneBody>& v);

/// What `draw` shows besides boxes, rod and arms: the names of P₁, P₂ and d, those of the arms, and a rod that is
/// pale, so that the parts of J stand out.
struct PairLook {
  bool ends_named = true, arms_named = true, pale_rod = false;
};

/// The boxes, the rod, the arms and their names, in the world of the canvas's camera.
void draw(renderer::Canvas& canvas, const Pair& pair, const Linear<PlaneBody>& sides, const PairLook& look = {});

/// The four parts of a row on its two bodies: l as an arrow from the centre, `scale` world units for one unit of
/// l, and a as a bow round it, `radius` wide, that opens the farther the larger it is. The texts of a stand at a
/// place beside the centre, in the world.
struct RowArrows {
  double scale = 1, radius = 0.3;
  std::string l1 = {}, a1 = {}, l2 = {}, a2 = {};
  renderer::Point a1_aside{0, 0}, a2_aside{0, 0};
};
void draw_row(renderer::Canvas& canvas, const Jacobian<PlaneBody, 1>& J, const renderer::Point& centre1,
              const renderer::Point& centre2, const RowArrows& arrows);

/// A bow with a head at its end: from the angle `from` [rad] round `centre`, opened by `turn` [rad], anticlockwise
/// if positive.
void draw_bow(renderer::Canvas& canvas, const renderer::Point& centre, double radius, double from, double turn,
              const renderer::Stroke& stroke);

}  // namespace byhand::lesson01
