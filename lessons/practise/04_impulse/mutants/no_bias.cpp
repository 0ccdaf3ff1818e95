// Right while b = 0; you left b out.
#include "practise.hpp"

double lambda(const BodyRow& J, const Velocities& V, double b, double K) { return -dot(J, V) / K + 0 * b; }
