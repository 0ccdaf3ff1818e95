#include "lessons/catalogue/cheapest.hpp"

#include <algorithm>
#include <memory>

namespace byhand {

Watch watch_of(const Problem& problem, const Wish& wish, double bound) {
  Watch watch{.seconds = screening(problem), .reference = asks_for_reference(wish.limits), .most = bound};
  // Far beyond its limit a run has told enough.
  for (const auto& [error, limit] : wish.limits) {
    watch.limit[static_cast<std::size_t>(error)] = 1.5 * limit;
    watch.algebraic = watch.algebraic || error == Error::algebraic;
  }
  return watch;
}

namespace {

/// From how many strengths and relaxations a search begins.
enum class Begins { from_few, from_many };

/// What one variant of a method (its cure, its passes) can do.
class Variant {
 public:
  /// `most` instructions end its search.
  Variant(std::span<const Problem> starts, const Family& family, const Wish& wish, double bound, double most,
          Begins begins, std::vector<Known>& known)
      : problem_(starts[0]),
        wish_(wish),
        runs_(problem_, family, watch_of(problem_, wish, bound), known.data()),
        most_(most),
        begins_(begins) {
    for (std::size_t i = starts.size(); --i > 0;)
      others_.emplace_back(starts[i], family, watch_of(starts[i], wish, INFINITY), &known[i]);
  }

