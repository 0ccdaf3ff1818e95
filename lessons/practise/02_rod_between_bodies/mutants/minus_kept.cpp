// Your a2 kept the minus of a1: swap the bodies, and J must change its sign as a whole.
#include "practise.hpp"

BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d) { return {-d, -cross(r1, d), d, -cross(r2, d)}; }
