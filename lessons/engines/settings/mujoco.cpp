#include "lessons/engines/settings.hpp"

// MuJoCo. Its default step is 1/500 s, so that as shipped it takes 8 steps a frame. Knobs: RK4, a switch: the
// classical Runge–Kutta rule in place of semi-implicit Euler; of contacts solref, the time constant of a contact
// [s] (0.02, no less than two steps), elliptic, a switch: the round cone in place of the pyramid, and impratio
// (1), how much stiffer friction is than the normal force.
namespace byhand::engines {

Settings mujoco_settings() {
  Settings all{
      .joints = {{.steps = 8},
                 {.row = Row::advised,
                  .knobs = {{"RK4", 1}},
                  .steps = 8,
                  .source = "documentation, Computation: RK4 where energy is to be kept"}},
      .contacts = {{.steps = 8},
                   {.row = Row::advised,
                    .knobs = {{"elliptic", 1}, {"impratio", 10}},
                    .steps = 8,
                    .source = "documentation, Modeling: slip is reduced by elliptic cones and a large impratio"}}};
  for (const int rk4 : {0, 1})
    for (const int steps : joint_steps)
      all.joints.push_back({.row = Row::tuned, .knobs = {{"RK4", rk4}}, .steps = steps});
  for (const double ratio : {100.0, 1000.0})
    for (const int steps : contact_steps)
      all.contacts.push_back({.row = Row::tuned, .knobs = {{"elliptic", 1}, {"impratio", ratio}}, .steps = steps});
  for (const int steps : contact_steps)
    all.contacts.push_back({.row = Row::tuned, .knobs = {{"solref", 2.0 / (60 * steps)}}, .steps = steps});
  return all;
}

}  // namespace byhand::engines
