#pragma once

#include <string>

#include "solver/contact/contact_manager.hpp"
#include "solver/direct/graph.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// The orders in which rows can be laid out.
enum class Layout { none, natural, reverse, coloured, elimination };

/// What every method keeps between steps. λ of `system` is the impulse of the last substep, so that λ/h is the
/// mean force in it.
template <class M>
struct StepWork {
  System<M> system;
  ContactManager<M> contacts;
  std::vector<double> approach;  // JV of rows that may bounce, before they are solved
  Layout layout = Layout::none;
  std::uint64_t version = 0;  // of the scene that is laid out
  bool loopless = false;      // its graph
  double h = 0;               // the substep that λ belongs to [s]
  long long row_solves = 0;   // so far; a direct solve counts as the row-solves that its multiplications would buy
};

/// Places of constraints in that layout; for Layout::elimination this also makes `plan`.
std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan);

/// Lays the rows out in natural order, unless they are. Returns whether anything changed.
template <class M>
bool lay_out_naturally(const Scene<M>& scene, StepWork<M>& work);

/// λ is an impulse, a force times h: when the step changes, so does the guess that a warm start makes.
template <class M>
void rescale_impulses(StepWork<M>& work, double h) {
  if (work.h > 0 && work.h != h)
    for (double& lambda : work.system.lambda) lambda *= h / work.h;
  work.h = h;
}

/// Whether any row of the scene is bounded, or would be of what may come to touch.
template <class M>
bool has_bounds(const Scene<M>& scene);

/// What every step begins with: throws std::invalid_argument for a time step [s] that is not positive, gravity
/// that is not finite, a method outside its range, and a method that refuses the scene.
template <class M, class Method>
void require_steppable(const Scene<M>& scene, const Method& method, double step) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if (const std::string reason = refusal(scene, method); !reason.empty()) throw std::invalid_argument(reason);
}

/// What a constraint did to its second body in the last substep; its first body got the opposite force.
template <class M>
struct Reaction {
  Linear<M> force = Linear<M>::Zero();      // [N]
  Angular<M> torque1 = Angular<M>::Zero();  // on the first body, about its centre of mass [N m]
  Angular<M> torque2 = Angular<M>::Zero();  // on the second [N m]
};

/// Jᵀλ/h of a constraint, by its handle or identity, as it was solved last. Throws std::invalid_argument for one
/// that the scene does not have or that took no part in the last step.
template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint);

}  // namespace byhand
