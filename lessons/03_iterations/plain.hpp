#pragma once

#include "lessons/03_iterations/knobs.hpp"

#include "lessons/scenes/chain.hpp"

// The two algorithms of this lesson in a few lines each, for a chain that hangs straight down. The solver's code
// for any scene is held against them.
namespace byhand::iterations {

/// One sweep from the top: `v` is how fast each bob moves downwards [m/s], `lambda` the λ of the joint above it.
void plain_sweep(const ChainOptions& chain, std::vector<double>& v, std::vector<double>& lambda);

/// The x with Ax = `x`, for an A that has numbers on its diagonal and next to it alone.
std::vector<double> plain_elimination(std::vector<double> diagonal, const std::vector<double>& beside,
                                      std::vector<double> x);

}  // namespace byhand::iterations
