// Without the minus, your impulse doubles JV + b instead of ending it.
#include "practise.hpp"

double lambda(const BodyRow& J, const Velocities& V, double b, double K) { return (dot(J, V) + b) / K; }
