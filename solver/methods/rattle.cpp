#include "solver/methods/rattle.hpp"

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"

namespace byhand {

void require_valid(const Rattle& family) {
  require(family.substeps >= 1, "number of substeps", family.substeps, "at least 1");
  require_in("regularisation", family.regularisation, 0, 1);
}

namespace {

/// The bodies where they come to from the beginning of the substep with the velocities `kicked`.
template <class M>
void move_kicked(Bodies<M>& bodies, const RattleWork<M>& work) {
  bodies.pose = work.begin.pose;
  bodies.velocity = work.kicked;
  begin_turn(Gyroscopic::implicit, bodies, work.h);
  advance_poses(bodies, work.h);
}

/// C/h of every row, as offsets; returns the largest |C|.
template <class M>
double write_errors(const Scene<M>& scene, RattleWork<M>& work) {
  double largest = 0;
  for (int place = 0; place < scene.count(); ++place) {
    const auto& entry = scene.entries()[place];
    double* C = &work.offset[work.system.row_of[place]];
    scene.store(entry.kind).write_value(entry.index, scene.bodies(), C);
    for (int k = 0; k < scene.store(entry.kind).rows; ++k) {
      if (!(std::abs(C[k]) <= largest)) largest = std::abs(C[k]);  // also where it is not a number
      C[k] /= work.h;
    }
  }
  return largest;
}

/// Adds the impulses `work.change` to velocities and to λ.
template <class M>
void add_impulses(std::vector<Velocity<M>>& velocities, RattleWork<M>& work) {
  apply_all(work.system, work.change, velocities);
  for (std::size_t row = 0; row < work.change.size(); ++row) work.system.lambda[row] += work.change[row];
}

/// Corrects λ and the kicked velocities by the errors that stand as offsets.
template <class M>
void correct_kick(RattleWork<M>& work) {
  solve_again(work.offset, work.direct, work.change);
  work.row_solves += row_solves_again(work.direct.plan, M::dof);
  add_impulses(work.kicked, work);
}

/// Factors the rows as they are written, and finds the impulses that would leave JV = 0.
template <class M>
void factor_rows(const Bodies<M>& bodies, double regularisation, RattleWork<M>& work) {
  std::fill(work.offset.begin(), work.offset.end(), 0.0);
  solve_rows(regularisation, bodies, work);
}

//! [rattle]
/// One substep from rows that are written and factored at its beginning, and leaves them so at its end.
template <class M>
void rattle(Scene<M>& scene, const Rattle& family, RattleWork<M>& work) {
  Bodies<M>& bodies = scene.state();
  std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
  add_gravity(bodies, scene.gravity, work.h / 2);
  work.kicked = bodies.velocity;
  Convergence convergence(1e-9);  // [units of C]
  for (move_kicked(bodies, work); !convergence.reached(write_errors(scene, work)); move_kicked(bodies, work))
    correct_kick(work);
  end_turn(Gyroscopic::implicit, bodies, work.h);
  scene.write_rows(work.system, work.h);
  add_gravity(bodies, scene.gravity, work.h / 2);
  factor_rows(bodies, family.regularisation, work);
  add_impulses(bodies.velocity, work);
}
//! [rattle]

}  // namespace

template <class M>
void advance(Scene<M>& scene, const Rattle& family, double step, RattleWork<M>& work) {
  require_steppable(scene, family, step);
  begin_equalities(scene, step / family.substeps, work);
  scene.write_rows(work.system, work.h);
  factor_rows(scene.bodies(), family.regularisation, work);
  for (int i = 0; i < family.substeps; ++i) {
    work.begin = scene.bodies();
    or_back_to(work.begin, scene.state(), [&] { rattle(scene, family, work); });
  }
}

#define BYHAND_INSTANTIATE(M) template void advance(Scene<M>&, const Rattle&, double, RattleWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
