#include "solver/methods/avbd.hpp"

#include <Eigen/Cholesky>

#include "solver/integrate/euler.hpp"

namespace byhand {

void require_valid(const Avbd& method) {
  require(method.iterations >= 1, "number of iterations", method.iterations, "at least 1");
  require_in("alpha", method.alpha, 0, 1);
  require_in("beta", method.beta, 0, 1e300, "N/m²");
  require_in("memory", method.memory, 0, 1);
  require_positive("softest", method.softest);
  require_positive("stiffest", method.stiffest, "N/m");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

namespace {

/// Lists for each body that moves the constraints that hold it.
template <class M>
void list_holders(int bodies, Avbd::Work<M>& work) {
  using Holder = typename Avbd::Work<M>::Holder;
  std::vector<std::vector<Holder>> of_body(bodies);
  for (const Run& run : work.system.runs)
    for_type<M>(run.type, [&](auto type) {
      const auto& blocks = std::get<type>(work.system.blocks);
      for (int i = run.first; i < run.first + run.count; ++i) {
        const BlockHeader& block = blocks[i];
        if (block.moves1) of_body[block.body1].push_back({run.type, i, run.kind, block.row, false});
        if (block.moves2) of_body[block.body2].push_back({run.type, i, run.kind, block.row, true});
      }
    });
  work.first.assign(1, 0);
  work.holders.clear();
  for (const auto& holders : of_body) {
    work.holders.insert(work.holders.end(), holders.begin(), holders.end());
    work.first.push_back(static_cast<int>(work.holders.size()));
  }
}

/// How fast each row of J, a body's half of it, changes with each coordinate of that body.
template <class M, int K, Bound B>
void note_curvature(const ConstraintStore<M>& store, const Block<M, K, B>& block, Bodies<M>& bodies,
                    Avbd::Work<M>& work) {
  constexpr double way = 0x1p-20;  // [m or rad]
  constexpr int dof = M::dof;
  Eigen::Map<Eigen::Matrix<double, K, 2 * dof, Eigen::RowMajor>> curvature(&work.curvature[2 * dof * block.row]);
  Block<M, K, B> displaced = block;
  Rows<K> C;
  const auto column = [&](int body, int first, int i) {
    Pose<M>& pose = bodies.pose[body];
    const Pose<M> here = pose;
    pose = moved<M, double>(here, Velocity<M>::Unit(i), way);
    store.linearise(bodies, displaced, C.data());
    pose = here;
    curvature.col(first + i) =
        (displaced.J.matrix.template middleCols<dof>(first) - block.J.matrix.template middleCols<dof>(first))
            .rowwise()
            .norm() /
        way;
  };
  for (int i = 0; i < dof; ++i) {
    column(block.body1, 0, i);
    column(block.body2, dof, i);
  }
}

/// Friction has one k for both of its axes, or F would not oppose the slip.
template <class M, int K, Bound B>
void share_stiffness(const Block<M, K, B>& block, std::vector<double>& stiffness) {
  if constexpr (B == Bound::friction) {
    Eigen::Map<Rows<K>> both(&stiffness[block.row]);
    both.setConstant(both.maxCoeff());
  }
}

/// Sets how a block begins a step: its Λ and k, and how much of C it asks for.
template <class M, int K, Bound B>
void warm_start(const Avbd& method, double h, int position_rows, const Block<M, K, B>& block,
                Avbd::Work<M>& work) {
  System<M>& system = work.system;
  for (int k = 0; k < K; ++k) {
    const int row = block.row + k;
    const double inverse_mass = block.J.matrix.row(k).dot(block.W.matrix.row(k)), gamma = system.gamma[row];
    const bool hard = gamma == 0;
    if (k < position_rows && hard)
      work.target[row] = -method.alpha * (B == Bound::none ? system.C[row] : std::min(system.C[row], 0.0));
    work.impulse[row] = hard ? method.alpha * method.memory * h * system.lambda[row] : 0.0;
    const double least = inverse_mass > 0 ? method.softest / (h * h * inverse_mass) : 0.0;
    double& stiffness = system.stiffness[row];
    stiffness = hard ? std::min(std::max(method.memory * stiffness, least), method.stiffest) : 1 / (h * h * gamma);
  }
  share_stiffness(block, system.stiffness);
}

/// F of a block's rows without its bounds, in units of Λ, given the error C.
template <int K, class M>
Rows<K> unbounded_force(const Rows<K>& C, double h, int row, const Avbd::Work<M>& work) {
  Rows<K> F;
  for (int k = 0; k < K; ++k)
    F[k] = (work.system.gamma[row + k] == 0 ? work.impulse[row + k] : 0.0) -
           h * h * work.system.stiffness[row + k] * C[k];
  return F;
}
template <class M, int K, Bound B>
Rows<K> within_bounds(const Rows<K>& F, double h, const Block<M, K, B>& block, const Avbd::Work<M>& work) {
  const ImpulseBounds bounds = impulse_bounds(block, h, work);
  return bounded<K, B>(F, bounds.lower, bounds.upper, bounds.normal);
}

/// The new Λ of a block's rows, and k where F is inside its bounds.
template <class M, int K, Bound B>
void update_rows(const ConstraintStore<M>& store, const Avbd& method, double h, const Block<M, K, B>& block,
                 const Bodies<M>& bodies, Avbd::Work<M>& work) {
  Rows<K> value;
  store.write_value(block.constraint, bodies, value.data());
  const Rows<K> C = position_error<M, K>(value, store.periodic, block.row, work);
  const Rows<K> wanted = unbounded_force<K>(C, h, block.row, work), F = within_bounds(wanted, h, block, work);
  for (int k = 0; k < K; ++k) {
    if (F[k] != wanted[k]) continue;
    const double gamma = work.system.gamma[block.row + k];
    double& stiffness = work.system.stiffness[block.row + k];
    stiffness =
        std::min(stiffness + method.beta * std::abs(C[k]), gamma == 0 ? method.stiffest : 1 / (h * h * gamma));
  }
  share_stiffness(block, work.system.stiffness);
  Eigen::Map<Rows<K>>(&work.impulse[block.row]) = F;
}

/// One Newton step of one body while the others stand still. Returns how many rows it has seen.
template <class M>
int descend(const Scene<M>& scene, int body, double h, Bodies<M>& bodies, Avbd::Work<M>& work) {
  constexpr int dof = M::dof;
  const InverseMass<M>& mass = bodies.inverse_mass[body];
  Pose<M>& pose = bodies.pose[body];
  Eigen::Matrix<double, dof, dof> H = Eigen::Matrix<double, dof, dof>::Zero();
  H.diagonal().template head<M::linear>().setConstant(1 / mass.linear);
  if constexpr (M::angular > 0) H.template bottomRightCorner<M::angular, M::angular>() = inertia<M>(mass, pose);
  Velocity<M> slope = H.lazyProduct(velocity_between<M>(work.free[body], pose, 1));
  int seen = 0;
  for (int i = work.first[body]; i < work.first[body + 1]; ++i) {
    const auto& holder = work.holders[i];
    for_type<M>(holder.type, [&](auto type) {
      auto& block = std::get<type>(work.system.blocks)[holder.block];
      constexpr int K = decltype(block.J.matrix)::RowsAtCompileTime;
      const ConstraintStore<M>& store = scene.store(holder.kind);
      Rows<K> value;
      store.linearise(bodies, block, value.data());
      const Rows<K> C = position_error<M, K>(value, store.periodic, block.row, work);
      const Rows<K> F = within_bounds(unbounded_force<K>(C, h, block.row, work), h, block, work);
      const int first = holder.second ? dof : 0;
      const Eigen::Matrix<double, K, dof> side = block.J.matrix.template middleCols<dof>(first);
      for (int k = 0; k < K; ++k) {
        H += h * h * work.system.stiffness[block.row + k] * side.row(k).transpose() * side.row(k);
        H.diagonal() +=
            std::abs(F[k]) * Eigen::Map<const Velocity<M>>(&work.curvature[2 * dof * (block.row + k) + first]);
      }
      slope -= side.transpose() * F;
      seen += K;
    });
  }
  move<M, double>(pose, -H.ldlt().solve(slope), 1);
  return seen;
}

/// Calls f(store, block, run) for each block in natural order.
template <class M, class F>
void for_each_block(const Scene<M>& scene, System<M>& system, F&& f) {
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (auto& block : part<type>(system.blocks, run)) f(scene.store(run.kind), block, run);
    });
}

}  // namespace

