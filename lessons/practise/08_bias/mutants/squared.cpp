// Double the error and the correction must double; yours is four times as large: the share would change with L.
#include "practise.hpp"

double bias(double C, double beta, double h) { return beta / h * C * C; }
