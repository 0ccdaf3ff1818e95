#pragma once

#include "lessons/07_space/setting.hpp"
#include "lessons/exact/heavy_top.hpp"

namespace byhand::space {

inline constexpr double arm = 0.3, wheel = 0.25, wheel_rate = 60;  // [m], [m], [rad/s]
inline constexpr double level = pi / 2;                            // the lean of an axle that is level [rad]

/// A thin wheel at the end of an axle that stands on a post by its other end.
HeavyTop gyroscope_of(double mass);

}  // namespace byhand::space
