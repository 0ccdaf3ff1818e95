#include "lessons/catalogue/verification.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace byhand {

std::string further_in_words(const Verification& verification) {
  if (verification.further == 0) return {};
  return " From " + std::to_string(verification.further) +
         " further starts, whose true motions take too long to find, it kept all that can be judged without them.";
}

void one_after_another(int count, const std::function<void(int)>& work) {
  for (int i = 0; i < count; ++i) work(i);
}

Verification verify(std::span<const Problem> starts, const Point& point, const Wish& wish,
                    const SideBySide& side_by_side, bool until_one_fails) {
  Verification result{.seconds = starts[0].scene().duration};
  const int all = static_cast<int>(starts.size());
  // First a few, because most that fail do so soon.
  int place = 0;
  for (int batch = until_one_fails ? 6 : all; place < all; batch *= 2) {
    const auto some = starts.subspan(place, std::min(batch, all - place));
    std::vector<Point> points(some.size());
    side_by_side(static_cast<int>(some.size()), [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      points[at] = whole_run(some[at], *point.family, point.knobs, wish);
    });
    for (const Point& one : points) {
      const int now = place++;
      if (!well_known(one.uncertainty, wish.limits)) {
        result.unknown.push_back(now);
        continue;
      }
      ++result.starts;
      result.good += one.outcome == Outcome::good;
      const double over = excess(one, wish.limits);
      result.within += over <= 1;
      if (over > result.excess) result.excess = over, result.worst = now;
      if (one.outcome != Outcome::good && result.first_failure.empty()) result.first_failure = one.reason;
    }
    if (until_one_fails && !result.kept()) break;
  }
  return result;
}

std::vector<Problem> variations(const Problem& problem, std::span<const int> numbers, int seed) {
  std::vector<Problem> starts;
  for (const int number : numbers) starts.push_back(problem.variation(number, seed));
  return starts;
}

std::vector<int> first_numbers(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

double margin(const Problem& problem, const Point& point, const std::map<Error, double>& limits, Spent* spent,
              double most_work, const SideBySide& side_by_side) {
  const NamedScene& scene = problem.scene();
  const auto parameter = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                      [&](const SceneParameter& one) { return one.name == scene.stress; });
  const double value = problem[scene.stress];
  if (!(value > 0)) return NAN;
  Watch watch{.reference = asks_for_reference(limits)};
  for (const auto& [error, limit] : limits) watch.limit[static_cast<std::size_t>(error)] = limit;
  double work = 0;
  bool known = true;  // the true motion, as far as it was asked for
  /// How many of these factors hold until one does not, all of which are run.
  const auto hold = [&](std::span<const double> factors) {
    std::vector<Point> runs(factors.size());
    side_by_side(static_cast<int>(factors.size()), [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      // Times its largest factor the value may be above its upper end by rounding.
      runs[at] = measure(problem.with(scene.stress, std::min(factors[at] * value, parameter->high)), *point.family,
                         point.knobs, watch);
    });
    for (const Point& run : runs) {
      const Spent one{1, work_of(run) + work_of_truth(problem, limits)};
      work += one.work;
      if (spent) *spent += one;
    }
    std::size_t count = 0;
    while (count < runs.size() && (known = well_known(runs[count].uncertainty, limits)) &&
           excess(runs[count], limits) <= 1)
      ++count;
    return count;
  };
  // In short strides: where steps are too long for a stiff scene, or a bounce falls into another step, good bands
  // follow bad ones.
  constexpr double near = 2, short_stride = 1.02, long_stride = 1.2;
  constexpr std::size_t batch = 4;
  const double most = std::min(1000.0, parameter->high / value);
  std::vector<double> strides;
  for (double high = 1; high < most;)
    strides.push_back(high = std::min((high < near ? short_stride : long_stride) * high, most));
  std::size_t held = 0;
  for (std::size_t tried = 0; held == tried && known; tried = std::min(tried + batch, strides.size())) {
    if (held == strides.size()) return INFINITY;
    if (work > most_work) return NAN;
    held += hold(std::span(strides).subspan(tried, std::min(batch, strides.size() - tried)));
  }
  if (!known) return NAN;
  double low = held > 0 ? strides[held - 1] : 1, high = strides[held];
  while (high > 1.05 * low) {
    if (work > most_work) return NAN;
    const double middle = std::sqrt(low * high);
    (hold(std::array{middle}) == 1 ? low : high) = middle;
    if (!known) return NAN;
  }
  return high;
}

}  // namespace byhand
