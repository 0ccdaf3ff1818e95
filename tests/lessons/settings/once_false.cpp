#include "tests/lessons/settings/once_false.hpp"

#include <fmt/format.h>

#include <string_view>

namespace byhand::tests {
namespace {

constexpr std::string_view commands[] = {
    "./lessons/run 5 --step 7 --set h=0.0365 --set boxes=7 --set sweeps=1",
    "./lessons/run 5 --step 7 --set beta=0.05",
    "./lessons/run 5 --step 7b --set beta=0.05",
    "./lessons/run 7 --step 4 --set h=0.0129 --set angle=72.8",
    "./lessons/run 8 --step 1 --set resolution=4 --set boxes=9 --set sweeps=2",
    "./lessons/run 9 --step 7 --set links=100 --set end_mass=10 --set drift=0.003",
};

}  // namespace

std::vector<Suggestion> once_false(int lesson) {
  std::vector<Suggestion> all;
  for (const std::string_view command : commands)
    if (command.starts_with(fmt::format("./lessons/run {} ", lesson)))
      all.push_back(suggestion(std::string(command)));
  return all;
}

}  // namespace byhand::tests
