#pragma once

#include "practise.hpp"

/// λ of (17). b: the bias, in the unit of JV; K: J M⁻¹ Jᵀ of (19).
double lambda(const BodyRow& J, const Velocities& V, double b, double K);

#define FUNCTIONS lambda
