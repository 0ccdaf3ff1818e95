#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

constexpr const char* usage =
    "test_published [FIGURE…]\n\n"
    "Prints these figures, or all: what others published, beside ours and the exact values.\n\n"
    "Exit status: 0 ours keep their bounds, 1 one does not, 2 bad usage.\n";

struct Named {
  std::string name;
  Figure (*figure)();
};
const std::vector<Named> figures = {{"slope", slope},       {"pendulum", pendulum}, {"four_bars", four_bars},
                                    {"squeezer", squeezer}, {"bricard", bricard},   {"governor", governor},
                                    {"rolling", rolling},   {"balls", balls},       {"bouncing", bouncing},
                                    {"cubes", cubes}};

/// The processor that our times were taken on.
std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

int run(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (std::ranges::find(figures, name, &Named::name) == figures.end()) {
      fmt::print(stderr, "{} is no figure.\n\n{}", name, usage);
      return 2;
    }
  bool kept = true;
  for (const Named& named : figures)
    if (names.empty() || std::ranges::count(names, named.name)) kept &= print(named.figure());
  fmt::print("Times are of the processor: ours {}, others as the table says.\n", processor());
  return kept ? 0 : 1;
}

}  // namespace
}  // namespace byhand::published

int main(int count, char** arguments) { return byhand::published::run({arguments + 1, arguments + count}); }
