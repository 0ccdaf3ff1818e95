#pragma once

#include <vector>

// The other algorithm of this lesson in a few lines. The solver's code for any scene is held against it.
namespace byhand::iterations {

/// The x with Ax = `x`, for an A that has numbers on its diagonal and next to it alone.
std::vector<double> plain_elimination(std::vector<double> diagonal, const std::vector<double>& beside,
                                      std::vector<double> x);

}  // namespace byhand::iterations
