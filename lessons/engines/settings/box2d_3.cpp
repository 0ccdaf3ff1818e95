#include "lessons/engines/settings.hpp"

// Box2D 3. Knobs: substeps (4); joint hertz (60) and joint damping (2), constraintHertz and constraintDampingRatio
// of b2JointDef; contact hertz (30) and contact damping (10) of b2WorldDef. Joints are no stiffer than a quarter
// of the rate of substeps and contacts than an eighth, which is where both stand at four substeps of 1/60 s:
// without their hertz, more substeps buy little. Contacts that are damped more are tried softer, too; those that
// are damped most take no overlap back. A substep is one sweep, so that as many are tried as other engines are
// given iterations.
namespace byhand::engines {

Settings box2d_3_settings() {
  return soft_step_settings("box2d.h, b2World_Step: more substeps can increase accuracy, usually 4");
}

Settings soft_step_settings(const std::string& source) {
  const Setting advised{.row = Row::advised, .knobs = {{"substeps", 8}}, .source = source};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  constexpr double quarter = 15, eighth = 7.5;  // of the rate of substeps [Hz]
  for (const int substeps : substeps_of_joints)
    for (const double damping : {10.0, 2.0, 0.5})
      all.joints.push_back(
          {.row = Row::tuned,
           .knobs = {{"substeps", substeps}, {"joint hertz", quarter * substeps}, {"joint damping", damping}}});
  for (const int substeps : substeps_of_contacts)
    for (const auto& [hertz, damping] : {std::pair{eighth * substeps, 10.0},
                                         {eighth * substeps, 2.0},
                                         {eighth * substeps / 1.5, 40.0},
                                         {eighth * substeps / 2, 1e6}})
      all.contacts.push_back(
          {.row = Row::tuned,
           .knobs = {{"substeps", substeps}, {"contact hertz", hertz}, {"contact damping", damping}}});
  return all;
}

}  // namespace byhand::engines
