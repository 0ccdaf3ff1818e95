#pragma once

#include "practise.hpp"

/// K = J M⁻¹ Jᵀ of (19). Masses [kg], moments of inertia [kg m²].
double inverse_effective_mass(const BodyRow& J, double m1, double I1, double m2, double I2);

#define FUNCTIONS inverse_effective_mass
