#include "solver/laws/record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace byhand::laws {

bool Record::note(double x) {
  numbers_.push_back(x);
  return std::abs(x) <= large_;
}

Outcome Record::outcome() const {
  if (!(std::abs(numbers_.back()) <= large_)) return Outcome::explodes;
  const std::size_t third = numbers_.size() / 3;
  const std::span last = std::span(numbers_).last(third),
                  before = std::span(numbers_).last(2 * third).first(third);
  const auto square = [](std::span<const double> x) {
    return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
  };
  const auto [low, high] = std::minmax_element(last.begin(), last.end());
  const bool gone = std::max(-*low, *high) <= small_;
  constexpr double for_certain = 1 - 1e-9;  // what is held off does not change but for rounding
  if (gone || square(last) < for_certain * square(before)) return Outcome::settles;
  return *low < 0 && *high > 0 ? Outcome::rings : Outcome::drifts;
}

}  // namespace byhand::laws
