#include "lessons/engines/settings.hpp"

#include <algorithm>

// Box2D 2.4. Knobs: velocity iterations and position iterations, arguments of b2World::Step without a default;
// shipped is what its first example, HelloWorld, passes. Slop and Baumgarte are constants of its source.
namespace byhand::engines {

Settings box2d_2_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"velocity iterations", 8}, {"position iterations", 3}},
      .source = "manual of 2.4, Hello Box2D, Simulating the World: 8 for velocity and 3 for position"};
  const auto tried = [](const Shares& shares) -> Setting {
    return {.row = Row::tuned,
            .knobs = {{"velocity iterations", shares.iterations},
                      {"position iterations", std::max(1, 3 * shares.iterations / 8)}},
            .steps = shares.steps};
  };
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (const Shares& shares : shares_of_joints()) all.joints.push_back(tried(shares));
  for (const Shares& shares : shares_of_contacts()) all.contacts.push_back(tried(shares));
  return all;
}

}  // namespace byhand::engines
