#pragma once

#include "solver/contact/manifold.hpp"

namespace byhand {

/// `touch` of two boxes in space, by separating axis and clipping.
Manifold<SpaceBody> touch_boxes(const Box<SpaceBody>& box1, const Pose<SpaceBody>& pose1,
                                const Box<SpaceBody>& box2, const Pose<SpaceBody>& pose2, double margin,
                                std::uint32_t hint);

}  // namespace byhand
