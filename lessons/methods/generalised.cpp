#include "lessons/methods/generalised.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "lessons/methods/displacement.hpp"
#include "solver/integrate/jet.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

template <class M>
using Work = Generalised::Work<M>;
template <class M>
using Part = Generalised::Articulated<M>;
template <class M>
using Slope = Generalised::Slope<M>;

/// r as the matrix that takes ω to ω × r.
template <class M>
Packed<double, M::linear, M::angular> turning_matrix(const Linear<M>& r) {
  Packed<double, M::linear, M::angular> matrix;
  if constexpr (M::angular > 0)
    for (int k = 0; k < M::angular; ++k) matrix.col(k) = turned<M>(Angular<M>::Unit(k), r);
  return matrix;
}

/// ω × (ω × r) [m/s²].
template <class M>
Linear<M> centripetal(const Angular<M>& rate, const Linear<M>& r) {
  return turned<M>(rate, turned<M>(rate, r));
}

/// Calls f with the number of freedoms of a joint, as a constant.
template <class M, class F>
void with_freedoms(JointKind kind, F&& f) {
  switch (kind) {
    case JointKind::free: return f(std::integral_constant<int, M::dof>());
    case JointKind::pin: return f(std::integral_constant<int, M::angular>());
    case JointKind::rod: return f(std::integral_constant<int, M::dof - 1>());
    case JointKind::hinge:
    case JointKind::slider: return f(std::integral_constant<int, 1>());
    case JointKind::weld: return f(std::integral_constant<int, 0>());
  }
}

/// The ways in which a rod's direction e can turn, as columns.
template <class M>
Packed<double, M::linear, M::linear - 1> across_rod(const Linear<M>& e) {
  if constexpr (M::linear == 2)
    return {-e.y(), e.x()};
  else
    return tangents_of<M>(e);
}

/// Writes X, S and c of a joint at the bodies' poses and velocities.
template <class M>
void write_joint(const Joint<M>& joint, const JointState<M>& state, const JointFrame<M>& frame,
                 const Bodies<M>& bodies, Part<M>& part) {
  part.c.setZero();
  if (joint.kind == JointKind::free) {
    part.S.setIdentity();
    return;
  }
  const Angular<M> parent_spin = bodies.velocity[joint.parent].template tail<M::angular>(),
                   own = bodies.velocity[joint.body].template tail<M::angular>();
  const Linear<M> apart = bodies.pose[joint.body].position - bodies.pose[joint.parent].position;
  auto c = part.c.template head<M::linear>();
  part.carries = joint.kind != JointKind::pin && joint.kind != JointKind::rod;
  part.reach = turning_matrix<M>(part.carries ? apart : frame.r1);
  c = centripetal<M>(parent_spin, frame.r1) - centripetal<M>(own, frame.r2);
  if (joint.kind == JointKind::rod) {
    const Linear<M> e = state.at.position;
    part.S.template topLeftCorner<M::linear, M::linear - 1>() = joint.length * across_rod<M>(e);
    part.S.template bottomLeftCorner<M::angular, M::linear - 1>().setZero();
    c -= joint.length * turning_of_rod<M>(state).squaredNorm() * e;
  }
  if (joint.kind == JointKind::pin || joint.kind == JointKind::rod) {
    const int first = joint.kind == JointKind::rod ? M::linear - 1 : 0;
    part.S.template block<M::linear, M::angular>(0, first) = -turning_matrix<M>(frame.r2);
    part.S.template block<M::angular, M::angular>(M::linear, first).setIdentity();
    return;
  }
  if constexpr (M::angular > 0) {
    auto S = part.S.col(0);
    if (joint.kind == JointKind::slider) {
      S << frame.axis, Angular<M>::Zero();
      const double rate = state.rate.template head<M::linear>().dot(joint.axis);
      c = centripetal<M>(parent_spin, apart) + 2 * rate * turned<M>(parent_spin, frame.axis);
    }
    if constexpr (M::angular == 3)
      if (joint.kind == JointKind::hinge) {
        S << -turned<M>(frame.axis, frame.r2), frame.axis;
        const Linear<M> turn = parent_spin.cross(own - parent_spin);
        part.c.template tail<3>() = turn;
        c -= turned<M>(turn, frame.r2);
      }
  }
}

