// b must have the unit of JV, that of C over s; you multiplied by h where you have to divide.
#include "practise.hpp"

double bias(double C, double beta, double h) { return beta * C * h; }
