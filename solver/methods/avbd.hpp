#pragma once

#include <string>

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/positions.hpp"
#include "solver/scene.hpp"
#include "solver/touching.hpp"

// Augmented vertex block descent. A step of implicit Euler is a minimum: of all poses x the new ones make
//
//   ½ |x - y|²_M + Σ ½ κ C²,    y = x₀ + h (v₀ + h g),   κ = h² k,
//
// smallest, y being where the bodies would go by themselves and k the stiffness of each row. The method goes from
// body to body and lets each take a Newton step while the others stand still, with its own dof × dof matrix:
//
//   (M + Σ (Jᵀ κ J + G)) Δx = -M (x - y) + Σ Jᵀ F,      F = Λ - κ C within bounds
//
// G stands for the second derivatives of C times F, of which a column's length is put on the diagonal so that the
// matrix stays definite. It is not a refinement: a chain under tension is stiff sideways, and without G one of 50
// links with an end mass of 1000 comes apart by metres. C's second derivatives are differences of J, taken once a
// step.
//
// A hard row has no finite k: Λ is its multiplier, the augmented Lagrangian's, and after each round over the
// bodies
//
//   Λ ← Λ - κ C within bounds,    k ← k + β|C| while F is inside them,
//
// so that C vanishes though κ stays finite. From one step to the next k is scaled by a memory below 1 (the
// paper's γ) and Λ by that and α. Of the error C₀ that a hard row has at the beginning of a step it removes the
// share 1 - α, or the push would become speed; a contact still open may close. A row that gives way (a spring, a
// softness) has the k of its material, 1/(h²γ) with the γ of its row, and F = -κ C. (The paper lets that k grow
// too, from little and forgetting some in each step; then a stiff spring gives way by more than its k says: 2.3
// times where 2 kg hang on 1e5 N/m and β is 1e5.)
//
// The rounds set out from x₀ + h v₀, not from y: what rests is then where it belongs. Rows are those of
// positions.hpp, with C - C₀ + h rate for C where they have none; a spring's damping, a motor's speed and
// friction's ball come with that, and a bounce. Bodies that are solved one after the other do not push each other
// equally until the rounds have converged, so even linear momentum is kept only so far.
//
// (Source: C. Giles, E. Diaz, C. Yuksel, Augmented vertex block descent, ACM Trans. Graph. 44(4), 2025.)
namespace byhand {

/// AVBD, as choices. Cost of a step: iterations × (rows at each of their moving bodies + rows once more for Λ).
struct Avbd {
  template <class M>
  struct Work;

