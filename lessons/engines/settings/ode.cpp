#include "lessons/engines/settings.hpp"

// The Open Dynamics Engine. Knobs: ERP (0.2), the share of an error that a step takes back; CFM (1e-10), the
// softness of a row; layer [m] (0), the overlap that a contact may keep; of QuickStep iterations (20).
namespace byhand::engines {
namespace {

const std::string layer_source = "objects.h, dWorldSetContactSurfaceLayer: 0.001 can prevent jittering",
                  step_source =
                      "wiki, HOWTO make the simulation better: a smaller step is more accurate and more stable";

}  // namespace

Settings ode_quick_settings() {
  Settings all{.joints = {{}, {.row = Row::advised, .steps = 4, .source = step_source}},
               .contacts = {{}, {.row = Row::advised, .knobs = {{"layer", 0.001}}, .source = layer_source}}};
  for (const double erp : {0.2, 0.8}) {
    for (const auto& [steps, iterations] : shares_of_joints())
      all.joints.push_back(
          {.row = Row::tuned, .knobs = {{"iterations", iterations}, {"ERP", erp}}, .steps = steps});
    for (const auto& [steps, iterations] : shares_of_contacts())
      all.contacts.push_back({.row = Row::tuned,
                              .knobs = {{"iterations", iterations}, {"layer", 0.001}, {"ERP", erp}},
                              .steps = steps});
  }
  return all;
}

Settings ode_direct_settings() {
  Settings all{.joints = {{}, {.row = Row::advised, .steps = 4, .source = step_source}},
               .contacts = {{}, {.row = Row::advised, .knobs = {{"layer", 0.001}}, .source = layer_source}}};
  for (const double erp : {0.2, 0.8}) {
    for (const int steps : joint_steps)
      all.joints.push_back({.row = Row::tuned, .knobs = {{"ERP", erp}}, .steps = steps});
    for (const int steps : contact_steps)
      all.contacts.push_back({.row = Row::tuned, .knobs = {{"layer", 0.001}, {"ERP", erp}}, .steps = steps});
  }
  return all;
}

}  // namespace byhand::engines
