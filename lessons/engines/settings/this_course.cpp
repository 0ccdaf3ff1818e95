#include "lessons/engines/settings.hpp"

// This course's solver by velocities: ByGraph and Baumgarte. Knobs: substeps; beta, per substep; sweeps, the most
// in a step where the graph has loops (50). Switches: lesson 9's methods for joints in place of it, which are RK4,
// RATTLE, and Euler and RK4 in joint coordinates.
namespace byhand::engines {

Settings this_course_settings() {
  Settings all{.joints = {{},
                          {.row = Row::advised,
                           .knobs = {{"substeps", 4}},
                           .source = "lesson 8, law 7: T h²/ml well below a third where pinned rods are taut"}},
               .contacts = {{},
                            {.row = Row::advised,
                             .knobs = {{"sweeps", 128}},
                             .source = "ConjugateSweeps: hundreds of boxes in space take more than 50"}}};
  for (const int substeps : joint_steps) {
    for (const double beta : {0.2, 0.8})
      all.joints.push_back({.row = Row::tuned, .knobs = {{"substeps", substeps}, {"beta", beta}}});
    for (const char* method : {"RK4", "RATTLE", "Euler in joint coordinates", "RK4 in joint coordinates"})
      all.joints.push_back({.row = Row::tuned, .knobs = {{method, 1}, {"substeps", substeps}}});
  }
  for (const auto& [substeps, sweeps] : shares_of_contacts())
    all.contacts.push_back({.row = Row::tuned, .knobs = {{"sweeps", sweeps}, {"substeps", substeps}}});
  return all;
}

}  // namespace byhand::engines
