#include "lessons/engines/settings.hpp"

// Rapier. Knob: iterations (4), numSolverIterations of World, which are substeps.
namespace byhand::engines {

Settings rapier_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"iterations", 8}},
      .source = "documentation of IntegrationParameters, example: 8 for a more accurate simulation"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  const auto add = [](std::vector<Setting>& list, const std::vector<Shares>& shares) {
    for (const auto& [steps, iterations] : shares)
      list.push_back({.row = Row::tuned, .knobs = {{"iterations", iterations}}, .steps = steps});
  };
  add(all.joints, shares_of_joints());
  add(all.contacts, shares_of_contacts());
  return all;
}

}  // namespace byhand::engines
