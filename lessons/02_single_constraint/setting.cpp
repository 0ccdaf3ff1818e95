#include "lessons/02_single_constraint/setting.hpp"

namespace byhand::single_constraint {

OneRow::OneRow(const Pendulum& scene) {
  const auto& rod = scene.all<Distance>().front();
  const auto& pose = scene.bodies().pose;
  const auto& inverse_mass = scene.bodies().inverse_mass;
  J = rod.jacobian(pose[0], pose[1]);
  W = times_inverse_mass(J, inverse_mass[0], pose[0], inverse_mass[1], pose[1]);
  v1 = scene.bodies().velocity[0];
  v2 = scene.bodies().velocity[1];
  d = rod.at.separation(pose[0], pose[1]);
  JV = dot(J, v1, v2)[0];
  K = inverse_effective_mass(J, W)(0, 0);
  lambda = impulse<PlaneParticle>(J, W, v1, v2, 0);
}

std::pair<Vector, Vector> OneRow::velocities_after(double impulse) const {
  std::pair<Vector, Vector> after{v1, v2};
  apply_impulse<PlaneParticle, 1>(W, Rows<1>(impulse), after.first, after.second);
  return after;
}

OneRow shown_row(const Setting& setting) {
  OneRow row(let_go(setting));
  const double gain = gravity() * setting.h(), length = setting.length();
  row.d = course::without_rounding(row.d);
  row.v2 = course::without_rounding(row.v2);
  row.JV = course::without_rounding(row.JV, length * gain);
  row.lambda = course::without_rounding(row.lambda, setting.mass() * gain / length);
  return row;
}

}  // namespace byhand::single_constraint
