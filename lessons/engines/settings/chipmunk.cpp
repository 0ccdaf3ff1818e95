#include "lessons/engines/settings.hpp"

// Chipmunk. Knobs: iterations (10); slop [m] (0.1), which is meant for lengths in pixels; joint bias and collision
// bias, the share of an error that a sixtieth of a second takes back (0.1).
namespace byhand::engines {

Settings chipmunk_settings() {
  const Setting advised{.row = Row::advised,
                        .knobs = {{"iterations", 20}},
                        .source = "manual, cpSpace, Iterations: each makes the solution more accurate"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (const double bias : {0.1, 0.5}) {
    for (const auto& [steps, iterations] : shares_of_joints())
      all.joints.push_back(
          {.row = Row::tuned, .knobs = {{"iterations", iterations}, {"joint bias", bias}}, .steps = steps});
    for (const auto& [steps, iterations] : shares_of_contacts())
      all.contacts.push_back({.row = Row::tuned,
                              .knobs = {{"iterations", iterations}, {"slop", 0.001}, {"collision bias", bias}},
                              .steps = steps});
  }
  return all;
}

}  // namespace byhand::engines
