#pragma once

#include <vector>

#include "renderer/canvas.hpp"
#include "renderer/space.hpp"
#include "solver/scene.hpp"

// Scenes in space, whose y is up, seen in perspective.
namespace byhand::pictures {

/// The camera that sees the whole ball around `centre` [m] in `frame`, from `turned` [rad] to the right of the z
/// axis and `raised` [rad] above the level.
renderer::SpaceCamera from_aside(const Eigen::Vector3d& centre, double radius, const renderer::Rectangle& frame,
                                 double turned = 0.5, double raised = 0.35);

/// A box with full side lengths `sides` [m], its end towards the body's +y in another colour, so that one sees
/// which way up it is.
void add_book(renderer::Space& space, const Pose<SpaceBody>& pose, const Eigen::Vector3d& sides,
              renderer::Colour colour = renderer::palette::body);

/// Where something has been: pale at its first point, in full colour at its last.
void add_trail(renderer::Space& space, const std::vector<Eigen::Vector3d>& points, double thickness,
               renderer::Colour colour);

/// A circle of `radius` [m] around the unit vector `axis` through `centre`, with a line of `thickness` [m].
void add_ring(renderer::Space& space, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius,
              double thickness, renderer::Colour colour);

}  // namespace byhand::pictures
