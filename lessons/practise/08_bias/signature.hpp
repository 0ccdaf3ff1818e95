#pragma once

#include "practise.hpp"

/// b of (21) that takes away the share β of the error C in one step of h [s].
double bias(double C, double beta, double h);

#define FUNCTIONS bias
