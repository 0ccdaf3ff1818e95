#include "lessons/engines/settings.hpp"

// The Open Dynamics Engine. Knobs: ERP (0.2), the share of an error that a step takes back; CFM (1e-10), the
// softness of a row; layer [m] (0), the overlap that a contact may keep; of QuickStep iterations (20) and the seed
// (1) of the random order of its rows.
namespace byhand::engines {
namespace {

const std::string
    layer_source = "objects.h: dWorldSetContactSurfaceLayer, 0.001 can prevent jittering",
    iterations_source =
        layer_source + "; dWorldSetQuickStepNumIterations: more iterations give a more accurate solution",
    contact_source = layer_source +
                     "; more CFM is the first remedy for rows that are nearly singular, 1e-5 being what it has in "
                     "single precision",
    step_source = "wiki, HOWTO make the simulation better: a smaller step is more accurate and more stable";
const Setting advised_for_joints{.row = Row::advised, .steps = 2, .source = step_source},
    quick_for_contacts{
        .row = Row::advised, .knobs = {{"iterations", 40}, {"layer", 0.001}}, .source = iterations_source},
    direct_for_contacts{.row = Row::advised, .knobs = {{"layer", 0.001}, {"CFM", 1e-5}}, .source = contact_source};

}  // namespace

Settings ode_quick_settings() {
  Settings all{.joints = {{}, advised_for_joints}, .contacts = {{}, quick_for_contacts}};
  for (const double erp : {0.2, 0.8}) {
    for (const auto& [steps, iterations] : shares_of_joints())
      all.joints.push_back(
          {.row = Row::tuned, .knobs = {{"iterations", iterations}, {"ERP", erp}}, .steps = steps});
    for (const auto& [steps, iterations] : shares_of_contacts())
      for (const double cfm : {1e-10, 1e-5})
        all.contacts.push_back(
            {.row = Row::tuned,
             .knobs = {{"iterations", iterations}, {"layer", 0.001}, {"ERP", erp}, {"CFM", cfm}},
             .steps = steps});
  }
  return all;
}

Settings ode_direct_settings() {
  Settings all{.joints = {{}, advised_for_joints}, .contacts = {{}, direct_for_contacts}};
  for (const double erp : {0.2, 0.8}) {
    for (const int steps : joint_steps)
      all.joints.push_back({.row = Row::tuned, .knobs = {{"ERP", erp}}, .steps = steps});
    for (const int steps : contact_steps)
      for (const double cfm : {1e-10, 1e-5})
        all.contacts.push_back(
            {.row = Row::tuned, .knobs = {{"layer", 0.001}, {"ERP", erp}, {"CFM", cfm}}, .steps = steps});
  }
  return all;
}

}  // namespace byhand::engines
