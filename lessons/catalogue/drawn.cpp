#include "lessons/catalogue/drawn.hpp"

#include <cmath>

#include "lessons/catalogue/cheapest.hpp"

namespace byhand {

double Draws::between(double low, double high) {
  return low + (high - low) * 0x1p-53 * static_cast<double>(bits_() >> 11);
}

Knobs Draws::near(const Family& family, const Knobs& from) {
  Knobs knobs = from;
  const auto whether = [&](double chance) { return between(0, 1) < chance; };
  const auto scaled = [&](int number) { return static_cast<int>(std::lround(number * std::exp(between(-1, 1)))); };
  if (whether(0.3)) knobs.substeps = scaled(knobs.substeps);
  if (whether(0.3)) knobs.passes = scaled(knobs.passes);
  if (whether(0.7)) knobs.strength *= std::exp(between(-1.5, 1.5));
  if (whether(0.7)) knobs.relaxation += between(-0.3, 0.3);
  if (whether(0.1)) knobs = with_cure(knobs, family.cures[below(family.cures.size())]);
  return knobs;
}

Knobs Draws::any(const Problem& problem, const Family& family, int most_substeps) {
  const Cure cure = family.cures[below(family.cures.size())];
  Knobs knobs = first_knobs(problem, family, cure, static_cast<int>(std::exp2(between(0, 4))));
  knobs.substeps = static_cast<int>(std::exp(between(0, std::log(most_substeps))));
  knobs.strength *= std::exp(between(-2.3, 2.3));
  knobs.relaxation = between(family.least_relaxation, family.most_relaxation);
  return knobs;
}

std::pair<const Family*, Knobs> Draws::next(const Problem& problem, std::span<const Point> from,
                                            std::span<const Family* const> methods) {
  const Point& one = from[below(from.size())];
  const bool beside = ++drawn_ % 2 == 0;
  const Family* family = beside ? one.family : methods[below(methods.size())];
  const Knobs knobs =
      beside ? near(*family, one.knobs) : any(problem, *family, std::max(16, 4 * one.knobs.substeps));
  return {family, within_laws(problem, *family, knobs)};
}

Candidate cheapest_drawn(Draws& draws, std::span<const Problem> starts, const Wish& wish, std::vector<Point> from,
                         double bound, std::span<const Family* const> methods, int count, double most,
                         Spent& spent, const SideBySide& side_by_side) {
  constexpr int batch = 64;  // so many that no core waits long for the dearest of them
  constexpr double gain = 0.97;
  Candidate best;
  double work = 0;
  for (int done = 0; done < count && work < most; done += batch) {
    std::vector<Candidate> found(batch);
    std::vector<Spent> each(batch);
    for (Candidate& one : found)
      std::tie(one.point.family, one.point.knobs) = draws.next(starts[0], from, methods);
    side_by_side(batch, [&](int i) {
      Candidate& one = found[static_cast<std::size_t>(i)];
      const Family& family = *one.point.family;
      const Knobs knobs = one.point.knobs;
      one.excess = 0;
      for (const Problem& start : starts) {
        const bool own = &start == starts.data();
        const Point point =
            measure(start, family, knobs,
                    watch_of(start, wish, own ? std::min(gain * bound, budget_of(wish, family)) : INFINITY));
        each[static_cast<std::size_t>(i)] += {1, work_of(point)};
        one.excess = std::max(one.excess, excess(point, wish.limits));
        if (own) one.point = point;
        if (one.excess > 1) return;
      }
      one.reached = true;
    });
    for (const Spent& one : each) spent += one, work += one.work;
    for (const Candidate& one : found)
      if (one.reached && one.point.cost < gain * bound)
        best = one, bound = one.point.cost, from.push_back(one.point);
  }
  return best;
}

}  // namespace byhand
