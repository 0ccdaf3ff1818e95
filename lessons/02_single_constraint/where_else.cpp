#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {

void say_where_else(Page& page) {
  page.text(R"(Where you will meet this again, under other names:)");
  page.table(
      {"here", "in mechanics and optimisation", "in engines"},
      {{"λ", "the Lagrange multiplier of J(V + ΔV) = 0 where ½ΔVᵀMΔV is least; with bounds a KKT multiplier",
        "applied impulse; summed over the iterations: accumulated impulse (lesson 3)"},
       {"JM⁻¹Jᵀ",
        "Schur complement, or Delassus operator; in robotics the inverse of the operational-space inertia",
        "its inverse is the effective mass"},
       {"JV = 0 in place of C = 0", "index reduction: the constraint, differentiated once", "velocity constraint"},
       {"M ΔV = Jᵀλ, JΔV = −JV", "a KKT system, solved here for λ first", "constraint solver"}});
}

}  // namespace byhand::single_constraint
