// Triple product: d·(ω × r) = ω·(r × d), and you have d × r.
#include "practise.hpp"

BodyRow distance_jacobian(Vec2 r1, Vec2 r2, Vec2 d) { return {-d, -cross(d, r1), d, cross(d, r2)}; }
