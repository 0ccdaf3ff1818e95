#pragma once

#include "lessons/methods/generalised.hpp"
#include "lessons/methods/rattle.hpp"

// Accuracy as the input: a tolerance in metres of error per second of motion takes the place of substeps.
//
// A rule of order p errs by e ∝ hᵖ⁺¹ in a substep h [s]. If e <= tolerance × h in each substep, the whole error is
// at most tolerance × time × the growth of a disturbance, and it is proportional to the tolerance. (With e <=
// tolerance, however short the substep, the error of a rule of order 2 would follow tolerance^⅔.) A substep with a
// larger e is taken back. The next one to try is, with r = tolerance × h/e and r₋ that of the substep before,
//
//   0.9 h (r²/r₋)^(3/8p),    at least h/5 and at most 5h.
//
// This is a proportional and integral controller: where stability limits the step, it finds that limit and stays
// there. The first substep, and one after a substep that was taken back, has no r₋ and uses 0.9 h r^(1/p). If
// Newton's method does not converge, e is infinite. The rest of a step is cut into equal parts that are no longer.
//
// A tolerance that rounding does not allow is refused, after few attempts: there e/h grows as h becomes smaller.
//
// e is a displacement of a body's points at its radius of gyration (displacement.hpp). It is estimated
//
//   for RATTLE          without a further solve: from where the substep has led to where the mean of the
//                       velocities at its two ends leads. In free flight with acceleration a these places are
//                       x₀ + hV₀ + ½h²a₀ and x₀ + hV₀ + ¼h²(a₀ + a₁). They differ by h³ȧ/4, and the rule's own
//                       error is h³ȧ/6. p = 2.
//   for Generalised     by Fehlberg's pair: five slopes give a rule of order 4, which is used, and a sixth slope
//                       gives one of order 5 to compare it with. The difference of their velocities counts for
//                       another h, because long substeps err in velocities first. p = 4.
//
// The rule of order 5 would be more accurate, but its error would follow tolerance^(5/4). Varying substeps cost
// RATTLE its bounded error of energy, so that over many periods a fixed substep is cheaper.
//
// Sources: E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, §II.4; K. Gustafsson,
// Control theoretic techniques for stepsize selection in explicit Runge–Kutta methods, ACM Trans. Math. Softw. 17,
// 1991; Fehlberg's numbers are in generalised.cpp.
namespace byhand {

/// Rattle or Generalised with substeps of its own choice.
template <class Method>
struct Controlled {
  template <class M>
  struct Work : Method::template Work<M> {
    double next = 0;              // the substep to try next [s]; 0 for a tenth of the step
    double room = 0;              // r of the last substep; 0 for none
    int tried = 0, rejected = 0;  // substeps of the last step, and how many of them were taken back
  };

  double tolerance = 1e-4;      // error per second of motion [m/s] > 0
  int most_substeps = 100'000;  // tried in a step >= 1
};

template <class Method>
void require_valid(const Controlled<Method>& method) {
  require_positive("tolerance", method.tolerance, "m/s");
  require(method.most_substeps >= 1, "largest number of substeps", method.most_substeps, "at least 1");
}
template <class M>
std::string refusal(const Scene<M>& scene, const Controlled<Generalised>&) {
  return refusal(scene, Generalised());
}
/// RATTLE damps and then pulls, in both halves of a substep: that is of order 1, and the estimate does not see it.
template <class M>
std::string refusal(const Scene<M>& scene, const Controlled<Rattle>&) {
  const Bodies<M>& bodies = scene.bodies();
  for (int i = 0; i < std::ssize(bodies.forces); ++i)
    if (moves(bodies.inverse_mass[i]) &&
        (bodies.forces[i].linear_damping != 0 || bodies.forces[i].angular_damping != 0))
      return "RATTLE keeps no tolerance where bodies are damped, and body " + std::to_string(i) +
             " is; take generalised coordinates";
  return refusal(scene, Rattle());
}

/// A start off the constraints is put onto them. Throws also NoConvergence for a tolerance that cannot be kept
/// with so many substeps, and SingularSystem as RATTLE does.
template <class M, class Method>
void advance(Scene<M>& scene, const Controlled<Method>& method, double step,
             typename Controlled<Method>::template Work<M>& work);

}  // namespace byhand
