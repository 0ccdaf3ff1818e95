#include "lessons/engines/settings.hpp"

// Rapier. Knobs: iterations (4), numSolverIterations of World, which are substeps; contact hertz (30),
// contact_natural_frequency of its IntegrationParameters.
namespace byhand::engines {

Settings rapier_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"iterations", 8}},
      .source = "documentation of IntegrationParameters, example: 8 for a more accurate simulation"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (const auto& [steps, iterations] : shares_of_joints())
    all.joints.push_back({.row = Row::tuned, .knobs = {{"iterations", iterations}}, .steps = steps});
  for (const double hertz : {30.0, 240.0})
    for (const auto& [steps, iterations] : shares_of_contacts())
      all.contacts.push_back(
          {.row = Row::tuned, .knobs = {{"iterations", iterations}, {"contact hertz", hertz}}, .steps = steps});
  return all;
}

}  // namespace byhand::engines
