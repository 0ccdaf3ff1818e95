#include "lessons/engines/engine.hpp"

#include "lessons/engines/adapters.hpp"

namespace byhand::engines {

const std::vector<Engine>& all_engines() {
  static const std::vector<Engine> all = [] {
    std::vector<Engine> found;
    for (const auto add : std::initializer_list<void (*)(std::vector<Engine>&)>{BYHAND_ENGINE_ADAPTERS})
      add(found);
    return found;
  }();
  return all;
}

const std::vector<std::string>& missing() {
  static const std::vector<std::string> names = {BYHAND_MISSING_ENGINES};
  return names;
}

}  // namespace byhand::engines
