// Right while both arms are equal; you used r1 for body 2 as well.
#include "practise.hpp"

BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d) { return {-d, -cross(r1, d), d, cross(r1, d) + 0 * r2.x}; }
