#pragma once

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// The load μ = mga/κ at which a column of N boxes of height a buckles whose faces answer a turn θ by κθ, the
/// lowest by base × κθ: 7.837/N³ for many boxes.
double buckling_load(int boxes, double base);

/// 1/m_eff of the contact at a corner of two boxes of 1 kg [1/kg].
double inverse_mass_of_a_corner(const BoxSize& size);

/// The softest contacts [Hz] on which a column of boxes of 1 kg stands.
double softest_contacts(int boxes, const BoxSize& size = {});

/// Law 17: soft contacts buckle.
Law buckling();

}  // namespace byhand::laws