/// Takes a joint's freedoms F out of A and p, so that what is left acts on the parent.
template <int F, class M>
void eliminate(Part<M>& part) {
  part.p += part.A.lazyProduct(part.c);
  if constexpr (F > 0) {
    using Square = Eigen::Matrix<double, F, F>;
    const Eigen::Matrix<double, M::dof, F> S = part.S.template leftCols<F>(), AS = part.A.lazyProduct(S);
    const Square SAS = S.transpose().lazyProduct(AS);
    Square inverse;
    if constexpr (F <= 3)
      inverse = SAS.inverse();
    else
      inverse = SAS.llt().solve(Square::Identity());
    const Eigen::Matrix<double, M::dof, F> K = AS.lazyProduct(inverse);
    const Eigen::Matrix<double, F, 1> Sp = S.transpose().lazyProduct(part.p);
    part.rest.template head<F>() = inverse.lazyProduct(Sp);
    part.A -= K.lazyProduct(AS.transpose());
    part.p -= K.lazyProduct(Sp);
    part.K.template leftCols<F>() = K;
  }
}

/// A_p += XᵀĀX, p_p += Xᵀp̄.
template <class M>
void add_to_parent(const Part<M>& part, Part<M>& parent) {
  constexpr int L = M::linear, R = M::angular;
  const Packed<double, L, L> A = part.A.template topLeftCorner<L, L>();
  const Linear<M> force = part.p.template head<L>();
  parent.A.template topLeftCorner<L, L>() += A;
  parent.p.template head<L>() += force;
  if constexpr (R > 0) {
    Packed<double, L, R> across = A.lazyProduct(part.reach);
    Packed<double, R, R> turning = Packed<double, R, R>::Zero();
    Angular<M> torque = part.reach.transpose().lazyProduct(force);
    if (part.carries) {
      const Packed<double, L, R> own = part.A.template topRightCorner<L, R>();
      across += own;
      turning = part.A.template bottomRightCorner<R, R>() + own.transpose().lazyProduct(part.reach);
      torque += part.p.template tail<R>();
    }
    turning += part.reach.transpose().lazyProduct(across);
    parent.A.template topRightCorner<L, R>() += across;
    parent.A.template bottomLeftCorner<R, L>() += across.transpose();
    parent.A.template bottomRightCorner<R, R>() += turning;
    parent.p.template tail<R>() += torque;
  }
}

/// Moves what turns or moves by itself to its place `time` [s] after the start of the step.
template <class M>
void place_driven(Bodies<M>& bodies, const Work<M>& work, double time) {
  for (int i = 0; i < bodies.size(); ++i)
    if (!moves(bodies.inverse_mass[i]) && in_motion(bodies, i))
      bodies.pose[i] = moved<M, double>(work.start.pose[i], bodies.velocity[i], time);
}

/// Writes poses and velocities of all bodies from the joints' numbers.
template <class M>
void place_bodies(Bodies<M>& bodies, double time, Work<M>& work) {
  place_driven(bodies, work, time);
  for (std::size_t j = 0; j < work.joints.size(); ++j)
    work.frame[j] = place_body(work.joints[j], work.state[j], bodies);
}

/// Writes q̈ of a joint's freedoms as the acceleration of its numbers.
template <class M, class Freedoms>
void write_acceleration(const Joint<M>& joint, const JointState<M>& state, const Freedoms& q, const Part<M>& part,
                        Velocity<M>& acceleration) {
  constexpr int L = M::linear, R = M::angular;
  acceleration.setZero();
  if constexpr (Freedoms::RowsAtCompileTime == M::dof)
    if (joint.kind == JointKind::free) acceleration = q;
  if constexpr (Freedoms::RowsAtCompileTime == M::dof - 1)
    if (joint.kind == JointKind::rod) {
      if constexpr (L == 2)
        acceleration[0] = q[0];
      else
        acceleration.template head<3>() =
            part.S.template topLeftCorner<3, 2>().lazyProduct(q.template head<2>()) / joint.length -
            turning_of_rod<M>(state).squaredNorm() * state.at.position;
      acceleration.template tail<R>() = q.template tail<R>();
    }
  if constexpr (R > 0 && Freedoms::RowsAtCompileTime == R)
    if (joint.kind == JointKind::pin) acceleration.template tail<R>() = q;
  if constexpr (R > 0 && Freedoms::RowsAtCompileTime == 1) {
    if (joint.kind == JointKind::slider) acceleration.template head<L>() = q[0] * joint.axis;
    if constexpr (R == 3)
      if (joint.kind == JointKind::hinge) acceleration.template tail<R>() = q[0] * joint.axis;
  }
}

