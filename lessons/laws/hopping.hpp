#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// The β up to which contacts settle whose slowest mode keeps the share q of its error: about 0.35 to 0.45 of
/// (1 - q)/q for q from 0.8 to 1.
double largest_beta_of_contacts(double q);

/// The mass [kg] up to which a box of 1 kg bears another one.
double heaviest_top(int sweeps, double beta);

/// Law 9: heavy on light.
Law heavy_on_light();

/// Law 19: warm start with Baumgarte on contacts.
Law hopping();

}  // namespace byhand::laws
