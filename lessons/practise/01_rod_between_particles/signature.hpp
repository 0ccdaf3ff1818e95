#pragma once

#include "practise.hpp"

/// C of (2) [m²].
double value(Vec2 p1, Vec2 p2, double L);

/// J of that C [m], as in (14).
ParticleRow jacobian(Vec2 p1, Vec2 p2, double L);

#define FUNCTIONS value, jacobian