/// The slopes of the joints' numbers, at `time` [s] after the start of the step.
template <class M>
void evaluate(Scene<M>& scene, double time, Work<M>& work, std::vector<Slope<M>>& slopes) {
  constexpr int L = M::linear, R = M::angular;
  Bodies<M>& bodies = scene.state();
  place_bodies(bodies, time, work);
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    const Joint<M>& joint = work.joints[j];
    Part<M>& part = work.part[joint.body];
    write_joint(joint, work.state[j], work.frame[j], bodies, part);
    const InverseMass<M>& mass = bodies.inverse_mass[joint.body];
    const Velocity<M> free = free_acceleration(bodies, joint.body, scene.gravity);
    part.A.setZero();
    part.A.template topLeftCorner<L, L>().diagonal().setConstant(1 / mass.linear);
    part.p.template head<L>() = -free.template head<L>() / mass.linear;
    if constexpr (R > 0) {
      part.A.template bottomRightCorner<R, R>() = inertia<M>(mass, bodies.pose[joint.body]);
      part.p.template tail<R>() = -part.A.template bottomRightCorner<R, R>().lazyProduct(free.template tail<R>());
    }
  }
  for (std::size_t j = work.joints.size(); j-- > 0;) {
    const Joint<M>& joint = work.joints[j];
    Part<M>& part = work.part[joint.body];
    with_freedoms<M>(joint.kind, [&](auto freedoms) {
      eliminate<freedoms>(part);
      work.row_solves += freedoms > 3 ? 3 : 1;  // a matrix that is factored takes as long as three that are not
    });
    if (moves(bodies.inverse_mass[joint.parent]) && joint.kind != JointKind::free)
      add_to_parent(part, work.part[joint.parent]);
  }
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    const Joint<M>& joint = work.joints[j];
    const Part<M>& part = work.part[joint.body];
    Velocity<M>& a = work.acceleration[joint.body];
    a.setZero();
    if (joint.kind != JointKind::free && moves(bodies.inverse_mass[joint.parent])) {
      const Velocity<M>& parent = work.acceleration[joint.parent];
      a.template head<L>() = parent.template head<L>();
      if constexpr (R > 0) a.template head<L>() += part.reach.lazyProduct(parent.template tail<R>());
      if (part.carries) a.template tail<R>() = parent.template tail<R>();
    }
    Slope<M>& slope = slopes[j];
    slope.rate = work.state[j].rate;
    if constexpr (R == 3)
      slope.turning = turning(work.state[j].at.rotation, slope.rate.template tail<3>()).coeffs();
    with_freedoms<M>(joint.kind, [&](auto freedoms) {
      constexpr int F = freedoms;
      const Eigen::Matrix<double, F, 1> q =
          -part.rest.template head<F>() - part.K.template leftCols<F>().transpose().lazyProduct(a);
      a += part.c + part.S.template leftCols<F>().lazyProduct(q);
      write_acceleration(joint, work.state[j], q, part, slope.acceleration);
    });
  }
  ++work.executed.solves;
}

