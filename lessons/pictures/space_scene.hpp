#pragma once

#include <vector>

#include "renderer/canvas.hpp"
#include "renderer/space.hpp"
#include "solver/scene.hpp"

// Scenes in space, whose y is up, seen in perspective.
namespace byhand::pictures {

/// The camera that sees the whole ball around `centre` [m] in `frame`, from `turned` [rad] to the right of the z
/// axis and `raised` [rad] above the level.
renderer::SpaceCamera from_aside(const renderer::Point3& centre, double radius, const renderer::Rectangle& frame,
                                 double turned = 0.5, double raised = 0.35);

/// A box with full side lengths `sides` [m]; its end towards the body's +y has another colour, which shows the
/// orientation.
void add_book(renderer::Space& space, const Pose<SpaceBody>& pose, const renderer::Point3& sides,
              renderer::Colour colour = renderer::palette::body);

/// The path of a moving point: pale at the first point, in full colour at the last.
void add_trail(renderer::Space& space, const std::vector<renderer::Point3>& points, double thickness,
               renderer::Colour colour);

/// A circle of `radius` [m] around the unit vector `axis` through `centre`, with a line of `thickness` [m].
void add_ring(renderer::Space& space, const renderer::Point3& centre, const renderer::Point3& axis, double radius,
              double thickness, renderer::Colour colour);

}  // namespace byhand::pictures
