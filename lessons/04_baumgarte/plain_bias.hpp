#pragma once

namespace byhand::baumgarte {

/// b of (21) [1/s times the unit of C] for an error C, the share beta of it that a step of h [s] removes. In the
/// page of this lesson its reader may change it.
double plain_bias(double C, double beta, double h);

}  // namespace byhand::baumgarte
