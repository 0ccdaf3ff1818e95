#include "lessons/methods/avbd.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

void require_valid(const Avbd& method) {
  require(method.iterations >= 1, "number of iterations", method.iterations, "at least 1");
  require_in("alpha", method.alpha, 0, 1);
  require_in("beta", method.beta, 0, 1e300, "1/m");
  require_in("memory", method.memory, 0, 1);
  require_positive("softest", method.softest);
  require_positive("stiffest", method.stiffest);
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

namespace {

template <class M>
void list_holders(Avbd::Work<M>& work) {
  const std::vector<Run>& runs = work.system.runs;
  work.holders.clear();
  for (int run = 0; run < static_cast<int>(runs.size()); ++run)
    for_type<M>(runs[run].type, [&](auto type) {
      const auto& blocks = std::get<type>(work.system.blocks);
      for (int i = runs[run].first; i < runs[run].first + runs[run].count; ++i) {
        if (blocks[i].moves1) work.holders.push_back({blocks[i].body1, run, i, false});
        if (blocks[i].moves2) work.holders.push_back({blocks[i].body2, run, i, true});
      }
    });
  std::stable_sort(work.holders.begin(), work.holders.end(),
                   [](const auto& a, const auto& b) { return a.body < b.body; });
}

/// Friction has one k for both axes, or F would not oppose the slip.
template <Bound B, int K>
void share_stiffness(double* k) {
  if constexpr (B == Bound::friction && K == 2) k[0] = k[1] = std::max(k[0], k[1]);
}

/// Prepares a block for a step: Λ, k and how much of C it removes.
template <class M, int K, Bound B>
void warm_start(const Avbd& method, int position_rows, const Block<M, K, B>& block, Avbd::Work<M>& work) {
  System<M>& system = work.system;
  const double h = work.h;
  for (int k = 0; k < K; ++k) {
    const int row = block.row + k;
    const bool hard = system.gamma[row] == 0;
    if (hard && k < position_rows)
      work.target[row] = -method.alpha * (B == Bound::none ? system.C[row] : std::min(system.C[row], 0.0));
    work.impulse[row] = hard ? method.alpha * method.memory * h * system.lambda[row] : 0.0;
    const double inverse_mass = inverse_effective_mass(block.J, block.W, k);
    const double unit = work.unit[row] = inverse_mass > 0 ? 1 / (h * h * inverse_mass) : 0.0;
    double& stiffness = system.stiffness[row];
    stiffness = hard ? std::min(std::max(method.memory * stiffness, method.softest * unit), method.stiffest * unit)
                     : 1 / (h * h * system.gamma[row]);
  }
  share_stiffness<B, K>(&system.stiffness[block.row]);
}

/// Notes how fast each row of J, a body's half of it, changes with each coordinate of that body. A radius of
/// gyration makes lengths of angles, so that the unit of length does not matter.
template <class M, int K, Bound B>
void note_curvature(const ConstraintStore<M>& store, const Block<M, K, B>& block, Bodies<M>& bodies,
                    Avbd::Work<M>& work) {
  constexpr int dof = M::dof;
  if (store.holds_where_found) {
    std::fill_n(&work.curvature[2 * dof * block.row], 2 * dof * K, 0.0);
    return;
  }
  constexpr double share = 0x1p-20;
  const double apart = (bodies.pose[block.body2].position - bodies.pose[block.body1].position).norm();
  Block<M, K, B> displaced = block;
  double C[K];
  const auto note_side = [&](int first, int body) {
    const InverseMass<M>& mass = bodies.inverse_mass[body];
    Velocity<M> length = Velocity<M>::Ones();  // of a unit of each coordinate
    if constexpr (M::angular > 0)
      length.template tail<M::angular>().setConstant(std::sqrt(mass.linear / mass.angular.mean()));
    Pose<M>& pose = bodies.pose[body];
    const Pose<M> here = pose;
    for (int i = 0; i < dof; ++i) {
      // rad, or m: as far as a body turns about the other
      const double way = i < M::linear ? share * (apart + (M::angular > 0 ? length[dof - 1] : 0.0)) : share;
      move<M, double>(pose, Velocity<M>::Unit(i), way);
      store.linearise(bodies, displaced, C);
      pose = here;
      for (int k = 0; k < K; ++k) {
        const Eigen::Map<const Velocity<M>> J(&block.J.matrix(k, first)), J_there(&displaced.J.matrix(k, first));
        const double change = (J_there - J).cwiseQuotient(length).norm() * length[i];
        work.curvature[2 * dof * (block.row + k) + first + i] = way > 0 ? change / way : 0.0;
      }
    }
  };
  if (block.moves1) note_side(0, block.body1);
  if (block.moves2) note_side(dof, block.body2);
}

/// F of a block's rows in units of Λ. `C` is their value and becomes their error; `unbounded` becomes Λ - κC.
template <class M, int K, Bound B>
Rows<K> force(bool periodic, const Block<M, K, B>& block, const Avbd::Work<M>& work, Rows<K>& C,
              Rows<K>& unbounded) {
  C = position_error<M, K>(C, periodic, block.row, work);
  for (int k = 0, row = block.row; k < K; ++k, ++row)
    unbounded[k] = (work.system.gamma[row] == 0 ? work.impulse[row] : 0.0) -
                   work.h * work.h * work.system.stiffness[row] * C[k];
  const ImpulseBounds bounds = impulse_bounds(block, work.h, work);
  return bounded<K, B>(unbounded, bounds.lower, bounds.upper, bounds.normal);
}

/// Solves Hx = b in place by H = L D Lᵀ, from the lower triangle of H. Without pivoting, for H is positive
/// definite: it is M plus terms that are positive semidefinite.
template <int n>
void solve_definite(Eigen::Matrix<double, n, n>& H, Packed<double, n>& b) {
  for (int j = 0; j < n; ++j) {
    const double inverse = 1 / H(j, j);
    for (int i = j + 1; i < n; ++i) {
      const double factor = H(i, j) * inverse;
      for (int k = i; k < n; ++k) H(k, i) -= factor * H(k, j);
      b[i] -= factor * b[j];
    }
    H(j, j) = inverse;
  }
  for (int j = n - 1; j >= 0; --j) {
    for (int i = j + 1; i < n; ++i) b[j] -= H(i, j) * b[i];
    b[j] *= H(j, j);
  }
}

/// One Newton step, HΔx = -slope, of one body while the others stay. `next` goes through the holders.
template <class M>
void descend(const Scene<M>& scene, int body, Bodies<M>& bodies, std::size_t& next, Avbd::Work<M>& work) {
  constexpr int dof = M::dof;
  const InverseMass<M>& mass = bodies.inverse_mass[body];
  Pose<M>& pose = bodies.pose[body];
  Eigen::Matrix<double, dof, dof> H = Eigen::Matrix<double, dof, dof>::Zero();
  H.diagonal().template head<M::linear>().setConstant(1 / mass.linear);
  if constexpr (M::angular > 0) H.template bottomRightCorner<M::angular, M::angular>() = inertia<M>(mass, pose);
  Velocity<M> slope = H.lazyProduct(velocity_between<M>(work.free[body], pose, 1));
  for (; next < work.holders.size() && work.holders[next].body == body; ++next) {
    const auto& holder = work.holders[next];
    const Run& run = work.system.runs[holder.run];
    const ConstraintStore<M>& store = scene.store(run, work.contacts.constraints());
    for_type<M>(run.type, [&](auto type) {
      auto& block = std::get<type>(work.system.blocks)[holder.block];
      constexpr int K = decltype(block.J.matrix)::RowsAtCompileTime;
      Rows<K> C = linearised(store, bodies, block, work), unbounded;
      const Rows<K> F = force(store.periodic, block, work, C, unbounded);
      for (int k = 0; k < K; ++k) {
        const int row = block.row + k, first = holder.second ? dof : 0;
        const double *J = &block.J.matrix(k, first), *curvature = &work.curvature[2 * dof * row + first];
        const double kappa = work.h * work.h * work.system.stiffness[row];
        for (int i = 0; i < dof; ++i) {
          slope[i] -= J[i] * F[k];
          H(i, i) += std::abs(F[k]) * curvature[i];
          for (int j = 0; j <= i; ++j) H(i, j) += kappa * J[i] * J[j];
        }
      }
    });
    work.row_solves += store.rows;
  }
  solve_definite(H, slope);
  work.displacement[body] -= slope;
  move<M, double>(pose, -slope, 1);
}

/// Sets the new Λ of a block's rows; k grows where F is inside its bounds.
template <class M, int K, Bound B>
void update_rows(const ConstraintStore<M>& store, const Avbd& method, const Block<M, K, B>& block,
                 const Bodies<M>& bodies, Avbd::Work<M>& work) {
  Rows<K> C, unbounded;
  if (store.holds_where_found)
    C = displaced_value(block, work);
  else
    store.write_value(block.constraint, bodies, C.data());
  const Rows<K> F = force(store.periodic, block, work, C, unbounded);
  for (int k = 0, row = block.row; k < K; ++k, ++row) {
    const double gamma = work.system.gamma[row];
    const double unit = work.unit[row], most = gamma == 0 ? method.stiffest * unit : 1 / (work.h * work.h * gamma);
    double& stiffness = work.system.stiffness[row];
    if (F[k] == unbounded[k]) stiffness = std::min(stiffness + method.beta * unit * std::abs(C[k]), most);
    work.impulse[row] = F[k];
  }
  share_stiffness<B, K>(&work.system.stiffness[block.row]);
}

}  // namespace

template <class M>
void advance(Scene<M>& scene, const Avbd& method, double h, Avbd::Work<M>& work) {
  require_steppable(scene, method, h);
  Attempt attempt(scene, work);
  Bodies<M>& bodies = scene.state();
  if (begin_rows(scene, h, work)) list_holders(work);
  work.system.stiffness.resize(work.system.rows());
  work.curvature.resize(2 * M::dof * work.system.rows());
  work.unit.resize(work.system.rows());
  rescale_impulses(work, h);
  write_targets(scene, h, method.bounce_threshold, work);
  for_each_block(work.system, [&](const auto& block, const Run& run) {
    note_curvature(scene.store(run, work.contacts.constraints()), block, bodies, work);
    warm_start(method, run.position_rows, block, work);
  });
  damp(bodies, h);
  add_applied(bodies, h);
  advance_freely(method.gyroscopic, bodies, h, work);
  add_gravity(bodies, scene.gravity, h);
  work.free = bodies.pose;
  for (int i = 0; i < bodies.size(); ++i) work.free[i].position += h * h * gravity_on(bodies, i, scene.gravity);
  for (int i = 0; i < method.iterations; ++i) {
    std::size_t next = 0;
    for (int body = 0; body < bodies.size(); ++body) {
      if (!moves(bodies.inverse_mass[body])) continue;
      descend(scene, body, bodies, next, work);
      ++work.executed.solves;
    }
    for_each_block(work.system, [&](const auto& block, const Run& run) {
      update_rows(scene.store(run, work.contacts.constraints()), method, block, bodies, work);
    });
    work.row_solves += work.system.rows();
  }
  end_substep(scene, h, work);
  work.contacts.read_impulses(work.system);
  attempt.finish();
}

#define BYHAND_INSTANTIATE(M) template void advance(Scene<M>&, const Avbd&, double, Avbd::Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
