#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {

void say_where_else(Page& page) {
  page.text(R"(Where you will meet this again, under other names:)");
  page.table(
      {"here", "in mechanics and optimisation", "in engines"},
      {{"λ", "the Lagrange multiplier of J(V + ΔV) = 0 where ½ΔVᵀMΔV is least; with bounds a KKT multiplier",
        "accumulated impulse"},
       {"JM⁻¹Jᵀ",
        "Schur complement, or Delassus operator; in robotics the inverse of the operational-space inertia",
        "its inverse is the effective mass"},
       {"JV = 0 in place of C = 0", "index reduction: the constraint, differentiated once", "velocity constraint"},
       {"M ΔV = Jᵀλ, JΔV = −JV", "a KKT system, solved here for λ first", "constraint solver"},
       {"one row after another (lesson 3)", "Gauss–Seidel; with bounds (lesson 5) projected Gauss–Seidel, PGS",
        "sequential impulses, SI"},
       {"β (lesson 4)", "Baumgarte stabilisation", "ERP in ODE and Bullet"},
       {"softness γ (lesson 6)", "regularisation of JM⁻¹Jᵀ", "CFM in ODE; hertz and damping ratio in Box2D"},
       {"the angle θ in place of (x, y) and λ", "generalised coordinates", "articulations, multibodies"}});
}

}  // namespace byhand::single_constraint
