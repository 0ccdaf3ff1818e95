// β must be without unit, and yours is a rate: at 120 Hz your error decays half as fast per step.
#include "practise.hpp"

double bias(double C, double beta, double h) { return beta * C + 0 * h; }