  /// The least substeps from the law's on with which some strength reaches the wish, or the most that may be paid
  /// for where fewer come near it.
  void search(Cure cure, int passes) {
    Knobs knobs = first_knobs(problem_, runs_.family(), cure, passes);
    if (const Point& first = tuned(knobs); first.outcome == Outcome::refused) return;
    constexpr double near = 4;  // times the limit
    int missed = 0, waited = 0;
    double before = INFINITY;
    while (!reaches(tuned(knobs))) {
      const Point& now = tuned(knobs);
      cut_ = now.outcome == Outcome::too_slow || ends();
      if (now.outcome == Outcome::too_slow && before < near) break;
      if (cut_ || knobs.substeps >= 4096) return;
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
    for (int enough = knobs.substeps; enough - missed > std::max(1, enough / 16) && !ends();) {
      knobs.substeps = missed + (enough - missed) / 2;
      const Point& now = tuned(knobs);
      (reaches(now) || now.outcome == Outcome::too_slow ? enough : missed) = knobs.substeps;
    }
  }

  /// Steps of single knobs that make the best cheaper and still reach the wish.
  void descend() {
    for (bool gains = best_.reached; gains && !ends();) {
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
  Spent spent() const {
    Spent all{runs_.made(), runs_.work(), cut_};
    for (const Runs& other : others_) all += {other.made(), other.work()};
    return all;
  }

 private:
  bool ends() const { return spent().work > most_; }

  /// The largest error over its limit. What reaches the wish is run from the other starts, too, until one fails:
  /// among many choices some reach it from one start by luck.
  double over(const Point& point) {
    const auto [known, is_new] = over_.try_emplace(point.knobs, excess(point, wish_.limits));
    double& most = known->second;
    for (std::size_t i = 0; is_new && most <= 1 && i < others_.size(); ++i) {
      most = std::max(most, excess(others_[i].at(point.knobs), wish_.limits));
      if (most > 1)
        std::rotate(others_.begin(), others_.begin() + i, others_.begin() + i + 1);  // the next's first
    }
    return most;
  }
  bool reaches(const Point& point) { return over(point) <= 1; }

  /// A number that falls towards the wish also where a run ended early, beyond its limits or by a failure.
  double rank(const Point& point) {
    const double most = over(point), late = runs_.seconds() / std::max(point.seconds, frame);
    return std::isfinite(most) ? most * late : 1e9 * late;
  }

  const Point& run(const Knobs& knobs) {
    // What is left has to pay for all of the run.
    runs_.watch().most = std::min(runs_.watch().most, (most_ - spent().work) * frame / runs_.seconds());
    const Point& point = runs_.at(knobs);
    const bool reached = reaches(point);
    if (reached) runs_.watch().most = std::min(runs_.watch().most, 1.02 * point.cost);
    if (best_.point.family == nullptr || (reached && !best_.reached) ||
        (reached && point.cost < best_.point.cost) || (!reached && !best_.reached && rank(point) < best_.excess))
      best_ = {reached, point, reached ? over(point) : rank(point)};
    return point;
  }

  /// The best strength and relaxation at these substeps and passes, from those that are given; it ends with the
  /// first that reaches the wish.
  const Point& tuned(const Knobs& knobs) {
    const Knobs key{knobs.substeps, knobs.passes, knobs.cure, 0, 1, knobs.regularisation};
    if (const auto known = tuned_.find(key); known != tuned_.end()) return runs_.at(known->second);
    Knobs at = within_laws(problem_, runs_.family(), knobs);
    const Point* best = &run(at);
    for (const Knobs& other : first_choices(at)) {
      if (reaches(*best) || best->outcome == Outcome::refused || ends()) break;
      const Point& point = run(within_laws(problem_, runs_.family(), other));
      if (rank(point) < rank(*best)) best = &point;
    }
    at = best->knobs;
    for (double stride = 4; stride > 1.1 && !reaches(*best) && best->outcome != Outcome::refused && !ends();) {
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

  /// From which a search begins besides: what coarser steps have found is far from what finer ones need.
  std::vector<Knobs> first_choices(const Knobs& from) const {
    const bool few = begins_ == Begins::from_few;
    std::vector<double> relaxations, strengths{from.strength};
    if (runs_.family().most_relaxation > 1)
      relaxations = few ? std::vector{1.0, 1.7} : std::vector{1.0, 1.5, 1.7, 1.9};
    else if (runs_.family().least_relaxation < 1)
      relaxations = few ? std::vector{0.5} : std::vector{0.35, 0.5, 0.7, 1.0};
    if (!few && from.strength > 0) strengths.insert(strengths.end(), {0.3 * from.strength, 5 * from.strength});
    std::vector<Knobs> all;
    for (const double strength : strengths)
      for (const double relaxation : relaxations) {
        all.push_back(from);
        all.back().strength = strength, all.back().relaxation = relaxation;
      }
    return all;
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
  std::vector<Runs> others_;  // from the other starts
  double most_;
  Begins begins_;
  bool cut_ = false;
  std::map<Knobs, double> over_;
  std::map<Knobs, Knobs> tuned_;
  Candidate best_;
};

/// Passes from which a search begins. More digits come first: what they reach bounds the cost of fewer.
std::vector<int> passes_of(const Family& family, Begins begins) {
  if (family.pass.empty()) return {1};
  if (family.pass == "digit") return {6, 4, 2, 1};
  return begins == Begins::from_few ? std::vector{1, 2, 4, 8, 16, 64} : std::vector{1, 2, 3, 4, 6, 8};
}

}  // namespace

Candidate cheapest(std::span<const Problem> starts, const Family& family, const Wish& wish, double bound,
                   Spent* spent, double most_work, std::vector<Known>* known) {
  std::vector<Known> own;
  if (!known) known = &own;
  known->resize(starts.size());
  std::vector<std::unique_ptr<Variant>> variants;
  Variant* best = nullptr;
  double work = 0;
  const auto search = [&](Begins begins, double until) {
    for (const Cure cure : family.cures)
      for (const int passes : passes_of(family, begins)) {
        if (best && work > until) return;
        const double most = best && best->best().reached ? best->best().point.cost : INFINITY;
        variants.push_back(
            std::make_unique<Variant>(starts, family, wish, std::min(bound, most), until - work, begins, *known));
        Variant& variant = *variants.back();
        variant.search(cure, passes);
        work += variant.spent().work;
        if (!best || (variant.best().point.family && preferred(variant.best(), best->best(), wish)))
          best = &variant;
        if (variant.best().point.outcome == Outcome::refused) break;
      }
  };
  search(Begins::from_few, most_work);
  // Where that was quick, few substeps may do with choices that are far from those.
  const bool has_choices = family.most_relaxation > 1 || family.least_relaxation < 1;
  if (has_choices && best->best().reached && work < 0.2 * most_work) search(Begins::from_many, 0.6 * most_work);
  best->descend();
  if (spent)
    for (const auto& variant : variants) *spent += variant->spent();
  return best->best();
}

}  // namespace byhand
