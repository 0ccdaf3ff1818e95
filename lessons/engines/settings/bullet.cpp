#include "lessons/engines/settings.hpp"

// Bullet. Knobs of btContactSolverInfo: iterations (10); ERP of joints and contact ERP (0.2), the share of an
// error that a step takes back; CFM (0). NNCG 1: the solver of conjugate gradients in place of sequential
// impulses.
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
  for (const int steps : {1, 2, 4, 8})
    for (const int iterations : {10, 50, 200})
      for (const int conjugate : {0, 1})
        for (const double erp : {0.2, 0.8}) {
          all.joints.push_back({.row = Row::tuned,
                                .knobs = {{"iterations", iterations}, {"NNCG", conjugate}, {"ERP", erp}},
                                .steps = steps});
          all.contacts.push_back({.row = Row::tuned,
                                  .knobs = {{"iterations", iterations}, {"NNCG", conjugate}, {"contact ERP", erp}},
                                  .steps = steps});
        }
  return all;
}

/// Knob: RK4 1, the classical Runge–Kutta rule in place of semi-implicit Euler.
Settings bullet_multibody_settings() {
  std::vector<Setting> joints{
      {},
      {.row = Row::advised, .steps = 4, .source = "PyBullet Quickstart Guide, setTimeStep: best left at 1/240 s"}};
  for (const int steps : {1, 2, 4, 8, 16, 32})
    for (const int rk4 : {0, 1}) joints.push_back({.row = Row::tuned, .knobs = {{"RK4", rk4}}, .steps = steps});
  return {.joints = joints, .contacts = joints};
}

}  // namespace byhand::engines
