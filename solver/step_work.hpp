#pragma once

#include <numeric>
#include <string>

#include "solver/contact/contact_manager.hpp"
#include "solver/direct/graph.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// The orders in which rows can be laid out.
enum class Layout { none, natural, reverse, coloured, elimination };

/// Poses and velocities of all bodies.
template <class M>
struct State {
  std::vector<Pose<M>> pose;
  std::vector<Velocity<M>> velocity;
};

/// What every method keeps between steps. λ of `system` is the impulse of the last substep, so that λ/h is the
/// mean force in it.
template <class M>
struct StepWork {
  BYHAND_DECLARE_COPIES(StepWork);

  System<M> system;
  ContactManager<M> contacts;
  std::vector<double> parting;  // by row, the least rate that a bounce leaves
  Layout layout = Layout::none;
  std::uint64_t version = 0;  // of the scene when it was laid out
  std::size_t solver = 0;     // index of the row solver it was laid out for
  bool loopless = false;      // whether its graph has no loops
  bool directly = false;      // whether ByGraph solves it directly, loops or not
  double h = 0;               // the substep that λ belongs to [s]
  long long row_solves = 0;   // total cost; a direct solve counts as the row solves of as many multiplications
  State<M> start;             // at the start of the step
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

/// Writes all rows at the present poses for a substep h [s], contacts of balls where these touch now.
template <class M>
void write_rows(Scene<M>& scene, double h, StepWork<M>& work) {
  work.contacts.follow_balls(scene, work.system);
  scene.write_rows(work.system, h);
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

/// Throws NotFinite for a step that `came` to numbers that are not finite and was taken back. It names the first
/// body that began with one, or else the first constraint with such a value at the start, or else the first body
/// at the end.
template <class M>
void refuse_not_finite(const Scene<M>& scene, const State<M>& came);

/// Within a step either all bodies move or none: whatever throws before the end of `finish` leaves them as they
/// were, and the next step begins without λ.
template <class M, class Work>
class Attempt {
 public:
  Attempt(Scene<M>& scene, Work& work) : scene_(scene), work_(work) {
    work.start.pose = scene.bodies().pose;
    work.start.velocity = scene.bodies().velocity;
  }
  Attempt(const Attempt&) = delete;
  ~Attempt() {
    if (!finished_) take_back();
  }

  /// Throws NotFinite if a pose or velocity is not finite.
  void finish() {
    finished_ = true;
    if (!are_finite(scene_.bodies().pose, scene_.bodies().velocity)) refuse_not_finite(scene_, take_back());
  }

 private:
  /// Returns what it takes back.
  State<M> take_back() {
    State<M> state = std::move(work_.start);
    std::swap(scene_.state().pose, state.pose);
    std::swap(scene_.state().velocity, state.velocity);
    work_ = {};
    return state;
  }

  Scene<M>& scene_;
  Work& work_;
  bool finished_ = false;
};

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
