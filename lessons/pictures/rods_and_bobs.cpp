#include "lessons/pictures/rods_and_bobs.hpp"

#include <algorithm>
#include <cmath>

namespace byhand::pictures {

using renderer::Canvas;
using renderer::Point;

double bob_radius(const Linkage& linkage, const Linkage::Bob& bob, const LinkageStyle& style) {
  double lightest = bob.mass;
  for (const Linkage::Bob& other : linkage.bobs) lightest = std::min(lightest, other.mass);
  return style.bob * std::cbrt(bob.mass / lightest);
}

void draw(Canvas& canvas, const Linkage& linkage, const LinkageStyle& style) {
  for (const Point& at : linkage.anchors) canvas.anchor(at);
  for (const Linkage::Bar& rod : linkage.rods) canvas.rod(rod.from, rod.to, style.rods, style.rod);
  for (const Linkage::Bar& link : linkage.links) canvas.rod(link.from, link.to, style.bodies(), style.link);
  for (const Linkage::Bob& bob : linkage.bobs)
    canvas.disc(bob.at, bob_radius(linkage, bob, style) / canvas.camera().scale, style.bodies());
  for (const Point& at : linkage.hinges) canvas.hinge(at);
  for (const Point& at : linkage.anchors) canvas.hinge(at);
}

}  // namespace byhand::pictures
