// Both bodies turn about the arm of body 2: each anchor has an arm of its own.
#include "practise.hpp"

BodyRow distance_jacobian(Vec2, Vec2 r2, Vec2 d) { return {-d, -cross(r2, d), d, cross(r2, d)}; }
