#pragma once

#include <functional>
#include <random>
#include <span>

#include "lessons/catalogue/verification.hpp"

// Choices of all methods drawn at random: a search that turns one knob at a time misses what needs two.
namespace byhand {

/// The same numbers in every run and on every machine.
class Draws {
 public:
  /// Choices for a scene: every second ones near one of those in `from`, the rest of any of these methods.
  std::pair<const Family*, Knobs> next(const Problem& problem, std::span<const Point> from,
                                       std::span<const Family* const> methods);

 private:
  /// Evenly between these.
  double between(double low, double high);
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(between(0, 1) * static_cast<double>(count));
  }
  Knobs near(const Family& family, const Knobs& from);
  Knobs any(const Problem& problem, const Family& family, int most_substeps);

  std::mt19937_64 bits_{1};
  int drawn_ = 0;
};

/// Of `count` draws, half of them near those in `from`, the cheapest that reaches the wish from all starts at less
/// than `bound` a frame; not reached where none does, or `most` instructions were spent before.
Candidate cheapest_drawn(Draws& draws, std::span<const Problem> starts, const Wish& wish, std::vector<Point> from,
                         double bound, std::span<const Family* const> methods, int count, double most,
                         Spent& spent, const SideBySide& side_by_side = one_after_another);

}  // namespace byhand
