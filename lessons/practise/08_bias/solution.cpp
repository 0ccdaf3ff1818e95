#include "practise.hpp"

double bias(double C, double beta, double h) { return beta / h * C; }
