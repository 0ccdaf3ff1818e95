#include "lessons/engines/settings.hpp"

// Jolt. Knobs of its PhysicsSettings: velocity iterations (10); position iterations (2); slop [m] (0.02), the
// overlap that contacts may keep.
namespace byhand::engines {

Settings jolt_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"velocity iterations", 20}, {"position iterations", 4}},
      .source = "its author, github.com/jrouwe/JoltPhysics/issues/1390: more steps of both kinds"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (const int steps : {1, 2, 4, 8})
    for (const int velocity : {10, 40})
      for (const int position : {2, 8}) {
        const std::vector<std::pair<std::string, double>> knobs{{"velocity iterations", velocity},
                                                                {"position iterations", position}};
        all.joints.push_back({.row = Row::tuned, .knobs = Knobs(knobs), .steps = steps});
        auto with_slop = knobs;
        with_slop.emplace_back("slop", 0.001);
        all.contacts.push_back({.row = Row::tuned, .knobs = Knobs(with_slop), .steps = steps});
      }
  return all;
}

}  // namespace byhand::engines
