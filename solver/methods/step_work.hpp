#pragma once

#include <numeric>
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
  BYHAND_DECLARE_COPIES(StepWork);

  System<M> system;
  ContactManager<M> contacts;
  std::vector<double> approach;  // JV of rows that may bounce, before they are solved
  Layout layout = Layout::none;
  std::uint64_t version = 0;  // of the scene when it was laid out
  std::size_t solver = 0;     // index of the row solver it was laid out for
  bool loopless = false;      // whether its graph has no loops
  bool directly = false;      // whether ByGraph solves it directly, loops or not
  double h = 0;               // the substep that λ belongs to [s]
  long long row_solves = 0;   // total cost; a direct solve counts as the row solves of as many multiplications
};

/// The multiplications that a direct solve may take in a step.
inline long long most_multiplications(const Graph& graph) { return (1 << 25) + 500LL * row_count(graph); }

/// Places of constraints in that layout; Layout::elimination also writes `plan`. Throws std::invalid_argument
/// where a direct solve would take too long, which no chain, tree or sheet of 100 × 100 does.
std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan);

/// Lays the rows out in natural order if the scene has changed. Returns whether it has.
template <class M>
bool lay_out_naturally(const Scene<M>& scene, StepWork<M>& work) {
  if (work.version == scene.version()) return false;
  work.version = scene.version();
  std::vector<int> order(scene.count());
  std::iota(order.begin(), order.end(), 0);
  scene.lay_out(order, work.system);
  return true;
}

/// λ is force times h: a new time step rescales it, so that the warm start keeps the forces.
template <class M>
void rescale_impulses(StepWork<M>& work, double h) {
  if (work.h > 0 && work.h != h)
    for (double& lambda : work.system.lambda) lambda *= h / work.h;
  work.h = h;
}

/// The refusal of methods that run every scene.
template <class M, class Method>
std::string refusal(const Scene<M>&, const Method&) {
  return {};
}

/// Begins every `advance`. Throws std::invalid_argument for a time step [s] that is not positive, gravity that is
/// not finite, a method outside its range, and a method that refuses the scene.
template <class M, class Method>
void require_steppable(const Scene<M>& scene, const Method& method, double step) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if (const std::string reason = refusal(scene, method); !reason.empty()) throw std::invalid_argument(reason);
}

/// The force of a constraint on its second body; its first body gets the opposite force.
template <class M>
struct Reaction {
  Linear<M> force = Linear<M>::Zero();      // [N]
  Angular<M> torque1 = Angular<M>::Zero();  // on the first body, about its centre of mass [N m]
  Angular<M> torque2 = Angular<M>::Zero();  // on the second [N m]
};

/// Jᵀλ/h of a constraint, by its handle or identity, in the last substep. Throws std::invalid_argument for one
/// that the scene does not have or that took no part in the last step.
template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint);

}  // namespace byhand
