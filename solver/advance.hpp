#pragma once

#include "solver/contact/restitution.hpp"
#include "solver/direct/newton_work.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/step.hpp"
#include "solver/support/attempt.hpp"

// One step of velocity stepping. It asks row solver and cure, and knows none by name.
namespace byhand {

/// A step whose impulses lead bodies where nobody looked is taken in up to so many parts.
constexpr int most_parts = 64;

namespace detail {

/// Calls f with a choice, or with the one that a variant holds.
template <class Choice, class F>
decltype(auto) with_choice(const Choice& choice, F&& f) {
  return f(choice);
}
template <class... Choices, class F>
decltype(auto) with_choice(const std::variant<Choices...>& choices, F&& f) {
  return std::visit(f, choices);
}

template <class M, class Solver>
struct WorkOf {
  using type = NoWork;
};
template <class M, class Solver>
requires requires { typename Solver::template Work<M>; }
struct WorkOf<M, Solver> {
  using type = typename Solver::template Work<M>;
};

template <class Solver, class Own>
Layout layout_of(const Solver& solver, const Own& own) {
  if constexpr (requires { solver.layout(own); })
    return solver.layout(own);
  else if constexpr (requires { solver.layout(); })
    return solver.layout();
  else
    return Layout::natural;
}

template <class M, class Solver, class Own>
std::vector<int> order_of(const Scene<M>& scene, const ConstraintList<M>& contacts, const Solver& solver,
                          Own& own) {
  if constexpr (requires { solver.order(Graph(), own); })
    return solver.order(scene.graph(contacts), own);
  else if (const Layout layout = layout_of(solver, own); layout != Layout::natural)
    return byhand::order_of(layout, scene.graph(contacts));
  else
    return natural_order(scene.count() + contacts.count());
}

template <class Solver>
constexpr bool holds_bounds() {
  if constexpr (requires { Solver::holds_bounds; }) return Solver::holds_bounds;
  return true;
}

template <class M, class Solver>
void lay_out(const Scene<M>& scene, const Solver& solver, Work<M>& work) {
  with_choice(solver, [&]<class Choice>(const Choice& choice) {
    using Own = typename WorkOf<M, Choice>::type;
    Own* kept = std::any_cast<Own>(&work.solver);
    if (kept && work.version == scene.version() && work.layout == layout_of(choice, *kept)) return;
    Own& own = kept ? *kept : work.solver.template emplace<Own>();
    const ConstraintList<M>& contacts = work.contacts.constraints();
    scene.lay_out(order_of(scene, contacts, choice, own), work.system, contacts);
    work.executed.laid_out_rows += work.system.rows();
    work.layout = layout_of(choice, own);
    work.version = scene.version();
  });
}

template <class M, class Solver>
void solve_rows(const Solver& solver, Bodies<M>& bodies, Work<M>& work, Begin begin) {
  const Solution solution = with_choice(solver, [&]<class Choice>(const Choice& choice) {
    auto& own = kept_as<typename WorkOf<M, Choice>::type>(work.solver);
    return choice.solve(work.system, bodies, own, begin);
  });
  work.row_solves += static_cast<long long>(solution.passes) * work.system.rows() + solution.row_solves;
  ++work.executed.solves;
  work.executed.passes += solution.passes;
  work.executed.prepared_rows += work.system.rows();
  work.solution += solution;
}

template <class M, class Solver>
struct StageOf final : Stage<M> {
  StageOf(Scene<M>& s, Work<M>& w, double substep, const Solver& choice)
      : Stage<M>(s, w, substep, w.cure), own(w), solver(choice) {}
  void solve_rows_again() override { solve_rows(solver, this->scene.state(), own, Begin::resume); }

