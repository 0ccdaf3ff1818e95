#include "lessons/04_baumgarte/plain_bias.hpp"

namespace byhand::baumgarte {

//! [bias]
double plain_bias(double C, double beta, double h) {
  return beta / h * C;  // (22)
}
//! [bias]

}  // namespace byhand::baumgarte