  int iterations = 10;    // >= 1
  double alpha = 0.95;    // of a hard row's error at the beginning of a step this share stays, in [0, 1]
  double beta = 1e6;      // k's growth for each unit of C [N/m²] >= 0
  double memory = 0.99;   // what is kept of k, and with α of Λ, from step to step, in [0, 1]
  double softest = 1;     // k of a new row, and at least, in units of its effective mass over h² > 0
  double stiffest = 1e9;  // k at most [N/m] > 0
  Gyroscopic gyroscopic = Gyroscopic::none;  // of bodies in space
  double bounce_threshold = 0.5;             // slower than this nothing bounces [m/s] >= 0
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const Avbd& method);

/// Why this scene cannot be run so: it always can.
template <class S>
std::string refusal(const S&, const Avbd&) {
  return {};
}

/// What is kept between steps: Λ and k, which constraints hold which body, and scratch.
template <class M>
struct Avbd::Work {
  PositionRows rows;
  std::vector<double> stiffness;       // k by row, constraints in natural order [N/m]
  std::vector<double> curvature;       // how fast J of each row changes with each of its 2 dof coordinates
  std::vector<int> first, constraint;  // of body i the constraints' numbers from constraint[first[i]] on
  std::vector<Pose<M>> before, free;   // x₀ and y
  std::conditional_t<M::angular == 0, NoTouching, Touching<M>> touching;
  double h = 0;              // the step that λ belongs to [s]
  long long row_solves = 0;  // so far
};

namespace detail {

/// Lists for each body that moves the constraints that hold it.
template <class S, class M>
void list_neighbours(const S& scene, Avbd::Work<M>& work) {
  const auto& bodies = scene.bodies;
  work.first.assign(bodies.size() + 1, 0);
  scene.for_each([&](const auto& constraint) {
    for (const int body : {constraint.at.body1, constraint.at.body2})
      if (moves(bodies.inverse_mass[body])) ++work.first[body + 1];
  });
  for (int i = 0; i < bodies.size(); ++i) work.first[i + 1] += work.first[i];
  work.constraint.resize(work.first.back());
  int number = 0;
  scene.for_each([&](const auto& constraint) {
    for (const int body : {constraint.at.body1, constraint.at.body2})
      if (moves(bodies.inverse_mass[body])) work.constraint[work.first[body]++] = number;
    ++number;
  });
  for (int i = bodies.size(); i > 0; --i) work.first[i] = work.first[i - 1];
  work.first[0] = 0;
}

/// How fast each row of J, a body's half of it, changes with each coordinate of that body.
template <class Kind, class M>
void note_curvature(const Kind& constraint, const Bodies<M>& bodies, int row, Avbd::Work<M>& work) {
  constexpr double way = 0x1p-20;  // [m or rad]
  constexpr int K = Kind::rows, dof = M::dof;
  const int body1 = constraint.at.body1, body2 = constraint.at.body2;
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  const Jacobian<M, K> J = constraint.jacobian(pose1, pose2);
  Eigen::Map<Eigen::Matrix<double, K, 2 * dof, Eigen::RowMajor>> curvature(&work.curvature[2 * dof * row]);
  for (int i = 0; i < dof; ++i) {
    const Velocity<M> along = Velocity<M>::Unit(i);
    const Jacobian<M, K> J1 = constraint.jacobian(moved<M, double>(pose1, along, way), pose2);
    const Jacobian<M, K> J2 = constraint.jacobian(pose1, moved<M, double>(pose2, along, way));
    curvature.col(i) = (J1.side1() - J.side1()).rowwise().norm() / way;
    curvature.col(dof + i) = (J2.side2() - J.side2()).rowwise().norm() / way;
  }
}

/// Friction has one k for both of its axes, or F would not oppose the slip.
template <class Kind>
void share_stiffness(const Kind&, int row, std::vector<double>& stiffness) {
  if constexpr (Kind::bound == Bound::ball) {
    Eigen::Map<Rows<Kind::rows>> both(&stiffness[row]);
    both.setConstant(both.maxCoeff());
  }
}

/// Sets how a row begins a step: its Λ and k, and how much of C it asks for.
template <class Kind, class M>
void warm_start(const Kind& constraint, const Bodies<M>& bodies, const Avbd& method, double h, int row,
                Avbd::Work<M>& work) {
  const int body1 = constraint.at.body1, body2 = constraint.at.body2;
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  const auto J = constraint.jacobian(pose1, pose2);
  const auto W = times_inverse_mass(J, bodies.inverse_mass[body1], pose1, bodies.inverse_mass[body2], pose2);
  PositionRows& rows = work.rows;
  begin_rows(constraint, bodies, h, row, rows);
  note_curvature(constraint, bodies, row, work);
  const Rows<Kind::rows> C = constraint.template value<double>(pose1, pose2);
  for (int k = 0; k < Kind::rows; ++k) {
    const double inverse_mass = J.matrix.row(k).dot(W.matrix.row(k)), gamma = rows.gamma[row + k];
    const bool hard = gamma == 0;
    if (k < Kind::drifting && hard)
      rows.ask[row + k] = -method.alpha * (Kind::bound == Bound::none ? C[k] : std::min(C[k], 0.0));
    rows.impulse[row + k] = hard ? method.alpha * method.memory * h * rows.lambda[row + k] : 0.0;
    const double least = inverse_mass > 0 ? method.softest / (h * h * inverse_mass) : 0.0;
    double& stiffness = work.stiffness[row + k];
    stiffness = hard ? std::min(std::max(method.memory * stiffness, least), method.stiffest) : 1 / (h * h * gamma);
  }
  share_stiffness(constraint, row, work.stiffness);
}

/// F of a constraint's rows where its bodies now stand, in units of Λ.
template <class Kind, class M>
Rows<Kind::rows> force(const Kind& constraint, const Bodies<M>& bodies, double h, int row,
                       const Avbd::Work<M>& work) {
  constexpr int K = Kind::rows;
  const Rows<K> C = gap(constraint, bodies, row, work.rows);
  Rows<K> F;
  for (int k = 0; k < K; ++k)
    F[k] = (work.rows.gamma[row + k] == 0 ? work.rows.impulse[row + k] : 0.0) -
           h * h * work.stiffness[row + k] * C[k];
  const ImpulseBounds bounds = impulse_bounds(constraint, h, work.rows);
  return bounded<K, Kind::bound>(F, bounds.lower, bounds.upper, bounds.leader);
}

/// The new Λ of a constraint's rows, and k where F is inside its bounds.
template <class Kind, class M>
void update_rows(const Kind& constraint, const Bodies<M>& bodies, const Avbd& method, double h, int row,
                 Avbd::Work<M>& work) {
  constexpr int K = Kind::rows;
  const Rows<K> C = gap(constraint, bodies, row, work.rows);
  const Rows<K> F = force(constraint, bodies, h, row, work);
  for (int k = 0; k < K; ++k) {
    const double gamma = work.rows.gamma[row + k];
    double& stiffness = work.stiffness[row + k];
    const double wanted = (gamma == 0 ? work.rows.impulse[row + k] : 0.0) - h * h * stiffness * C[k];
    const bool inside = F[k] == wanted;
    if (inside)
      stiffness =
          std::min(stiffness + method.beta * std::abs(C[k]), gamma == 0 ? method.stiffest : 1 / (h * h * gamma));
  }
  share_stiffness(constraint, row, work.stiffness);
  Eigen::Map<Rows<K>>(&work.rows.impulse[row]) = F;
}

/// Sets H and slope of a body that nothing holds: M, and M (x - y).
template <class M>
void begin_descent(const InverseMass<M>& mass, const Pose<M>& pose, const Pose<M>& free,
                   Eigen::Matrix<double, M::dof, M::dof>& H, Velocity<M>& slope);
/// Moves a pose by -H⁻¹ slope.
template <class M>
void end_descent(const Eigen::Matrix<double, M::dof, M::dof>& H, const Velocity<M>& slope, Pose<M>& pose);

/// One Newton step of one body while the others stand still. Returns how many rows it has seen.
template <class S, class M>
int descend(S& scene, int body, double h, Avbd::Work<M>& work) {
  constexpr int dof = M::dof;
  Bodies<M>& bodies = scene.bodies;
  Pose<M>& pose = bodies.pose[body];
  Eigen::Matrix<double, dof, dof> H;
  Velocity<M> slope;
  begin_descent<M>(bodies.inverse_mass[body], pose, work.free[body], H, slope);
  int seen = 0;
  for (int i = work.first[body]; i < work.first[body + 1]; ++i)
    scene.visit(work.constraint[i], [&]<class Kind>(const Kind& constraint) {
      constexpr int K = Kind::rows;
      const int row = work.rows.row_of[work.constraint[i]];
      const int first = constraint.at.body1 == body ? 0 : dof;
      const auto J = constraint.jacobian(bodies.pose[constraint.at.body1], bodies.pose[constraint.at.body2]);
      const Eigen::Matrix<double, K, dof> side = J.matrix.template middleCols<dof>(first);
      const Rows<K> F = force(constraint, bodies, h, row, work);
      for (int k = 0; k < K; ++k) {
        H += h * h * work.stiffness[row + k] * side.row(k).transpose() * side.row(k);
        H.diagonal() +=
            std::abs(F[k]) * Eigen::Map<const Velocity<M>>(&work.curvature[2 * dof * (row + k) + first]);
      }
      slope -= side.transpose() * F;
      seen += K;
    });
  end_descent<M>(H, slope, pose);
  return seen;
}

}  // namespace detail

//! [step]
/// One time step [s]. Throws std::invalid_argument for a step <= 0 or a method outside its range.
template <class S, class M = typename S::model>
void advance(S& scene, const Avbd& method, double h, Avbd::Work<M>& work) {
  require_steppable(scene, method, h);
  if constexpr (S::touches) work.touching.find(scene);
  if (const int kept = work.rows.lasting; lay_out(scene, work.rows)) {
    work.stiffness.resize(std::min(kept, work.rows.lasting));
    work.stiffness.resize(work.rows.rows());
    work.curvature.resize(2 * M::dof * work.rows.rows());
    detail::list_neighbours(scene, work);
  }
  if constexpr (S::touches) work.touching.template write_impulses<S>(work.rows);
  Bodies<M>& bodies = scene.bodies;
  if (work.h > 0 && work.h != h)
    for (double& lambda : work.rows.lambda) lambda *= h / work.h;
  work.h = h;
  for_each_with_row(scene, [&](const auto& constraint, int row) {
    detail::warm_start(constraint, bodies, method, h, row, work);
  });
  begin_turn(method.gyroscopic, bodies, h);
  work.before = bodies.pose;
  advance_poses(bodies, h);
  work.free = bodies.pose;
  for (Pose<M>& pose : work.free) pose.position += h * h * scene.gravity;
  for (int i = 0; i < method.iterations; ++i) {
    for (int body = 0; body < bodies.size(); ++body)
      if (moves(bodies.inverse_mass[body])) work.row_solves += detail::descend(scene, body, h, work);
    for_each_with_row(scene, [&](const auto& constraint, int row) {
      detail::update_rows(constraint, bodies, method, h, row, work);
    });
    work.row_solves += work.rows.rows();
  }
  velocities_between(work.before, h, bodies);
  end_turn(method.gyroscopic, bodies, h);
  work.row_solves += end_rows(scene, h, method.bounce_threshold, work.rows);
  if constexpr (S::touches) work.touching.template read_impulses<S>(work.rows);
}
//! [step]

}  // namespace byhand
