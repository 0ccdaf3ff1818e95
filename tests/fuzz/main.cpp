#include <charconv>
#include <iostream>
#include <optional>
#include <random>

#include "tests/fuzz/shrink.hpp"

// Random scenes, and whether each keeps every law.
namespace {

using namespace byhand;
using namespace byhand::fuzz;

constexpr const char* usage =
    "fuzz [--scenes=N] [--seed=N] [--scene=N] [--sweeps]\n\n"
    "Draws N scenes (5000), half of them in space, and tries on each every law of tests/fuzz/laws. A scene that\n"
    "breaks one is made smaller until nothing can be left out, and printed as code.\n\n"
    "  --seed=N    the first scene's number; by default any, and printed\n"
    "  --scene=N   this scene alone\n"
    "  --sweeps    with sweeps alone where the default would go on by Newton's method: it finds the heavy body "
    "that\n"
    "              sinks into a light one\n\n"
    "Exit status: 0 all laws held, 1 one was broken, 2 bad usage.\n";

/// Tries all laws on one scene, and prints one that is broken. Whether all held.
template <class M>
bool holds(std::uint64_t draw, const VelocityStepping& method) {
  const auto found = failure<M>(draw, method);
  if (found)
    std::cout << "scene " << draw << (M::linear == 2 ? " in the plane" : " in space")
              << " breaks a law: " << found->law << "\n  " << found->what << "\n\n"
              << code_of(found->scene) << '\n';
  return !found;
}

}  // namespace

int main(int count, char** arguments) {
  std::uint64_t scenes = 5000;
  std::uint64_t seed = std::random_device{}();
  VelocityStepping method;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    const auto number = [&](std::string_view name) -> std::optional<std::uint64_t> {
      if (!argument.starts_with(name)) return std::nullopt;
      const char *begin = argument.data() + name.size(), *end = argument.data() + argument.size();
      std::uint64_t value = 0;
      const auto [last, error] = std::from_chars(begin, end, value);
      return error == std::errc() && last == end ? std::optional(value) : std::nullopt;
    };
    if (const auto many = number("--scenes=")) {
      scenes = *many;
    } else if (const auto first = number("--seed=")) {
      seed = *first;
    } else if (const auto only = number("--scene=")) {
      seed = *only;
      scenes = 2;
    } else if (argument == "--sweeps") {
      method.solver = ConjugateSweeps{};
    } else {
      std::cerr << argument << " is no option.\n\n" << usage;
      return 2;
    }
  }
  std::cout << "seed " << seed << '\n';
  int failed = 0;
  std::uint64_t number = seed;
  for (; 2 * (number - seed) < scenes && failed < 10; ++number)
    failed += !holds<PlaneBody>(number, method) + !holds<SpaceBody>(number, method);
  std::cout << 2 * (number - seed) << " scenes, " << failed << " of them broke a law\n";
  return failed > 0;
}
