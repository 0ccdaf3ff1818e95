// JV + b = 0 makes JV = −b, so b = +β/h·C; the minus of (22) is JV's.
#include "practise.hpp"

double bias(double C, double beta, double h) { return -beta / h * C; }