/// An explicit rule: when its slopes are, how far along those before each, and the weights of all.
template <int stages>
struct Tableau {
  double when[stages], along[stages][stages], weights[stages];
};
/// The classical rule of Runge and Kutta.
constexpr Tableau<4> classical{
    {0, 0.5, 0.5, 1}, {{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
/// Fehlberg's rule of order 4, whose sixth slope serves the weights of order 5 alone. E. Fehlberg, Low-order
/// classical Runge–Kutta formulas with stepsize control, NASA TR R-315, 1969, formula 2 of RK4(5).
constexpr Tableau<6> fehlbergs{{0, 1.0 / 4, 3.0 / 8, 12.0 / 13, 1, 1.0 / 2},
                               {{},
                                {1.0 / 4},
                                {3.0 / 32, 9.0 / 32},
                                {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
                                {439.0 / 216, -8, 3680.0 / 513, -845.0 / 4104},
                                {-8.0 / 27, 2, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40}},
                               {25.0 / 216, 0, 1408.0 / 2565, 2197.0 / 4104, -1.0 / 5}};
constexpr double fehlbergs_fifth[] = {16.0 / 135, 0, 6656.0 / 12825, 28561.0 / 56430, -9.0 / 50, 2.0 / 55};

/// A unit vector along a rod in space, and a rate across it.
template <class M>
void tidy(const Joint<M>& joint, JointState<M>& state) {
  if constexpr (M::linear == 3) {
    if (joint.kind != JointKind::rod) return;
    auto rate = state.rate.template head<3>();
    state.at.position.normalize();
    rate -= state.at.position * state.at.position.dot(rate);
  }
}

/// Writes the state that lies h [s] along these shares of the slopes from the start of the step.
template <class M>
void go_along(std::span<const double> shares, double h, Work<M>& work) {
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    Slope<M> sum;
    for (std::size_t s = 0; s < shares.size(); ++s) {
      if (shares[s] == 0) continue;
      const Slope<M>& slope = work.slope[s][j];
      sum.rate += shares[s] * slope.rate;
      sum.acceleration += shares[s] * slope.acceleration;
      sum.turning += shares[s] * slope.turning;
    }
    const JointState<M>& from = work.begin[j];
    JointState<M>& to = work.state[j];
    to.at = from.at;
    if constexpr (M::linear == 3) {
      to.at.position += h * sum.rate.template head<3>();
      if constexpr (M::angular == 3)
        to.at.rotation.coeffs() = (from.at.rotation.coeffs() + h * sum.turning).normalized();
    } else {
      to.rate = sum.rate;
      move_joint(work.joints[j], h, to);
    }
    to.rate = from.rate + h * sum.acceleration;
    tidy(work.joints[j], to);
  }
}

/// Writes the slopes of a step from `time` [s] after the start of the whole, the first of which is there.
template <class M, int stages>
void write_slopes(Scene<M>& scene, const Tableau<stages>& rule, double time, double h, Work<M>& work) {
  work.begin = work.state;
  for (int s = 1; s < stages; ++s) {
    go_along<M>(std::span(rule.along[s], s), h, work);
    evaluate(scene, time + rule.when[s] * h, work, work.slope[s]);
  }
}

/// One step of semi-implicit Euler: q̇ by the accelerations at its start, then q by the new q̇.
template <class M>
void semi_implicit_euler(Scene<M>& scene, double time, double h, Work<M>& work) {
  evaluate(scene, time, work, work.slope[0]);
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    work.state[j].rate += h * work.slope[0][j].acceleration;
    tidy(work.joints[j], work.state[j]);
    move_joint(work.joints[j], h, work.state[j]);
  }
}

}  // namespace

template <class M>
void read_joints(const Scene<M>& scene, Work<M>& work) {
  require_finite<M>(scene.bodies().pose, scene.bodies().velocity, "");
  if (work.version != scene.version()) {
    if (const std::string reason = refusal_unless_tree(scene); !reason.empty())
      throw std::invalid_argument(reason);
    work.version = scene.version();
    work.joints = joints_of(scene);
    const std::size_t joints = work.joints.size(), bodies = static_cast<std::size_t>(scene.bodies().size());
    work.begin.resize(joints), work.state.resize(joints), work.frame.resize(joints);
    work.part.resize(bodies), work.acceleration.resize(bodies);
    for (auto& slopes : work.slope) slopes.resize(joints);
  }
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    read_joint(scene, work.joints[j]);
    work.state[j] = state_of(work.joints[j], scene.bodies());
  }
  work.executed.prepared_rows += static_cast<long long>(work.joints.size());
}

template <class M>
double fehlberg(Scene<M>& scene, double time, double h, bool again, Work<M>& work) {
  Bodies<M>& bodies = scene.state();
  if (!again) evaluate(scene, time, work, work.slope[0]);
  write_slopes(scene, fehlbergs, time, h, work);
  go_along<M>(fehlbergs_fifth, h, work);
  place_bodies(bodies, time + h, work);
  work.other.pose = bodies.pose;
  work.other.velocity = bodies.velocity;
  go_along<M>(fehlbergs.weights, h, work);
  place_bodies(bodies, time + h, work);
  double error = 0;
  for (const Joint<M>& joint : work.joints) {
    const int body = joint.body;
    const double own =
        displacement<M>(bodies.inverse_mass[body], work.other.pose[body], bodies.pose[body]) +
        h * difference<M>(bodies.inverse_mass[body], work.other.velocity[body], bodies.velocity[body]);
    if (!(own <= error)) error = own;
  }
  return error;
}

template <class M>
void advance(Scene<M>& scene, const Generalised& method, double step, Generalised::Work<M>& work) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if (const std::string reason = refusal_unless_equalities(scene, Generalised::name); !reason.empty())
    throw std::invalid_argument(reason);
  Attempt attempt(scene, work);
  read_joints(scene, work);
  const double h = step / method.substeps;
  require_slow_damping(scene.bodies(), h);
  for (int i = 0; i < method.substeps; ++i) {
    if (method.rule == JointRule::rk4) {
      evaluate(scene, i * h, work, work.slope[0]);
      write_slopes(scene, classical, i * h, h, work);
      go_along<M>(classical.weights, h, work);
    } else {
      semi_implicit_euler(scene, i * h, h, work);
    }
  }
  place_bodies(scene.state(), step, work);
  attempt.finish();
}

#define BYHAND_INSTANTIATE(M)                                                          \
  template void advance(Scene<M>&, const Generalised&, double, Generalised::Work<M>&); \
  template void read_joints(const Scene<M>&, Generalised::Work<M>&);                   \
  template double fehlberg(Scene<M>&, double, double, bool, Generalised::Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
