#include "lessons/methods/xpbd.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

void require_valid(const Xpbd& method) {
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
  require(method.iterations >= 1, "number of iterations", method.iterations, "at least 1");
  require(method.push_speed > 0, "push speed", method.push_speed, "above zero [m/s]");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

namespace {

/// Lets one-sided rows that overlap by more than `way` [m] move out by no more than that in this substep.
template <class M>
void limit_push(const Scene<M>& scene, double way, PositionWork<M>& work) {
  for_each_block(work.system, [&](const BlockHeader& block, const Run& run) {
    if (scene.store(run, work.contacts.constraints()).bound == Bound::none) return;
    for (int row = block.row; row < block.row + run.position_rows; ++row)
      work.target[row] = std::max(0.0, -(work.system.C[row] + way));
  });
}

/// One Newton step of one constraint: changes its Λ and the poses of its two bodies.
template <class M, int K, Bound B>
void solve_block(const ConstraintStore<M>& store, double h, Block<M, K, B>& block, Bodies<M>& bodies,
                 PositionWork<M>& work) {
  Eigen::Map<Rows<K>> impulse(&work.impulse[block.row]);
  const Eigen::Map<const Rows<K>> gamma(&work.system.gamma[block.row]);
  const Rows<K> C = linearised(store, bodies, block, work);
  Eigen::Matrix<double, K, K> A = inverse_effective_mass(block.J, block.W);
  A.diagonal() += gamma;
  const Rows<K> residual = position_error<M, K>(C, store.periodic, block.row, work) + gamma.cwiseProduct(impulse);
  const Rows<K> change = bounded_newton<B, K>(A, residual, impulse, impulse_bounds(block, h, work));
  impulse += change;
  apply_displacement(block, change, [&](int body, const Velocity<M>& way) {
    work.displacement[body] += way;
    move<M, double>(bodies.pose[body], way, 1);
  });
}

/// Solves the rows of friction, or all others. With each point's friction right after its push, the points of a
/// face would be moved by what the next ones undo: a box at rest would creep, and a stack would rock.
template <class M>
void sweep(Scene<M>& scene, double h, bool friction, PositionWork<M>& work) {
  for_each_block(work.system, [&](auto& block, const Run& run) {
    const ConstraintStore<M>& store = scene.store(run, work.contacts.constraints());
    if ((store.bound == Bound::friction) == friction) solve_block(store, h, block, scene.state(), work);
  });
}

}  // namespace

template <class M>
void advance(Scene<M>& scene, const Xpbd& method, double step, PositionWork<M>& work) {
  require_steppable(scene, method, step);
  Attempt attempt(scene, work);
  begin_rows(scene, step, work);
  Bodies<M>& bodies = scene.state();
  const double h = work.h = step / method.substeps;
  for (int substep = 0; substep < method.substeps; ++substep) {
    write_targets(scene, h, method.bounce_threshold, work);
    limit_push(scene, method.push_speed * h, work);
    std::fill(work.impulse.begin(), work.impulse.end(), 0.0);
    damp(bodies, h);
    add_gravity(bodies, scene.gravity, h);
    add_applied(bodies, h);
    advance_freely(method.gyroscopic, bodies, h, work);
    work.free = bodies.pose;
    for (int i = 0; i < method.iterations; ++i) {
      sweep(scene, h, false, work);
      if (work.system.bounded) sweep(scene, h, true, work);
    }
    end_substep(scene, h, work);
    work.row_solves += static_cast<long long>(method.iterations) * work.system.rows();
    work.executed.passes += method.iterations;
  }
  work.contacts.read_impulses(work.system);
  attempt.finish();
}

#define BYHAND_INSTANTIATE(M) template void advance(Scene<M>&, const Xpbd&, double, PositionWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
