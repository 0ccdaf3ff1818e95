#include "practise.hpp"

BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d) { return {-d, -cross(r1, d), d, cross(r2, d)}; }