//! [step]
template <class M>
void advance(Scene<M>& scene, const Avbd& method, double h, Avbd::Work<M>& work) {
  require_steppable(scene, method, h);
  Bodies<M>& bodies = scene.state();
  if (begin_rows(scene, work)) list_holders(bodies.size(), work);
  work.system.stiffness.resize(work.system.rows());
  work.curvature.resize(2 * M::dof * work.system.rows());
  rescale_impulses(work, h);
  write_targets(scene, h, work);
  for_each_block(scene, work.system, [&](const auto& store, auto& block, const Run& run) {
    note_curvature(store, block, bodies, work);
    warm_start(method, h, run.position_rows, block, work);
  });
  begin_turn(method.gyroscopic, bodies, h);
  work.before = bodies.pose;
  advance_poses(bodies, h);
  work.free = bodies.pose;
  for (Pose<M>& pose : work.free) pose.position += h * h * scene.gravity;
  for (int i = 0; i < method.iterations; ++i) {
    for (int body = 0; body < bodies.size(); ++body)
      if (moves(bodies.inverse_mass[body])) work.row_solves += descend(scene, body, h, bodies, work);
    for_each_block(scene, work.system, [&](const auto& store, const auto& block, const Run&) {
      update_rows(store, method, h, block, bodies, work);
    });
    work.row_solves += work.system.rows();
  }
  velocities_between(work.before, h, bodies);
  end_turn(method.gyroscopic, bodies, h);
  end_rows(scene, h, method.bounce_threshold, work);
  work.contacts.read_impulses(work.system);
}
//! [step]

#define BYHAND_INSTANTIATE(M) template void advance(Scene<M>&, const Avbd&, double, Avbd::Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
