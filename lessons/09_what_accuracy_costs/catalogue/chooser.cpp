#include "lessons/09_what_accuracy_costs/catalogue/chooser.hpp"

#include <algorithm>
#include <numbers>

namespace byhand {
namespace {

/// The runs of one configuration at one knob, one for each tuning: the one with the least error. Runs end early
/// once they are over `limit` and over the best of those before.
Point best_at(const Problem& problem, const Configuration& configuration, int knob, Error error, double limit) {
  Point best;
  for (const double tuning : configuration.tunings) {
    Watch watch{error == Error::algebraic, error, limit};
    if (best.has(error)) watch.limit = std::max(limit, best[error]);
    const Point point = measure(problem, configuration, knob, tuning, watch);
    if (!best.configuration || (point.has(error) && !(best.has(error) && best[error] <= point[error])))
      best = point;
  }
  return best;
}

void time(const Problem& problem, Cost cost, Point& point) {
  if (cost == Cost::wall_time && point.outcome == Outcome::finished)
    point.nanoseconds = nanoseconds_a_frame(problem, point.configuration->setting(point.knob, point.tuning));
}

/// Halves the way between a knob that is too small and one that is not, down to an eighth of it; `fits` runs.
template <class Fits>
void bisect(int small, int large, Fits&& fits) {
  while (large - small > std::max(1, large / 8)) {
    const int middle = small + (large - small) / 2;
    (fits(middle) ? large : small) = middle;
  }
}

struct Found {
  bool reached = false;
  Point point;  // the cheapest that reaches it, or what came nearest
};

/// Whether an error has stopped to fall while the knob was doubled.
class Stall {
 public:
  bool now(double error) {
    if (!std::isfinite(error)) return false;
    waited_ = error < enough_ ? 0 : waited_ + 1;
    if (waited_ == 0) enough_ = 2.0 / 3 * error;
    return waited_ == 3;
  }

