// A small error stays for ever: engines tolerate one between bodies that touch, but (21) has no threshold.
#include "practise.hpp"

double bias(double C, double beta, double h) { return std::fabs(C) < 0.01 ? 0 : beta / h * C; }
