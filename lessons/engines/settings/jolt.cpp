#include "lessons/engines/settings.hpp"

#include <algorithm>
#include <set>

// Jolt. Knobs of its PhysicsSettings: velocity iterations (10); position iterations (2), tried as a fifth of
// those, as shipped, and as four fifths; slop [m] (0.02), the overlap that contacts may keep.
namespace byhand::engines {

Settings jolt_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"velocity iterations", 20}, {"position iterations", 4}},
      .source = "its author, github.com/jrouwe/JoltPhysics/issues/1390: more steps of both kinds"};
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  const auto tried = [](const Shares& shares, int position, std::vector<std::pair<std::string, double>> knobs) {
    knobs.emplace_back("velocity iterations", shares.iterations);
    knobs.emplace_back("position iterations", position);
    return Setting{.row = Row::tuned, .knobs = Knobs(std::move(knobs)), .steps = shares.steps};
  };
  const auto positions = [](const Shares& shares) {
    return std::set{std::max(1, shares.iterations / 5), std::max(1, 4 * shares.iterations / 5)};
  };
  for (const Shares& shares : shares_of_joints())
    for (const int position : positions(shares)) all.joints.push_back(tried(shares, position, {}));
  for (const Shares& shares : shares_of_contacts())
    for (const int position : positions(shares))
      all.contacts.push_back(tried(shares, position, {{"slop", 0.001}}));
  return all;
}

}  // namespace byhand::engines
