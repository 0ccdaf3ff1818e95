#include "lessons/engines/settings.hpp"

// Rapier. Knob: iterations (4), numSolverIterations of World, which are substeps.
namespace byhand::engines {

Settings rapier_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"iterations", 8}},
      .source = "documentation of IntegrationParameters, example: 8 for a more accurate simulation"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (auto* list : {&all.joints, &all.contacts})
    for (const int steps : {1, 2, 4, 8, 16})
      for (const int iterations : {4, 16, 64})
        list->push_back({.row = Row::tuned, .knobs = {{"iterations", iterations}}, .steps = steps});
  return all;
}

}  // namespace byhand::engines
