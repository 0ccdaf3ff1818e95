// Look at the units: JV in m/s becomes N·s by a division by K in 1/kg.
#include "practise.hpp"

double lambda(const BodyRow& J, const Velocities& V, double b, double K) { return -(dot(J, V) + b) * K; }
