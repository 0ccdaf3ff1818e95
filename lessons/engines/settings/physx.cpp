#include "lessons/engines/settings.hpp"

// PhysX. Knobs of setSolverIterationCounts: iterations (4), among which TGS divides the step, and velocity
// iterations (1). Articulations, which have no rows for their joints, are given shorter steps.
namespace byhand::engines {

Settings physx_settings() {
  const Setting advised{.row = Row::advised,
                        .knobs = {{"iterations", 30}},
                        .source =
                            "guide, Rigid Body Dynamics, Solver Iterations: more for many joints and little "
                            "joint error, and no more than 30"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (auto* list : {&all.joints, &all.contacts})
    for (const int steps : {1, 2, 4, 8})
      for (const int iterations : {4, 16, 64})
        list->push_back({.row = Row::tuned, .knobs = {{"iterations", iterations}}, .steps = steps});
  return all;
}

Settings physx_articulation_settings() {
  std::vector<Setting> joints{
      {}, {.row = Row::advised, .steps = 2, .source = "Isaac Lab, PhysX Configuration: 1/120 s"}};
  for (const int steps : {1, 2, 4, 8, 16, 32}) joints.push_back({.row = Row::tuned, .steps = steps});
  return {.joints = joints, .contacts = joints};
}

}  // namespace byhand::engines
