// Lesson::run for the programs settings_01_jacobian …: the main of a lesson ends in it, and here it turns every
// knob of the lesson instead of telling it. The terminal's own stays in its library.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/lessons/settings/audit.hpp"
#include "tests/lessons/settings/once_false.hpp"

namespace byhand::tests {
namespace {

/// Reads --step=N, --random=N, --seed=N, --seconds=N, --quick.
Extent extent(int argc, const char* const* argv) {
  Extent extent{.pictures = true};
  for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc)) {
    const std::string value = word.substr(std::min(word.find('=') + 1, word.size()));
    if (word == "--quick")
      extent.pairs = extent.all_steps = extent.pictures = false;
    else if (word.starts_with("--step="))
      extent.step = value;
    else if (word.starts_with("--random="))
      extent.random = std::stoi(value);
    else if (word.starts_with("--seed="))
      extent.seed = static_cast<unsigned>(std::stoul(value));
    else if (word.starts_with("--seconds="))
      extent.seconds = std::stod(value);
    else
      throw std::invalid_argument(word + " is none of --step=N, --random=N, --seed=N, --seconds=N, --quick");
  }
  return extent;
}

}  // namespace
}  // namespace byhand::tests

namespace byhand::course {

int Lesson::run(int argc, const char* const* argv) {
  tests::Extent extent = tests::extent(argc, argv);
  // A coarse map is as true as a fine one, and takes a hundredth of the time.
  if (is_parameter("resolution")) extent.base = {{"resolution", "4"}};
  // Of this chapter the lesson itself says that it takes minutes.
  if (is_parameter("appendix")) extent.beyond = {{"appendix", "millimetre"}};
  // Lessons 9 and 10 are not yet held to these.
  extent.frames = extent.judgements = number() <= 8;
  extent.also = tests::once_false(number());
  const tests::Audit audit(*this, extent);
  for (const auto& [step, command, finding, settings] : audit.failures())
    fmt::print("{} step {}: {}, at {} such as\n  {}\n  {}\n\n", about_.slug, step, finding.rule,
               several(settings, "setting"), command, finding.words);
  for (const std::string& line : audit.left_out()) fmt::print("{} {}\n", about_.slug, line);
  // A reader learns from a few knobs; lessons 9 and 10 are tables to look things up in.
  constexpr std::size_t most_knobs = 6;
  const bool too_many = number() <= 8 && parameters_.size() > most_knobs;
  if (too_many) fmt::print("{} has {} parameters, more than {}\n", about_.slug, parameters_.size(), most_knobs);
  fmt::print("{}: {} in {}, seed {}, {}\n", about_.slug,
             several(static_cast<long>(audit.failures().size()), "failure"), several(audit.runs(), "run"),
             extent.seed, audit.time_taken());
  return audit.failures().empty() && !too_many ? 0 : 1;
}

}  // namespace byhand::course
