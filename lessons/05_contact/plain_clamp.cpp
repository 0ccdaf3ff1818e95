#include "lessons/05_contact/plain_clamp.hpp"

#include <cmath>

namespace byhand::contact {

//! [clamp]
double plain_change(double JV, double K, double lambda) {
  const double change = -JV / K;                    // (17) with b = 0
  return std::fmax(0.0, lambda + change) - lambda;  // the sum stays at zero or above
}
//! [clamp]

}  // namespace byhand::contact
