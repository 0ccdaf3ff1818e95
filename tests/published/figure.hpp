#pragma once

#include <ctime>
#include <limits>
#include <string>
#include <vector>

// Figures that others published, beside ours and the exact values.
namespace byhand::published {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What someone found. Ours have a bound, the largest distance from the exact value that passes. A published time
/// has no value where only a plot shows one.
struct Entry {
  std::string who;
  double value;
  std::string how;        // method, time step, machine
  double seconds = none;  // processor time of the run [s]
  double bound = none;
};

/// A quantity with its unit, its exact value and where that comes from, and what each found.
struct Quantity {
  std::string name;
  double exact;
  std::string why;
  std::vector<Entry> entries;
};

struct Figure {
  std::string title, definition, source;
  std::vector<Quantity> quantities;
};

/// Prints the tables of a figure. Returns whether ours keep their bounds.
bool print(const Figure& figure);

/// The processor time that `run` takes [s].
template <class F>
double seconds(F&& run) {
  const std::clock_t begin = std::clock();
  run();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// Each in the file of its name.
Figure slope();
Figure pendulum();
Figure four_bars();
Figure squeezer();
Figure bricard();
Figure governor();
Figure rolling();
Figure balls();
Figure bouncing();
Figure cubes();

}  // namespace byhand::published
