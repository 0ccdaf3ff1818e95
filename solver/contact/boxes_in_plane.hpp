#pragma once

#include "solver/contact/manifold.hpp"

namespace byhand {

/// `touch` of two boxes in the plane, by separating axis and clipping.
Manifold<PlaneBody> touch_boxes(const Box<PlaneBody>& box1, const Pose<PlaneBody>& pose1,
                                const Box<PlaneBody>& box2, const Pose<PlaneBody>& pose2, double margin,
                                std::uint32_t hint);

}  // namespace byhand