 private:
  double enough_ = INFINITY;
  int waited_ = 0;
};

/// The least knob at which a configuration has an error of at most `accuracy`, from `first` on.
Found reach(const Problem& problem, const Configuration& configuration, Error error, double accuracy, int first,
            double most_row_solves) {
  Found found;
  const auto run = [&](int knob) {
    const double limit = found.point.has(error) ? std::max(accuracy, found.point[error]) : INFINITY;
    const Point point = best_at(problem, configuration, knob, error, limit);
    const bool reached = point.has(error) && point[error] <= accuracy;
    const bool nearer = point.has(error) && !(found.point.has(error) && found.point[error] <= point[error]);
    if (!found.point.configuration || reached || (!found.reached && nearer)) found.point = point;
    found.reached = found.reached || reached;
    return point;
  };
  int before = first - 1;
  Stall stall;
  for (const int knob : configuration.values) {
    if (knob < first) continue;
    const Point point = run(knob);
    if (found.reached) {
      bisect(before, knob, [&](int between) {
        const Point finer = run(between);
        return finer.has(error) && finer[error] <= accuracy;
      });
      break;
    }
    if (point.outcome == Outcome::refused || point.row_solves > most_row_solves || stall.now(point[error])) break;
    before = knob;
  }
  return found;
}

/// The least error of a configuration at a cost of at most `budget`.
Found afford(const Problem& problem, const Configuration& configuration, const Wish& wish) {
  Found found;
  int before = configuration.values.front() - 1;
  const auto too_dear = [&](int knob) {
    const double limit = found.point.has(wish.error) ? found.point[wish.error] : INFINITY;
    Point point = best_at(problem, configuration, knob, wish.error, limit);
    time(problem, wish.cost, point);
    const bool dear = cost_of(point, wish.cost) > wish.budget;
    if (!found.point.configuration) found.point = point;
    if (dear || !point.has(wish.error)) return dear;
    if (!found.reached || point[wish.error] < found.point[wish.error]) found.point = point;
    found.reached = true;
    return false;
  };
  Stall stall;
  for (const int knob : configuration.values) {
    if (too_dear(knob)) {
      if (knob > configuration.values.front()) bisect(before, knob, too_dear);
      break;
    }
    if (found.point.outcome == Outcome::refused || stall.now(found.point[wish.error])) break;
    before = knob;
  }
  return found;
}

void require_valid(const Problem& problem, const Wish& wish) {
  require(std::isnan(wish.accuracy) != std::isnan(wish.budget), "wish", "both or neither",
          "either an accuracy or a budget");
  if (std::isnan(wish.budget))
    require_positive("accuracy", wish.accuracy, unit_of(wish.error));
  else
    require_positive("budget", wish.budget, wish.cost == Cost::wall_time ? "ns" : "");
  const NamedScene& scene = problem.scene();
  const bool has =
      (wish.error != Error::energy || scene.keeps_energy) && (wish.error != Error::momentum || scene.keeps_spin);
  require(has, "error", name_of(wish.error),
          "one that can be measured here: a " + scene.title + " does not keep it");
}

}  // namespace

Choice choose(const Problem& problem, const Wish& wish, const std::vector<Configuration>& among,
              const Search& search) {
  require_valid(problem, wish);
  const bool accurate = std::isnan(wish.budget);
  std::vector<Found> found;
  double cheapest = INFINITY;  // [row-solves]
  for (const Configuration& configuration : among) {
    if (configuration.defaults) continue;  // it is among the tunings of another
    search.told(configuration.name);
    found.push_back(accurate ? reach(problem, configuration, wish.error, wish.accuracy,
                                     configuration.values.front(), search.give_up * cheapest)
                             : afford(problem, configuration, wish));
    if (accurate && found.back().reached) {
      cheapest = std::min(cheapest, found.back().point.row_solves);
      time(problem, wish.cost, found.back().point);
    }
  }

  const auto better = [&](const Found& a, const Found& b) {
    if (a.reached != b.reached) return a.reached;
    if (a.point.has(wish.error) != b.point.has(wish.error)) return a.point.has(wish.error);
    return accurate && a.reached ? cost_of(a.point, wish.cost) < cost_of(b.point, wish.cost)
                                 : a.point[wish.error] < b.point[wish.error];
  };
  std::stable_sort(found.begin(), found.end(), better);

  Choice choice;
  choice.reached = found.front().reached;
  choice.best = found.front().point;
  for (std::size_t i = 1; i < found.size(); ++i)
    (found[i].point.outcome == Outcome::finished ? choice.runners_up : choice.passed).push_back(found[i].point);
  if (!choice.best.has(wish.error)) return choice;

  if (accurate && choice.reached) {
    for (const Found& one : found) {
      if (!one.reached || (choice.finer && one.point.row_solves > search.give_up * choice.finer->row_solves))
        continue;
      search.told(one.point.configuration->name + ", ten times finer");
      Found finer = reach(problem, *one.point.configuration, wish.error, wish.accuracy / 10, one.point.knob,
                          choice.finer ? choice.finer->row_solves : INFINITY);
      if (!finer.reached) continue;
      time(problem, wish.cost, finer.point);
      if (!choice.finer || cost_of(finer.point, wish.cost) < cost_of(*choice.finer, wish.cost))
        choice.finer = finer.point;
    }
  }
  if (choice.reached)
    choice.margin =
        margin(problem, choice.best, wish.error, accurate ? wish.accuracy : 2 * choice.best[wish.error]);
  return choice;
}

double margin(const Problem& problem, const Point& point, Error error, double limit) {
  const NamedScene& scene = problem.scene();
  const auto parameter = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                      [&](const SceneParameter& one) { return one.name == scene.stress; });
  const double value = problem[scene.stress];
  const auto holds = [&](double factor) {
    if (factor == 1) return true;
    // Times its largest factor the value may be above its upper end by rounding.
    const Point again =
        measure(problem.with(scene.stress, std::min(factor * value, parameter->high)), *point.configuration,
                point.knob, point.tuning, {error == Error::algebraic, error, limit});
    return again.has(error) && again[error] <= limit;
  };
  if (!(value > 0)) return NAN;
  const double most = parameter->high / value;
  double low = 1, high = 1;
  while (
      holds(high)) {  // in short strides: where steps are too long for a stiff scene, good bands follow bad ones
    low = high;
    if (high >= most) return INFINITY;
    high = std::min(std::numbers::sqrt2 * high, most);
  }
  while (high > 1.05 * low) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return high;
}

}  // namespace byhand
