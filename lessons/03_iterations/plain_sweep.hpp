#pragma once

#include <span>

namespace byhand::iterations {

/// One sweep from the top over a chain of equal links, `L` long [m] with bobs of `m` [kg], that hangs straight
/// down: `v` is how fast each bob moves downwards [m/s], `lambda` the λ of the joint above it. In the page of this
/// lesson its reader may change it.
void plain_sweep(double L, double m, std::span<double> v, std::span<double> lambda);

}  // namespace byhand::iterations
