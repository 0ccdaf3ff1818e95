#include "solver/methods/accelerations.hpp"

namespace byhand {

void require_valid(const Accelerations& family) {
  require(family.substeps >= 1, "number of substeps", family.substeps, "at least 1");
  require_in("regularisation", family.regularisation, 0, 1);
}

template <class M>
void write_free_accelerations(const Bodies<M>& bodies, const Linear<M>& gravity, Bodies<M>& accelerated) {
  accelerated = bodies;
  for (int i = 0; i < bodies.size(); ++i) {
    Velocity<M>& a = accelerated.velocity[i];
    a.setZero();
    if (!moves(bodies.inverse_mass[i])) continue;
    a.template head<M::linear>() = gravity;
    if constexpr (M::angular == 3) {  // Euler's equations, I Ω̇ = IΩ × Ω in the body's axes
      const Eigen::Quaterniond& q = bodies.pose[i].rotation;
      const Eigen::Vector3d &inverse_moments = bodies.inverse_mass[i].angular,
                            spin = rotate(inverse(q), bodies.velocity[i].template tail<3>());
      const Eigen::Vector3d momentum = spin.cwiseQuotient(inverse_moments);
      a.template tail<3>() = rotate(q, momentum.cross(spin).cwiseProduct(inverse_moments));
    }
  }
}

namespace {

/// A pose and velocity `time` [s] along a slope.
template <class M>
void go_along(const Slope<M>& slope, double time, const Pose<M>& from, const Velocity<M>& from_velocity,
              Pose<M>& pose, Velocity<M>& velocity) {
  velocity = from_velocity + time * slope.acceleration;
  if constexpr (M::angular == 3) {
    pose.position = from.position + time * slope.velocity.template head<3>();
    pose.rotation.coeffs() = (from.rotation.coeffs() + time * slope.turning).normalized();
  } else {
    pose = moved<M, double>(from, slope.velocity, time);
  }
}

}  // namespace

template <class M>
void add_stage(const Stage& stage, Bodies<M>& bodies, AccelerationsWork<M>& work) {
  for (std::size_t row = 0; row < work.change.size(); ++row)
    work.system.lambda[row] += stage.weight * work.h * work.change[row];
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    Slope<M> slope{bodies.velocity[i], work.accelerated.velocity[i]};
    if constexpr (M::angular == 3)
      slope.turning = turning(bodies.pose[i].rotation, slope.velocity.template tail<3>()).coeffs();
    Slope<M>& sum = work.sum[i];
    sum.velocity += stage.weight * slope.velocity;
    sum.acceleration += stage.weight * slope.acceleration;
    sum.turning += stage.weight * slope.turning;
    if (stage.to_next > 0)
      go_along(slope, stage.to_next * work.h, work.begin.pose[i], work.begin.velocity[i], bodies.pose[i],
               bodies.velocity[i]);
  }
}

template <class M>
void finish_stages(Bodies<M>& bodies, AccelerationsWork<M>& work) {
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      go_along(work.sum[i], work.h, work.begin.pose[i], work.begin.velocity[i], bodies.pose[i],
               bodies.velocity[i]);
}

template <class M>
double go_to_middle(Bodies<M>& bodies, const AccelerationsWork<M>& work) {
  double largest = 0;
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Velocity<M> V = work.begin.velocity[i] + work.h / 2 * work.accelerated.velocity[i];
    const double change = (V - bodies.velocity[i]).cwiseAbs().maxCoeff();
    if (!(change <= largest)) largest = change;  // also where it is no number
    bodies.velocity[i] = V;
    bodies.pose[i] = moved<M, double>(work.begin.pose[i], V, work.h / 2);
  }
  return largest;
}

template <class M>
void go_to_end(Bodies<M>& bodies, AccelerationsWork<M>& work) {
  for (std::size_t row = 0; row < work.change.size(); ++row) work.system.lambda[row] = work.h * work.change[row];
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    bodies.pose[i] = moved<M, double>(work.begin.pose[i], bodies.velocity[i], work.h);
    bodies.velocity[i] = work.begin.velocity[i] + work.h * work.accelerated.velocity[i];
  }
}

#define BYHAND_INSTANTIATE(M)                                                             \
  template void write_free_accelerations(const Bodies<M>&, const Linear<M>&, Bodies<M>&); \
  template void add_stage(const Stage&, Bodies<M>&, AccelerationsWork<M>&);               \
  template void finish_stages(Bodies<M>&, AccelerationsWork<M>&);                         \
  template double go_to_middle(Bodies<M>&, const AccelerationsWork<M>&);                  \
  template void go_to_end(Bodies<M>&, AccelerationsWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
