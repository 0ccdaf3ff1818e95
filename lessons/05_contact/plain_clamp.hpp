#pragma once

namespace byhand::contact {

/// By how much a sweep changes the λ of a contact at rest (b = 0): `JV` and `K` = JM⁻¹Jᵀ of its row, `lambda` the
/// sum of the changes before. In the page of this lesson its reader may change it.
double plain_change(double JV, double K, double lambda);

}  // namespace byhand::contact
