#include "lessons/catalogue/chooser.hpp"

#include <algorithm>
#include <memory>
#include <numbers>

#include "lessons/catalogue/tuning.hpp"

namespace byhand {
namespace {

constexpr double worth = 1.5;  // times the cheapest: what costs more is not looked for

/// How long a run of the search is watched [s]: what stands only by chance is found out by the verification.
double screening(const Problem& problem) {
  const double rows = std::max(1, problem.start().degrees_of_freedom());
  return std::clamp(problem.scene().duration * 40 / rows, std::min(4.0, problem.scene().duration),
                    problem.scene().duration);
}

/// Whether what is known of the true motion is needed, which may take longer to find out than all runs.
bool asks_for_reference(const std::map<Error, double>& limits) {
  return std::any_of(limits.begin(), limits.end(), [](const auto& one) {
    return one.first == Error::trajectory || one.first == Error::reaction || one.first == Error::contact ||
           one.first == Error::algebraic;
  });
}

Watch watch_of(const Problem& problem, const Wish& wish, double bound) {
  Watch watch{.seconds = screening(problem), .reference = asks_for_reference(wish.limits), .most = bound};
  // Far beyond its limit a run has told enough.
  for (const auto& [error, limit] : wish.limits) {
    watch.limit[static_cast<std::size_t>(error)] = 1.5 * limit;
    watch.algebraic = watch.algebraic || error == Error::algebraic;
  }
  return watch;
}

/// What one variant of a method (its cure, its passes) can do.
class Variant {
 public:
  Variant(const Problem& problem, const Family& family, const Wish& wish, double bound)
      : problem_(problem), wish_(wish), runs_(problem, family, watch_of(problem, wish, bound)) {}

  /// The least substeps from the law's on with which some strength reaches the wish; then fewer passes.
  void search(Cure cure, int passes) {
    Knobs knobs = first_knobs(problem_, runs_.family(), cure, passes);
    if (const Point& first = tuned(knobs); first.outcome == Outcome::refused) return;
    int missed = 0, waited = 0;
    double before = INFINITY;
    while (!reaches(tuned(knobs))) {
      const Point& now = tuned(knobs);
      if (now.outcome == Outcome::too_slow || knobs.substeps >= 4096) return;
      if (now.outcome == Outcome::no_solution && runs_.family().name == "direct" && knobs.regularisation == 0) {
        knobs.regularisation = 1e-9;  // rows that repeat each other
        continue;
      }
      waited = rank(now) < 0.8 * before ? 0 : waited + 1;
      before = std::min(before, rank(now));
      if (waited == 4) return;  // it no longer gains
      missed = knobs.substeps;
      knobs = now.knobs;
      knobs.substeps *= 2;
    }
    for (int enough = knobs.substeps; enough - missed > std::max(1, enough / 16);) {
      knobs.substeps = missed + (enough - missed) / 2;
      (reaches(tuned(knobs)) ? enough : missed) = knobs.substeps;
    }
  }

  /// Steps of single knobs that make the best cheaper and still reach the wish.
  void descend() {
    for (bool gains = best_.reached; gains;) {
      gains = false;
      const Knobs from = best_.point.knobs;
      for (const double share : {0.5, 0.7, 0.85}) {
        for (int Knobs::*knob : {&Knobs::substeps, &Knobs::passes}) {
          Knobs next = from;
          next.*knob = std::max(1, std::min(next.*knob - 1, static_cast<int>(std::lround(share * (next.*knob)))));
          if (next == from) continue;
          // The other knob may make up for it.
          for (const double more : {1.0, 1.2, 1.5}) {
            Knobs traded = next;
            int Knobs::*other = knob == &Knobs::substeps ? &Knobs::passes : &Knobs::substeps;
            if (more > 1 && runs_.family().pass.empty()) continue;
            traded.*other = static_cast<int>(std::ceil(more * (traded.*other)));
            const double cost = best_.point.cost;
            tuned(traded);
            gains = gains || best_.point.cost < 0.99 * cost;
            if (gains) break;
          }
          if (gains) break;
        }
        if (gains) break;
      }
    }
  }

  const Candidate& best() const { return best_; }
  Spent spent() const { return {runs_.count(), runs_.work()}; }

 private:
  bool reaches(const Point& point) const { return excess(point, wish_.limits) <= 1; }

