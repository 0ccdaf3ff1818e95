#include "lessons/06_joints/linkage.hpp"

namespace byhand::joints {

FourBarOptions bars_of(const Setting& setting, double angle, int arms) {
  const double length = setting.length;
  return {length, 1.5 * length, setting.mass, setting.coupler, angle, arms};
}

double arm_angle(const FourBar& linkage, int arm) {
  const auto& rotation = linkage.scene.bodies().pose[arm].rotation;
  return std::atan2(rotation.cos, -rotation.sin);  // the body's x axis runs down the arm
}

}  // namespace byhand::joints
