#pragma once

#include <vector>

#include "renderer/canvas.hpp"
#include "solver/scene.hpp"

namespace byhand::pictures {

/// What a scene in the plane looks like at one instant: a value, so that a figure or a frame can be drawn later,
/// when the scene has moved on.
struct Linkage {
  struct Bob {
    renderer::Point at;
    double mass;  // [kg]
  };
  struct Bar {
    renderer::Point from, to;
  };
  std::vector<Bob> bobs = {};   // bodies that move, held by rods
  std::vector<Bar> rods = {};   // massless rods: Distance, NormalisedDistance
  std::vector<Bar> links = {};  // bodies that move, held by pins: from the first pin through the centre
  std::vector<renderer::Point> hinges = {};   // pins between two bodies that move
  std::vector<renderer::Point> anchors = {};  // where the world holds the scene
};

/// Reads the linkage off a scene of particles or bodies in the plane, held by rods, ropes, springs and pins. A
/// fixed body shows only where a constraint leans on it.
template <class M>
Linkage rods_and_bobs(const Scene<M>& scene);

struct LinkageStyle {
  double bob = 15;   // radius of the lightest bob [points]; heavier ones grow as balls of one material, with the
                     // cube root of the mass
  double rod = 6;    // thickness [points]
  double link = 16;  // thickness [points]
  renderer::Look rods{renderer::palette::constraint, {renderer::palette::ink, 0}};
  renderer::Look bodies = renderer::body_look;
};

/// Draws a linkage in the world of the canvas's camera.
void draw(renderer::Canvas& canvas, const Linkage& linkage, const LinkageStyle& style = {});

/// Radius of a bob as it is drawn [points].
double bob_radius(const Linkage& linkage, const Linkage::Bob& bob, const LinkageStyle& style = {});

}  // namespace byhand::pictures