  Work<M>& own;
  const Solver& solver;
};

}  // namespace detail

template <class Solver, class Cure>
void require_valid(const VelocitySteppingWith<Solver, Cure>& method) {
  detail::with_choice(method.solver, [](const auto& solver) { require_valid(solver); });
  detail::with_choice(method.drift, [](const auto& cure) { require_valid(cure); });
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

template <class M, class Solver, class Cure>
std::string refusal(const Scene<M>& scene, const VelocitySteppingWith<Solver, Cure>& method) {
  const bool holds_bounds = detail::with_choice(
      method.solver, []<class Choice>(const Choice&) { return detail::holds_bounds<Choice>(); });
  if (holds_bounds || (scene.colliders().shapes.empty() && !scene.bounded())) return {};
  return "this row solver holds no bounds, and this scene has contacts or other rows with bounds: conjugate "
         "sweeps would";
}

/// The cure before the rows are solved: b of (21), as strong as for a whole substep [s], and what else it begins
/// with.
template <class M, class Cure>
void begin_cure(const Cure& cure, double substep, Stage<M>& stage) {
  detail::with_choice(cure, [&](const auto& choice) {
    Correction correction;
    if constexpr (requires { choice.correction(substep); }) correction = choice.correction(substep);
    set_bias(correction, stage.h, stage.work.system);
    if constexpr (requires { choice.begin(stage); }) choice.begin(stage);
  });
}

/// The cure after the poses have moved.
template <class M, class Cure>
void end_cure(const Cure& cure, Stage<M>& stage) {
  detail::with_choice(cure, [&](const auto& choice) {
    if constexpr (requires { choice.after_move(stage); }) choice.after_move(stage);
  });
}

/// Turns each ω back to the pose at which the rows were written, or on from there: it turns with its body.
inline void turn_velocities(const std::vector<Rotation<SpaceBody, double>>& rotations, bool back,
                            Bodies<SpaceBody>& bodies) {
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const auto turned = bodies.pose[i].rotation * rotations[i].conjugate();
    Eigen::Ref<Eigen::Vector3d> omega = bodies.velocity[i].tail<3>();
    omega = (back ? turned.conjugate() : turned) * omega;
  }
}

/// In space the inertia has turned with the poses: seen from each body the rows are still the same.
template <class M>
void solve_bounce(Stage<M>& stage) {
  System<M>& system = stage.work.system;
  Bodies<M>& bodies = stage.scene.state();
  if constexpr (M::angular == 3) turn_velocities(stage.work.rotations, true, bodies);
  const std::vector<double> lambda = system.lambda;
  const std::vector<Velocity<M>> velocity = bodies.velocity;
  stage.solve_rows_again();
  limit_bounce(stage.scene, stage.h, lambda, velocity, system, bodies);
  if constexpr (M::angular == 3) turn_velocities(stage.work.rotations, false, bodies);
}

/// Solves bouncing contacts a second time, after the poses have moved.
template <class M>
void bounce(Stage<M>& stage) {
  if (!set_bounce(stage.work.parting, stage.work.system)) return;
  solve_bounce(stage);
  forget_bounce(stage.work.parting, stage.work.system);
}

//! [step]
/// One of the equal parts of a step [s]. Returns false where impulses lead bodies past what the search for
/// contacts has seen.
template <class M, class Solver, class Cure>
bool take_part(Scene<M>& scene, const VelocitySteppingWith<Solver, Cure>& method, double step, int parts,
               Work<M>& work) {
  find_contacts(scene, step / parts, work);  // the article's n, P1 and P2, from shapes
  detail::lay_out(scene, method.solver, work);
  work.contacts.write_impulses(work.system);
  Bodies<M>& bodies = scene.state();
  const double h = step / parts / method.substeps;
  detail::StageOf<M, Solver> stage(scene, work, h, method.solver);
  for (int left = method.substeps; left > 0; --left) {
    write_rows(scene, h, work);                               // J, C, M⁻¹Jᵀ at the current poses
    begin_cure(method.drift, step / method.substeps, stage);  // b of (21), (22)
    note_parting(scene, h, method.bounce_threshold, work.system, work.parting);
    damp(bodies, h);
    begin_turn(method.gyroscopic, bodies, h);
    add_gravity(bodies, scene.gravity, h);  // before λ, or the rows cannot answer it
    add_applied(bodies, h);
    rescale_impulses(work, h);                                     // λ of last step, for the warm start
    detail::solve_rows(method.solver, bodies, work, Begin::step);  // (17) and (20) over all rows
    if (parts < most_parts && !work.contacts.foresaw(scene, work.system, h, left * h)) return false;
    advance_poses(bodies, h);
    end_cure(method.drift, stage);
    end_turn(method.gyroscopic, bodies, h);
    bounce(stage);
  }
  work.contacts.read_impulses(work.system);
  return true;
}
//! [step]

/// Takes a part from `start` or, where its search for contacts has not seen enough, its halves.
template <class M, class Solver, class Cure>
void take_in_parts(Scene<M>& scene, const VelocitySteppingWith<Solver, Cure>& method, double step, int parts,
                   const State<M>& start, Work<M>& work) {
  const Solution before = work.solution;
  if (take_part(scene, method, step, parts, work)) return;
  work.solution = before;
  scene.state().pose = start.pose;
  scene.state().velocity = start.velocity;
  take_in_parts(scene, method, step, 2 * parts, start, work);
  const State<M> middle{scene.bodies().pose, scene.bodies().velocity};
  take_in_parts(scene, method, step, 2 * parts, middle, work);
}

template <class M, class Solver, class Cure>
void advance(Scene<M>& scene, const VelocitySteppingWith<Solver, Cure>& method, double step, Work<M>& work) {
  require_steppable(scene, method, step);
  Attempt attempt(scene, work);
  work.solution = {};
  take_in_parts(scene, method, step, 1, work.start, work);
  attempt.finish();
}

/// Compiles the step with other row solvers or cures for one model; a source of theirs does so once.
#define BYHAND_STEPPING(M, Solver, Cure)                                                    \
  template std::string refusal(const Scene<M>&, const VelocitySteppingWith<Solver, Cure>&); \
  template void advance(Scene<M>&, const VelocitySteppingWith<Solver, Cure>&, double, Work<M>&)

}  // namespace byhand
