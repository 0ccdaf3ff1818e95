#include "lessons/engines/settings.hpp"

// Bullet. Knobs of btContactSolverInfo: iterations (10); ERP of joints and contact ERP (0.2), the share of an
// error that a step takes back; CFM (0). NNCG, a switch: the solver of conjugate gradients in place of
// sequential impulses. DANTZIG, a switch: btMLCPSolver with Dantzig's pivoting, a direct solve, for joints.
namespace byhand::engines {

Settings bullet_settings() {
  const Setting advised{.row = Row::advised,
                        .knobs = {{"iterations", 50}},
                        .steps = 4,
                        .source =
                            "PyBullet Quickstart Guide, setTimeStep and setPhysicsEngineParameter: 1/240 s and 50 "
                            "iterations, for which "
                            "its other parameters are tuned"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  const auto tried = [](const Shares& shares, int conjugate, const char* name, double erp) -> Setting {
    return {.row = Row::tuned,
            .knobs = {{"iterations", shares.iterations}, {"NNCG", conjugate}, {name, erp}},
            .steps = shares.steps};
  };
  for (const int conjugate : {0, 1})
    for (const double erp : {0.2, 0.8}) {
      for (const Shares& shares : shares_of_joints()) all.joints.push_back(tried(shares, conjugate, "ERP", erp));
      for (const Shares& shares : shares_of_contacts())
        all.contacts.push_back(tried(shares, conjugate, "contact ERP", erp));
    }
  for (const double erp : {0.2, 0.8})
    for (const int steps : joint_steps)
      all.joints.push_back({.row = Row::tuned, .knobs = {{"DANTZIG", 1}, {"ERP", erp}}, .steps = steps});
  return all;
}

/// Knob: RK4, a switch: the classical Runge–Kutta rule in place of semi-implicit Euler.
Settings bullet_multibody_settings() {
  std::vector<Setting> joints{
      {},
      {.row = Row::advised, .steps = 4, .source = "PyBullet Quickstart Guide, setTimeStep: best left at 1/240 s"}};
  std::vector<Setting> contacts = joints;
  for (const int rk4 : {0, 1}) {
    for (const int steps : joint_steps)
      joints.push_back({.row = Row::tuned, .knobs = {{"RK4", rk4}}, .steps = steps});
    for (const int steps : contact_steps)
      contacts.push_back({.row = Row::tuned, .knobs = {{"RK4", rk4}}, .steps = steps});
  }
  return {.joints = joints, .contacts = contacts};
}

}  // namespace byhand::engines
