// Division comes before subtraction: K divides only your b, where it has to divide JV + b.
#include "practise.hpp"

double lambda(const BodyRow& J, const Velocities& V, double b, double K) { return -dot(J, V) - b / K; }