  /// A number that falls towards the wish also where a run ended early, beyond its limits or by a failure.
  double rank(const Point& point) const {
    const double over = excess(point, wish_.limits), late = runs_.seconds() / std::max(point.seconds, frame);
    return std::isfinite(over) ? over * late : 1e9 * late;
  }

  const Point& run(const Knobs& knobs) {
    const Point& point = runs_.at(knobs);
    const double over = excess(point, wish_.limits);
    const bool reached = over <= 1;
    if (reached) runs_.watch().most = std::min(runs_.watch().most, 1.02 * point.cost);
    if (best_.point.family == nullptr || (reached && !best_.reached) ||
        (reached && point.cost < best_.point.cost) || (!reached && !best_.reached && rank(point) < best_.excess))
      best_ = {reached, point, reached ? over : rank(point)};
    return point;
  }

  /// The best strength and relaxation at these substeps and passes, from those that are given; it ends with the
  /// first that reaches the wish.
  const Point& tuned(const Knobs& knobs) {
    const Knobs key{knobs.substeps, knobs.passes, knobs.cure, 0, 1, knobs.regularisation};
    if (const auto known = tuned_.find(key); known != tuned_.end()) return runs_.at(known->second);
    Knobs at = within_laws(problem_, runs_.family(), knobs);
    const Point* best = &run(at);
    for (double stride = 4; stride > 1.1 && !reaches(*best) && best->outcome != Outcome::refused;) {
      bool moved = false;
      for (const Knobs& next : tried(at, stride)) {
        const Point& point = run(next);
        if (rank(point) < 0.97 * rank(*best)) {
          best = &point, at = point.knobs, moved = true;
          break;
        }
      }
      if (!moved) stride = rank(*best) > 4 ? 1 : std::sqrt(stride);  // hopeless: not worth a finer search
    }
    tuned_[key] = best->knobs;
    return *best;
  }

  std::vector<Knobs> tried(const Knobs& knobs, double stride) const {
    std::vector<Knobs> all;
    const auto add = [&](auto&& change) {
      Knobs next = knobs;
      change(next);
      next = within_laws(problem_, runs_.family(), next);
      if (next != knobs) all.push_back(next);
    };
    add([&](Knobs& k) { k.strength *= stride; });
    add([&](Knobs& k) { k.strength /= stride; });
    const double step = std::sqrt(stride);
    add([&](Knobs& k) {
      k.relaxation = k.relaxation < 1 ? std::min(1.0, k.relaxation * step) : 2 - (2 - k.relaxation) / step;
    });
    add([&](Knobs& k) {
      k.relaxation = k.relaxation <= 1 ? k.relaxation / step : std::max(1.0, 2 - (2 - k.relaxation) * step);
    });
    return all;
  }

