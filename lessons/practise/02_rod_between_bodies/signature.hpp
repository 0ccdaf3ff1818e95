#pragma once

#include "practise.hpp"

/// J of (14). r1, r2 [m]: from each body's centre to its anchor; d [m]: from anchor 1 to anchor 2.
BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d);

#define FUNCTIONS distance_jacobian
