#pragma once

#include "solver/body.hpp"

namespace byhand {

/// A uniform thin rod in the plane, from one end to the other: where it is and what it weighs.
struct PlaneRod {
  Pose<PlaneBody> pose;  // turned so that the rod lies along the body's x axis
  InverseMass<PlaneBody> mass;

  PlaneRod(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double kilograms) {
    const Eigen::Vector2d along = to - from;
    const double length = along.norm();
    require_positive("length of the rod", length, "m");
    pose.position = 0.5 * (from + to);
    pose.rotation = {along.x() / length, along.y() / length};
    mass = with_mass<PlaneBody>(kilograms, Angular<PlaneBody>(kilograms * length * length / 12));
  }
};

}  // namespace byhand
