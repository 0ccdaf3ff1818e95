#include "lessons/engines/settings.hpp"

// PhysX. Knob of setSolverIterationCounts: iterations (4, at most 255), among which TGS divides the step.
// Articulations, which have no rows for their joints, are given shorter steps.
namespace byhand::engines {
namespace {

constexpr int most_iterations = 255;  // PxRigidDynamic.h

}  // namespace

Settings physx_settings() {
  const Setting advised{.row = Row::advised,
                        .knobs = {{"iterations", 30}},
                        .source =
                            "guide, Rigid Body Dynamics, Solver Iterations: more for many joints and little "
                            "joint error, and no more than 30"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  const auto add = [](std::vector<Setting>& list, const std::vector<Shares>& shares) {
    for (const auto& [steps, iterations] : shares)
      if (iterations <= most_iterations)
        list.push_back({.row = Row::tuned, .knobs = {{"iterations", iterations}}, .steps = steps});
  };
  add(all.joints, shares_of_joints());
  add(all.contacts, shares_of_contacts());
  return all;
}

Settings physx_articulation_settings() {
  const Setting advised{
      .row = Row::advised, .steps = 2, .source = "NVIDIA's Isaac Lab, PhysX Configuration, an example: 1/120 s"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (const int steps : joint_steps) all.joints.push_back({.row = Row::tuned, .steps = steps});
  for (const int steps : contact_steps) all.contacts.push_back({.row = Row::tuned, .steps = steps});
  return all;
}

}  // namespace byhand::engines
