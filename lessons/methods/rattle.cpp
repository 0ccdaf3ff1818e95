#include "lessons/methods/rattle.hpp"

#include "solver/integrate/gyroscopic.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Moves the bodies from the start of the substep with the velocities `kicked`.
template <class M>
void move_kicked(Bodies<M>& bodies, const Rattle::Work<M>& work) {
  bodies.pose = work.begin.pose;
  bodies.velocity = work.kicked;
  move_freely(Gyroscopic::implicit, bodies, work.h);
}

/// Writes C/h of every row as offsets. Returns their size as velocities: the root of the sum of squares, each
/// times the row's effective mass.
template <class M>
double write_errors(const Scene<M>& scene, Rattle::Work<M>& work) {
  double sum = 0;
  for_each_block(work.system, [&](const auto& block, const Run& run) {
    const ConstraintStore<M>& store = scene.store(run.kind);
    double* rate = &work.offset[block.row];
    store.write_value(block.constraint, scene.bodies(), rate);
    for (int k = 0; k < store.rows; ++k) {
      rate[k] /= work.h;
      if (rate[k] != 0 && (block.moves1 || block.moves2))
        sum += rate[k] * rate[k] / inverse_effective_mass(block.J, block.W, k);
    }
  });
  return std::sqrt(sum);
}

/// Adds the impulses `work.change` to velocities and to λ.
template <class M>
void add_impulses(std::vector<Velocity<M>>& velocities, Rattle::Work<M>& work) {
  apply_all(work.system, work.change, velocities);
  for (std::size_t row = 0; row < work.change.size(); ++row) work.system.lambda[row] += work.change[row];
}

/// Moves the bodies with the velocities `kicked`, changed until C = 0.
template <class M>
void reach_constraints(Scene<M>& scene, Rattle::Work<M>& work) {
  Bodies<M>& bodies = scene.state();
  move_kicked(bodies, work);
  const auto correct = [&] {
    solve_again(work.offset, work.direct, work.change);
    work.row_solves += row_solves_again(work.direct.plan, M::dof);
    ++work.executed.passes;
    add_impulses(work.kicked, work);
    move_kicked(bodies, work);
  };
  iterate(
      tolerance(bodies, work.h), [&] { return write_errors(scene, work); }, correct);
}

}  // namespace

template <class M>
void factor_rows(const Scene<M>& scene, double regularisation, Rattle::Work<M>& work) {
  scene.write_rows(work.system, work.h);
  std::fill(work.offset.begin(), work.offset.end(), 0.0);
  solve_rows(regularisation, scene.bodies(), work);
}

template <class M>
void rattle(Scene<M>& scene, double regularisation, Rattle::Work<M>& work) {
  Bodies<M>& bodies = scene.state();
  const auto kick = [&] {
    damp(bodies, work.h / 2);
    add_gravity(bodies, scene.gravity, work.h / 2);
    add_applied(bodies, work.h / 2);
  };
  kick();
  work.kicked = bodies.velocity;
  reach_constraints(scene, work);
  kick();
  factor_rows(scene, regularisation, work);
  add_impulses(bodies.velocity, work);
}

template <class M>
void meet_constraints(Scene<M>& scene, double regularisation, Rattle::Work<M>& work) {
  Bodies<M>& bodies = scene.state();
  factor_rows(scene, regularisation, work);
  if (write_errors(scene, work) > 1e-4 * tolerance(bodies, work.h)) {
    work.begin = bodies;
    work.kicked.assign(bodies.velocity.size(), Velocity<M>::Zero());
    reach_constraints(scene, work);
    bodies.velocity = work.begin.velocity;
    factor_rows(scene, regularisation, work);
  }
  add_impulses(bodies.velocity, work);
}

template <class M>
void advance(Scene<M>& scene, const Rattle& method, double step, Rattle::Work<M>& work) {
  require_steppable(scene, method, step);
  Attempt attempt(scene, work);
  begin_equalities(scene, step / method.substeps, work);
  factor_rows(scene, method.regularisation, work);
  run_substeps(method.substeps, scene, work, [&] { rattle(scene, method.regularisation, work); });
  attempt.finish();
}

#define BYHAND_INSTANTIATE(M)                                                \
  template void advance(Scene<M>&, const Rattle&, double, Rattle::Work<M>&); \
  template void factor_rows(const Scene<M>&, double, Rattle::Work<M>&);      \
  template void rattle(Scene<M>&, double, Rattle::Work<M>&);                 \
  template void meet_constraints(Scene<M>&, double, Rattle::Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
