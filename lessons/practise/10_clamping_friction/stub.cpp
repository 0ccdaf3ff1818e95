#include "practise.hpp"

double clamp_friction(double& accumulated, double delta, double mu, double normal) { not_written_yet(); }

void solve_contact(Contact& c, Velocities& V) { not_written_yet(); }
