#include "lessons/engines/settings.hpp"

// Box2D 2.4. Knobs: velocity iterations and position iterations, arguments of b2World::Step without a default;
// shipped is what its first example, HelloWorld, passes. Slop and Baumgarte are constants of its source.
namespace byhand::engines {

Settings box2d_2_settings() {
  const Setting advised{
      .row = Row::advised,
      .knobs = {{"velocity iterations", 8}, {"position iterations", 3}},
      .source = "manual of 2.4, Hello Box2D, Simulating the World: 8 for velocity and 3 for position"};
  std::vector<Setting> tried;
  for (const int steps : {1, 2, 4, 8, 16})
    for (const int iterations : {8, 32, 128})
      tried.push_back({.row = Row::tuned,
                       .knobs = {{"velocity iterations", iterations}, {"position iterations", 3 * iterations / 8}},
                       .steps = steps});
  Settings all{.joints = {{}, advised}, .contacts = {{}, advised}};
  for (auto* list : {&all.joints, &all.contacts}) list->insert(list->end(), tried.begin(), tried.end());
  return all;
}

}  // namespace byhand::engines
