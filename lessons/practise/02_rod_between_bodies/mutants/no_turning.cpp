// Right for particles; turn body 2 and its anchor moves by ω × r2.
#include "practise.hpp"

BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d) { return {-d, 0 * cross(r1, r2), d, 0}; }