  const Problem& problem_;
  const Wish& wish_;
  Runs runs_;
  std::map<Knobs, Knobs> tuned_;
  Candidate best_;
};

void require_valid(const Problem& problem, const Wish& wish) {
  require(!wish.limits.empty() || std::isfinite(wish.budget), "wish", "empty", "an accuracy or a budget");
  if (std::isfinite(wish.budget)) require_positive("budget", wish.budget, "row-solves");
  for (const auto& [error, limit] : wish.limits) {
    require_positive("accuracy", limit, unit_of(error));
    require(has(problem.scene(), error), "error", name_of(error),
            "one that can be measured here: a " + problem.scene().title + " does not have it");
  }
}

/// The cheaper of two that reach a wish; without limits the more accurate.
bool preferred(const Candidate& a, const Candidate& b, const Wish& wish) {
  if (a.reached != b.reached) return a.reached;
  return a.reached && !wish.limits.empty() ? a.point.cost < b.point.cost : a.excess < b.excess;
}

/// The least drift within a budget.
Candidate most_accurate(const Problem& problem, const Family& family, const Wish& wish, Spent* spent) {
  Runs runs(problem, family, {.seconds = screening(problem), .reference = false, .most = wish.budget});
  explore(runs, std::array{Error::drift}, 80);
  *spent += {runs.count(), runs.work()};
  Candidate best;
  for (const Point& point : runs.points()) {
    const bool reached = point.has(Error::drift) && point.cost <= wish.budget;
    if (!best.point.family || (reached && (!best.reached || point[Error::drift] < best.point[Error::drift])))
      best = {reached, point, reached ? point[Error::drift] : INFINITY};
  }
  return best;
}

}  // namespace

double excess(const Point& point, const std::map<Error, double>& limits) {
  double most = point.outcome == Outcome::good ? 0 : INFINITY;
  for (const auto& [error, limit] : limits)
    most = std::max(most, point.has(error) ? point[error] / limit : INFINITY);
  return most;
}

Candidate cheapest(const Problem& problem, const Family& family, const Wish& wish, double bound, Spent* spent) {
  std::vector<std::unique_ptr<Variant>> variants;
  Variant* best = nullptr;
  for (const Cure cure : family.cures)
    for (const int passes : {1, 2, 4, 8, 16, 64}) {
      if (passes > (family.pass == "digit" ? 4 : family.pass.empty() ? 1 : 64)) break;
      const double most = best && best->best().reached ? best->best().point.cost : INFINITY;
      variants.push_back(std::make_unique<Variant>(problem, family, wish, std::min(bound, most)));
      Variant& variant = *variants.back();
      variant.search(cure, passes);
      if (!best || (variant.best().point.family && preferred(variant.best(), best->best(), wish))) best = &variant;
      if (variant.best().point.outcome == Outcome::refused) break;
    }
  best->descend();
  if (spent)
    for (const auto& variant : variants) *spent += variant->spent();
  return best->best();
}

Verification verify(const Problem& problem, const Point& point, const Wish& wish, int starts, const Search& search,
                    int seed) {
  std::vector<Point> points(static_cast<std::size_t>(starts));
  search.side_by_side(starts, [&](int i) {
    points[static_cast<std::size_t>(i)] = measure(problem.variation(i, seed), *point.family, point.knobs,
                                                  {.reference = asks_for_reference(wish.limits)});
  });
  Verification result{.starts = starts, .seconds = problem.scene().duration};
  if (!points.empty()) result.excess = excess(points.front(), wish.limits);
  for (const Point& one : points) {
    result.good += one.outcome == Outcome::good;
    result.within += excess(one, wish.limits) <= 1;
    if (one.outcome != Outcome::good && result.first_failure.empty()) result.first_failure = one.reason;
  }
  return result;
}

Choice choose(const Problem& problem, const Wish& wish, const Search& search) {
  require_valid(problem, wish);
  if (asks_for_reference(wish.limits)) problem.reference();  // before the threads, which would wait for it
  Choice choice;
  choice.limit = limit_of(problem);
  const auto& all = families();
  std::vector<Candidate> found(all.size());
  const auto by_preference = [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish); };
  std::vector<Spent> spent(all.size());
  const double rows = std::max(1, problem.start().degrees_of_freedom());
  double cheapest_yet = INFINITY;
  const auto look = [&](const std::vector<std::size_t>& which, double most) {
    const double bound = std::min({most, wish.budget, worth * cheapest_yet});
    search.side_by_side(static_cast<int>(which.size()), [&](int i) {
      const std::size_t at = which[static_cast<std::size_t>(i)];
      if (found[at].reached || found[at].point.outcome == Outcome::refused) return;
      search.told(all[at].name);
      found[at] = wish.limits.empty() ? most_accurate(problem, all[at], wish, &spent[at])
                                      : cheapest(problem, all[at], wish, bound, &spent[at]);
    });
    for (const std::size_t at : which)
      if (found[at].reached) cheapest_yet = std::min(cheapest_yet, found[at].point.cost);
  };
  // What is quick to search comes first: it bounds what the rest may cost. Dearer ways are tried where no cheaper
  // one does.
  std::vector<std::size_t> first, second, rest;
  for (std::size_t i = 0; i < all.size(); ++i)
    (all[i].exact && all[i].solves_rows      ? first
     : all[i].exact || all[i].name == "XPBD" ? second
                                             : rest)
        .push_back(i);
  // Those that solve exactly have few choices, so that their search goes on when that of all others has cost
  // enough.
  double level = wish.limits.empty() ? INFINITY : 20 * rows * choice.limit.substeps;
  for (;; level *= 2.5) {
    look(first, level), look(second, level);
    if (choice.spent.work <= search.enough) look(rest, level), choice.searched = std::min(level, wish.budget);
    choice.spent = {};
    for (const Spent& one : spent) choice.spent += one;
    if (std::isfinite(cheapest_yet) || level >= wish.budget || choice.spent.work > 3 * search.enough) break;
  }
  choice.searched_exactly = std::min(level, wish.budget);
  std::stable_sort(found.begin(), found.end(), by_preference);

