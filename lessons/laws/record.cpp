#include "lessons/laws/record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace byhand::laws {
namespace {

constexpr std::size_t long_enough = 500;  // steps

}  // namespace

bool Record::note(double x) {
  numbers_.push_back(x);
  largest_ = std::max(largest_, std::abs(x));
  quiet_ = std::abs(x) <= 1e-4 * disturbance_ ? quiet_ + 1 : 0;
  return std::abs(x) <= large_ && quiet_ < long_enough;
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
  constexpr double for_certain = 1 - 1e-9;  // what is held off does not change but for rounding
  const bool gone = quiet_ >= std::min(third, long_enough);
  const bool dying = largest_ <= 1e4 * disturbance_ && square(last) < for_certain * square(before);
  if (gone || dying) return Outcome::settles;
  return *low < 0 && *high > 0 ? Outcome::rings : Outcome::drifts;
}

}  // namespace byhand::laws
