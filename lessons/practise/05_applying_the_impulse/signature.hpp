#pragma once

#include "practise.hpp"

/// (20): changes V by the impulse λ of one row. W: 1/m and 1/I of both bodies.
void apply_impulse(Velocities& V, const BodyRow& J, double lambda, InverseMasses W);

#define FUNCTIONS apply_impulse
