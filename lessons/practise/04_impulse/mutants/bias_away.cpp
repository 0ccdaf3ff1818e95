// JV + b = 0 is wanted: with −JV + b your correction runs away from the target.
#include "practise.hpp"

double lambda(const BodyRow& J, const Velocities& V, double b, double K) { return (-dot(J, V) + b) / K; }
