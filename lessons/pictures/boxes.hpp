#pragma once

#include <vector>

#include "renderer/canvas.hpp"
#include "solver/step.hpp"

namespace byhand::pictures {

/// What a scene of shapes in the plane looks like at one instant: a value, so that a figure or a frame can be
/// drawn later, when the scene has moved on. Fixed bodies have their own look; each body's can be changed.
struct Shapes {
  struct Box {
    int body;
    renderer::Point at, size;  // [m]
    double angle;              // [rad]
    renderer::Look look;
  };
  struct Disc {
    int body;
    renderer::Point at;
    double radius, angle;  // [m], [rad]
    renderer::Look look;
  };
  struct Ground {
    renderer::Point at, normal;  // the normal points out of the solid
  };
  std::vector<Box> boxes = {};
  std::vector<Disc> discs = {};
  std::vector<Ground> grounds = {};
};

/// What the first body of a contact gives the second at a point.
struct Push {
  renderer::Point at, impulse;  // [m], [N s]
};

/// Reads the shapes off a scene.
Shapes shapes_of(const Scene<PlaneBody>& scene);

/// The impulses of all contacts in the last step, normal and friction together, at the points where they act:
/// friction in proportion to what the points press.
std::vector<Push> pushes(const Simulation<PlaneBody>& simulation);

/// Draws shapes in the world of the canvas's camera; the ground reaches to the edges of what it sees.
void draw(renderer::Canvas& canvas, const Shapes& shapes);

/// Draws impulses as arrows from where they act.
void draw(renderer::Canvas& canvas, const std::vector<Push>& pushes, const renderer::ArrowKind& kind);

}  // namespace byhand::pictures
