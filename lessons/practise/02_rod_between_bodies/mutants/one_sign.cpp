// Swap the bodies: J must change its sign as a whole, and your two a have the same sign.
#include "practise.hpp"

BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d) { return {-d, cross(r1, d), d, cross(r2, d)}; }