  // Twenty initial conditions decide, over the whole time: what fails one, or errs too much after the search has
  // stopped watching, takes more substeps, or another method is tried.
  const int dear = std::max(problem.start().degrees_of_freedom() / 300,
                            asks_for_reference(wish.limits) ? choice.limit.substeps / 8 : 0);
  const int starts = std::max(std::min(4, search.starts), search.starts / std::max(1, dear));
  for (Candidate& candidate : found) {
    if (!candidate.reached) continue;
    for (int attempt = 0; attempt < 8; ++attempt) {
      choice.verified = verify(problem, candidate.point, wish, starts, search);
      choice.spent.runs += starts;
      if (!wish.limits.empty()) candidate.excess = choice.verified.excess;
      if (choice.verified.good == starts && choice.verified.excess <= 1) break;
      Knobs more = candidate.point.knobs;
      more.substeps = std::max(more.substeps + 1, more.substeps * 5 / 4);
      candidate.point =
          measure(problem, *candidate.point.family, more, {.reference = asks_for_reference(wish.limits)});
      candidate.excess =
          wish.limits.empty() ? candidate.point[Error::drift] : excess(candidate.point, wish.limits);
    }
    candidate.reached =
        choice.verified.good == starts && candidate.excess <= 1 && candidate.point.cost <= wish.budget;
    if (candidate.reached) {
      const bool still = std::none_of(found.begin(), found.end(), [&](const Candidate& other) {
        return other.reached && preferred(other, candidate, wish);
      });
      if (still) break;
    }
  }
  std::stable_sort(found.begin(), found.end(), by_preference);
  choice.best = found.front();
  choice.reached = choice.best.reached;
  if (!choice.reached && choice.best.point.outcome == Outcome::good) {  // so far it may have been watched in part
    choice.best.point = measure(problem, *choice.best.point.family, choice.best.point.knobs);
    choice.best.excess = excess(choice.best.point, wish.limits);
  }
  if (choice.reached) {
    choice.verified = verify(problem, choice.best.point, wish, starts, search);
    choice.best.point = measure(problem, *choice.best.point.family, choice.best.point.knobs);  // with all errors
  }
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i].point.outcome == Outcome::good && std::isfinite(found[i].excess))
      choice.runners_up.push_back(found[i]);
    else if (found[i].point.family && found[i].point.outcome != Outcome::too_slow)
      choice.passed.push_back(found[i].point);
  if (!choice.reached) return choice;

  if (const Knobs& best = choice.best.point.knobs; best.substeps > 1) {
    Knobs fewer = best;
    fewer.substeps = std::max(1, std::min(best.substeps - 1, best.substeps * 9 / 10));
    choice.coarser =
        measure(problem, *choice.best.point.family, fewer, {.reference = asks_for_reference(wish.limits)});
  }
  if (search.finer && !wish.limits.empty()) {
    Wish tenth = wish;
    for (auto& [error, limit] : tenth.limits) limit /= 10;
    tenth.budget = INFINITY;
    const Candidate finer =
        cheapest(problem, *choice.best.point.family, tenth, 100 * choice.best.point.cost, &choice.spent);
    if (finer.reached) choice.finer = finer.point;
  }
  auto limits = wish.limits;
  if (limits.empty()) limits[Error::drift] = 2 * choice.best.point[Error::drift];
  choice.margin = margin(problem, choice.best.point, limits);
  return choice;
}

double margin(const Problem& problem, const Point& point, const std::map<Error, double>& limits) {
  const NamedScene& scene = problem.scene();
  const auto parameter = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                      [&](const SceneParameter& one) { return one.name == scene.stress; });
  const double value = problem[scene.stress];
  Watch watch{.seconds = screening(problem), .reference = asks_for_reference(limits)};
  for (const auto& [error, limit] : limits) watch.limit[static_cast<std::size_t>(error)] = limit;
  const auto holds = [&](double factor) {
    if (factor == 1) return true;
    // Times its largest factor the value may be above its upper end by rounding.
    return excess(measure(problem.with(scene.stress, std::min(factor * value, parameter->high)), *point.family,
                          point.knobs, watch),
                  limits) <= 1;
  };
  if (!(value > 0)) return NAN;
  const double most = std::min(1000.0, parameter->high / value);
  double low = 1, high = 1;
  // In short strides: where steps are too long for a stiff scene, good bands follow bad ones.
  while (holds(high)) {
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
