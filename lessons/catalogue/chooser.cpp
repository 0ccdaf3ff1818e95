#include "lessons/catalogue/chooser.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace byhand {
namespace {

constexpr int most_attempts = 12;  // to find a candidate's choices that keep the wish from all starts
constexpr double worth = 1.5;      // times the cheapest: what costs more is not looked for

/// How long a run of the search is watched [s]: what stands only by chance is found out by the verification.
double screening(const Problem& problem) {
  const double rows = std::max(1, problem.start().degrees_of_freedom());
  return std::clamp(problem.scene().duration * 40 / rows, std::min(4.0, problem.scene().duration),
                    problem.scene().duration);
}

/// Whether what is known of the true motion is needed, which may take longer to find out than all runs.
bool asks_for_reference(const std::map<Error, double>& limits) {
  return std::any_of(limits.begin(), limits.end(), [](const auto& one) {
    return needs_truth(one.first) || one.first == Error::contact || one.first == Error::algebraic;
  });
}

/// A run from beginning to end, with what the wish asks about.
Point whole_run(const Problem& problem, const Family& family, const Knobs& knobs, const Wish& wish,
                bool all_errors = false) {
  return measure(problem, family, knobs, {.reference = all_errors || asks_for_reference(wish.limits)});
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
  /// `most` instructions end its search.
  Variant(const Problem& problem, const Family& family, const Wish& wish, double bound, double most, Known* known)
      : problem_(problem),
        wish_(wish),
        runs_(problem, family, watch_of(problem, wish, bound), known),
        most_(most) {}

  /// The least substeps from the law's on with which some strength reaches the wish; then fewer passes.
  void search(Cure cure, int passes) {
    Knobs knobs = first_knobs(problem_, runs_.family(), cure, passes);
    if (const Point& first = tuned(knobs); first.outcome == Outcome::refused) return;
    int missed = 0, waited = 0;
    double before = INFINITY;
    while (!reaches(tuned(knobs))) {
      const Point& now = tuned(knobs);
      if (now.outcome == Outcome::too_slow || knobs.substeps >= 4096 || ends()) return;
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
      (reaches(tuned(knobs)) ? enough : missed) = knobs.substeps;
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
  Spent spent() const { return {runs_.made(), runs_.work()}; }

 private:
  bool reaches(const Point& point) const { return excess(point, wish_.limits) <= 1; }
  bool ends() const { return runs_.work() > most_; }

  /// A number that falls towards the wish also where a run ended early, beyond its limits or by a failure.
  double rank(const Point& point) const {
    const double over = excess(point, wish_.limits), late = runs_.seconds() / std::max(point.seconds, frame);
    return std::isfinite(over) ? over * late : 1e9 * late;
  }

  const Point& run(const Knobs& knobs) {
    // What is left has to pay for all of the run.
    runs_.watch().most = std::min(runs_.watch().most, (most_ - runs_.work()) * frame / runs_.seconds());
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
  double most_;
  std::map<Knobs, Knobs> tuned_;
  Candidate best_;
};

void require_valid(const Problem& problem, const Wish& wish) {
  require(!wish.limits.empty() || wish.budget, "wish", "empty", "an accuracy or a budget");
  if (wish.budget)
    for (const Family& family : families())
      if (const double budget = wish.budget(family); std::isfinite(budget))
        require_positive("budget", budget, "instructions");
  for (const auto& [error, limit] : wish.limits) {
    require_positive("accuracy", limit, unit_of(error));
    require(has(problem.scene(), error), "error", name_of(error),
            "one that can be measured here: a " + problem.scene().title + " does not have it");
  }
}

/// Instructions that the true motion from another start takes.
double work_of_truth(const Problem& problem, const Wish& wish) {
  const auto& work = problem.scene().reference_work;
  return work && asks_for_reference(wish.limits) ? work->load() : 0;
}

/// Counts the true motions of other starts, each of which is found once.
class Truths {
 public:
  Truths(const Problem& problem, const Wish& wish) : each_(work_of_truth(problem, wish)) {}

  /// Of the first `starts` of a seed, those that are new.
  double work(int seed, int starts) {
    int& known = known_[seed];
    const int more = std::max(0, starts - known);
    known += more;
    return more * each_;
  }

 private:
  double each_;
  std::map<int, int> known_;
};

/// From how many starts runs of that cost are verified.
int starts_of(const Problem& problem, const Wish& wish, double cost, const Search& search) {
  constexpr double for_truth = 5;  // times as much, as all verifications share them
  double work = std::max(cost * problem.scene().duration / frame, work_of_truth(problem, wish) / for_truth);
  if (asks_for_reference(wish.limits) && problem.scene().chaotic)
    work =
        std::max(work, search.verification / 160 * limit_of(problem).substeps);  // each has a reference of its own
  return std::clamp(static_cast<int>(search.verification / work), std::min(4, search.starts), search.starts);
}

double budget_of(const Wish& wish, const Family& family) { return wish.budget ? wish.budget(family) : INFINITY; }

/// The cheaper of two that reach a wish; without limits the more accurate.
bool preferred(const Candidate& a, const Candidate& b, const Wish& wish) {
  if (a.reached != b.reached) return a.reached;
  if (a.reached && (!wish.limits.empty() || a.excess == b.excess)) return a.point.cost < b.point.cost;
  return a.excess < b.excess;
}

/// The least drift within a budget.
Candidate most_accurate(const Problem& problem, const Family& family, const Wish& wish, Spent* spent) {
  Runs runs(problem, family, {.seconds = screening(problem), .reference = false, .most = budget_of(wish, family)});
  explore(runs, std::array{Error::drift}, 80);
  *spent += {runs.made(), runs.work()};
  Candidate best;
  for (const Point& point : runs.points()) {
    const bool reached = point.has(Error::drift) && point.cost <= budget_of(wish, family);
    // What is beyond rounding in none is the same in all, and the cheapest is the best.
    const Candidate now{reached, point, reached ? std::max(point[Error::drift], finest_drift) : INFINITY};
    if (!best.point.family || preferred(now, best, wish)) best = now;
  }
  return best;
}

/// What a candidate's next attempt has to keep before it is verified from fresh starts: those that it has missed.
struct Attempts {
  int left = most_attempts;
  std::vector<Problem> missed;
};

/// A candidate with so few more substeps that it keeps its own start and those it has missed; or, if that costs
/// more than `worth_a_search`, the same method tuned anew for the last of those, where it is cheaper.
Candidate strengthened(const Problem& problem, const Wish& wish, const Candidate& candidate,
                       const std::vector<Problem>& missed, double most_work, Spent& spent) {
  const Family& family = *candidate.point.family;
  const double until = spent.work + most_work, budget = budget_of(wish, family);
  Candidate more = candidate;
  more.reached = false;
  const auto kept = [&](const Problem& start) {
    more.point = whole_run(start, family, more.point.knobs, wish);
    spent += {1, work_of(more.point)};
    more.excess = wish.limits.empty() ? more.point[Error::drift] : excess(more.point, wish.limits);
    return more.point.outcome == Outcome::good && (wish.limits.empty() || more.excess <= 1) &&
           more.point.cost <= budget;
  };
  for (int parts = 1; parts <= 128 && !more.reached && more.point.cost <= budget && spent.work <= until;
       parts *= 2) {
    const int from = candidate.point.knobs.substeps;
    more.point.knobs.substeps = std::max(more.point.knobs.substeps + 1, from + from * parts / 16);
    // The hardest first.
    more.reached = std::all_of(missed.rbegin(), missed.rend(), kept) && kept(problem);
  }
  constexpr double worth_a_search = 1.15;  // times the candidate's cost
  if (wish.limits.empty() || (more.reached && more.point.cost <= worth_a_search * candidate.point.cost))
    return more;
  const double most = std::min({more.reached ? more.point.cost : INFINITY, 10 * candidate.point.cost, budget});
  const Candidate tuned = cheapest(missed.back(), family, wish, most, &spent, until - spent.work);
  return tuned.reached && tuned.point.cost > candidate.point.cost ? tuned : more;
}

/// A run from each of the first starts of a seed until one fails, and what that takes.
Verification counted(const Problem& problem, const Point& point, const Wish& wish, int starts,
                     const Search& search, int seed, Truths& truths, Spent& spent) {
  const Verification verification = verify(problem, point, wish, starts, search, seed, true);
  spent += {verification.starts, verification.starts * (point.cost * problem.scene().duration / frame) +
                                     truths.work(seed, verification.starts)};
  return verification;
}

/// Of candidates that reach the wish the cheapest that keep it from all starts over the whole time, by their
/// costs: as many as are wanted, and as are paid for until `until` instructions are spent. One that does not is
/// strengthened, and so takes its place further back. `choice.verified` is that of the first.
std::vector<Candidate> verified(const Problem& problem, const Wish& wish, std::vector<Candidate>& found,
                                int starts, std::size_t wanted, const Search& search, double until, Truths& truths,
                                Choice& choice) {
  std::vector<Candidate> kept;
  std::vector<Attempts> attempts(found.size());
  while (kept.size() < wanted) {
    Candidate* next = nullptr;
    for (Candidate& candidate : found)
      if (candidate.reached && (!next || preferred(candidate, *next, wish))) next = &candidate;
    if (!next) break;
    if (choice.spent.work > until) {
      choice.at_its_bound = true;
      break;
    }
    // From other starts after each failure: none of those for which it was tuned.
    auto& [left, missed] = attempts[static_cast<std::size_t>(next - found.data())];
    const int seed = 1 + most_attempts - left;
    const Verification verification =
        counted(problem, next->point, wish, starts, search, seed, truths, choice.spent);
    if (verification.kept()) {
      if (kept.empty()) choice.verified = verification;
      kept.push_back(*next);
      next->reached = false;
      continue;
    }
    missed.push_back(problem.variation(verification.worst, seed));
    *next = strengthened(problem, wish, *next, missed, std::min(search.most / 20, until - choice.spent.work),
                         choice.spent);
    next->reached = next->reached && --left > 0;
  }
  return kept;
}

}  // namespace

double excess(const Point& point, const std::map<Error, double>& limits) {
  double most = point.outcome == Outcome::good ? 0 : INFINITY;
  for (const auto& [error, limit] : limits) {
    const double unknown = error == Error::trajectory ? point.uncertainty : 0;
    most = std::max(most, point.has(error) ? (point[error] + unknown) / limit : INFINITY);
  }
  return most;
}

Candidate cheapest(const Problem& problem, const Family& family, const Wish& wish, double bound, Spent* spent,
                   double most_work, Known* known) {
  std::vector<std::unique_ptr<Variant>> variants;
  Variant* best = nullptr;
  double work = 0;
  for (const Cure cure : family.cures)
    for (const int passes : {1, 2, 4, 8, 16, 64}) {
      if (passes > (family.pass == "digit" ? 4 : family.pass.empty() ? 1 : 64)) break;
      if (best && work > most_work) break;
      const double most = best && best->best().reached ? best->best().point.cost : INFINITY;
      variants.push_back(
          std::make_unique<Variant>(problem, family, wish, std::min(bound, most), most_work - work, known));
      Variant& variant = *variants.back();
      variant.search(cure, passes);
      work += variant.spent().work;
      if (!best || (variant.best().point.family && preferred(variant.best(), best->best(), wish))) best = &variant;
      if (variant.best().point.outcome == Outcome::refused) break;
    }
  best->descend();
  if (spent)
    for (const auto& variant : variants) *spent += variant->spent();
  return best->best();
}

Verification verify(const Problem& problem, const Point& point, const Wish& wish, int starts, const Search& search,
                    int seed, bool until_one_fails) {
  Verification result{.seconds = problem.scene().duration};
  // First a few, because most that fail do so soon.
  for (int batch = until_one_fails ? 6 : starts; result.starts < starts; batch *= 2) {
    const int first = result.starts;
    std::vector<Point> points(static_cast<std::size_t>(std::min(batch, starts - first)));
    search.side_by_side(static_cast<int>(points.size()), [&](int i) {
      points[static_cast<std::size_t>(i)] =
          whole_run(problem.variation(first + i, seed), *point.family, point.knobs, wish);
    });
    for (const Point& one : points) {
      ++result.starts;
      result.good += one.outcome == Outcome::good;
      const double over = excess(one, wish.limits);
      result.within += over <= 1;
      if (over > result.excess) result.excess = over, result.worst = result.starts - 1;
      if (one.outcome != Outcome::good && result.first_failure.empty()) result.first_failure = one.reason;
    }
    if (until_one_fails && !result.kept()) break;
  }
  return result;
}

Choice choose(const Problem& problem, const Wish& wish, const Search& search) {
  require_valid(problem, wish);
  if (asks_for_reference(wish.limits)) problem.reference();  // before the threads, which would wait for it
  Truths truths(problem, wish);
  Choice choice;
  choice.limit = limit_of(problem);
  const auto& all = families();
  std::vector<Candidate> found(all.size());
  const auto by_preference = [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish); };
  std::vector<char> settled(all.size());  // of which methods the answer is known
  std::vector<Known> known(all.size());
  const double rows = std::max(1, problem.start().degrees_of_freedom());
  double cheapest_yet = INFINITY;
  // All of these methods that have not reached the wish yet, at a cost of at most `most` a frame, until `until`
  // instructions are spent.
  const auto look = [&](std::vector<std::size_t> which, double most, double until) {
    std::erase_if(which, [&](std::size_t at) {
      return found[at].reached || found[at].point.outcome == Outcome::refused || settled[at];
    });
    const double bound = std::min(most, worth * cheapest_yet),
                 each = std::min(search.most / 20,
                                 std::max(0.0, until - choice.spent.work) / static_cast<double>(which.size()));
    std::vector<Spent> spent(which.size());
    search.side_by_side(static_cast<int>(which.size()), [&](int i) {
      const std::size_t at = which[static_cast<std::size_t>(i)];
      search.told(all[at].name);
      Spent& own = spent[static_cast<std::size_t>(i)];
      const Candidate now = wish.limits.empty()
                                ? most_accurate(problem, all[at], wish, &own)
                                : cheapest(problem, all[at], wish, std::min(bound, budget_of(wish, all[at])), &own,
                                           each, &known[at]);
      // A search that may take little comes less near than one before.
      if (!found[at].point.family || now.point.outcome == Outcome::refused || preferred(now, found[at], wish))
        found[at] = now;
    });
    for (const Spent& one : spent) choice.spent += one;
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
  constexpr double hopeless = 1e13;  // instructions a frame
  double level = wish.limits.empty() ? INFINITY : 1000 * rows * choice.limit.substeps;
  for (;; level *= 2.5) {
    const double half = search.most / 2;
    look(first, level, half), look(second, level, half);
    const bool all_of_them = choice.spent.work <= search.enough;
    if (all_of_them) look(rest, level, half);
    const bool spent_all = std::all_of(all.begin(), all.end(),
                                       [&](const Family& family) { return level >= budget_of(wish, family); });
    if (all_of_them) choice.searched = spent_all ? INFINITY : level;
    // Or a run at this cost is more than one method may take.
    choice.at_its_bound =
        choice.spent.work > 0.9 * half || level * screening(problem) / frame > 2.5 * search.most / 20;
    // Until none is left out that costs little more than the cheapest.
    if (level >= worth * cheapest_yet || spent_all || choice.at_its_bound || level > hopeless ||
        choice.spent.work > 3 * search.enough)
      break;
  }
  choice.searched_exactly = std::max(level, choice.searched);
  const int starts = std::isfinite(cheapest_yet) ? starts_of(problem, wish, cheapest_yet, search) : 0;
  std::vector<Candidate> kept =
      verified(problem, wish, found, starts, 3, search, 0.7 * search.most, truths, choice);
  // What was left out as too dear beside a candidate that did not keep the wish.
  if (!wish.limits.empty() && starts > 0 && choice.spent.work < 0.7 * search.most &&
      (kept.empty() || kept.front().point.cost > 1.05 * cheapest_yet)) {
    for (const Candidate& one : kept) settled[static_cast<std::size_t>(one.point.family - all.data())] = 1;
    cheapest_yet = kept.empty() ? 10 * cheapest_yet : kept.front().point.cost / worth;
    const double until = 0.7 * search.most;
    look(first, INFINITY, until), look(second, INFINITY, until);
    if (choice.spent.work <= search.enough) look(rest, INFINITY, until);
    const Verification of_first = choice.verified;
    const std::vector<Candidate> more =
        verified(problem, wish, found, starts, 3, search, 0.8 * search.most, truths, choice);
    if (!kept.empty() && (more.empty() || !preferred(more.front(), kept.front(), wish)))
      choice.verified = of_first;
    kept.insert(kept.end(), more.begin(), more.end());
    std::stable_sort(kept.begin(), kept.end(), by_preference);
    if (kept.size() > 3) kept.resize(3);
  }
  const auto measured_whole = [&](const Point& point) {
    return whole_run(problem, *point.family, point.knobs, wish, search.all_errors);
  };
  std::stable_sort(found.begin(), found.end(), by_preference);
  choice.reached = !kept.empty();
  if (choice.reached) {
    choice.best = kept.front();
    choice.best.point = measured_whole(choice.best.point);
    choice.runners_up.assign(kept.begin() + 1, kept.end());
  } else {
    choice.best = found.front();
    if (choice.best.point.outcome == Outcome::good) {  // so far it may have been watched in part
      choice.best.point = measured_whole(choice.best.point);
      choice.best.excess = excess(choice.best.point, wish.limits);
    }
  }
  for (const Candidate& candidate : found) {
    const auto is_it = [&](const Candidate& one) { return one.point.family == candidate.point.family; };
    if (is_it(choice.best) || std::any_of(kept.begin(), kept.end(), is_it)) continue;
    if (!candidate.point.family || candidate.point.outcome == Outcome::too_slow) continue;
    if (candidate.point.outcome != Outcome::good || !std::isfinite(candidate.excess)) {
      choice.passed.push_back(candidate.point);
      continue;
    }
    // The search stopped it where it had passed a limit: the errors of the whole run count, if it is paid for.
    if (choice.spent.work + candidate.point.cost * problem.scene().duration / frame > search.most) {
      choice.at_its_bound = true;
      continue;
    }
    const Point whole = whole_run(problem, *candidate.point.family, candidate.point.knobs, wish);
    choice.spent += {1, work_of(whole)};
    if (whole.outcome == Outcome::good)
      choice.runners_up.push_back({false, whole, excess(whole, wish.limits)});
    else
      choice.passed.push_back(whole);
  }
  if (!choice.reached) return choice;

  // Fewer substeps, until they do not keep it from all starts.
  while (choice.best.point.knobs.substeps > 1) {
    Knobs fewer = choice.best.point.knobs;
    fewer.substeps = std::max(1, std::min(fewer.substeps - 1, fewer.substeps * 9 / 10));
    choice.coarser = whole_run(problem, *choice.best.point.family, fewer, wish, search.all_errors);
    const double over = excess(*choice.coarser, wish.limits);
    if (wish.limits.empty() || !(over <= 1) || choice.spent.work > 0.8 * search.most) break;
    const Verification verification =
        counted(problem, *choice.coarser, wish, starts, search, 1, truths, choice.spent);
    if (!verification.kept()) break;
    choice.best = {true, *choice.coarser, over};
    choice.verified = verification;
  }

  if (search.tighter && !wish.limits.empty()) {
    // Of the methods whose search is quick, too: what is exact costs no more for less.
    std::vector<const Family*> able;
    for (const Candidate& one : kept) able.push_back(one.point.family);
    for (const std::size_t at : first)
      if (std::find(able.begin(), able.end(), &all[at]) == able.end()) able.push_back(&all[at]);
    const auto tighter = [&](double share, double until) -> std::optional<Point> {
      Wish tight = wish;
      for (auto& [error, limit] : tight.limits) limit *= share;
      tight.budget = nullptr;
      if (choice.spent.work > until) return {};
      if (choice.verified.excess <= share) return choice.best.point;  // from the starts that it was verified from
      std::vector<Candidate> again(able.size());
      // A search that is allowed much takes long, and finds nothing cheaper than one that found something.
      for (const double times : {4.0, 100.0}) {
        std::vector<Spent> work(able.size());
        search.side_by_side(static_cast<int>(able.size()), [&](int i) {
          const auto at = static_cast<std::size_t>(i);
          again[at] = cheapest(problem, *able[at], tight, times * choice.best.point.cost, &work[at],
                               std::min(search.most / 20, std::max(0.0, until - choice.spent.work) /
                                                              static_cast<double>(able.size())));
        });
        for (const Spent& one : work) choice.spent += one;
        if (std::any_of(again.begin(), again.end(), [](const Candidate& one) { return one.reached; })) break;
      }
      const Verification of_best = choice.verified;
      const auto best = verified(problem, tight, again, starts, 1, search, until, truths, choice);
      const Verification of_tight = std::exchange(choice.verified, of_best);
      if (best.empty()) return {};
      const Point point = measured_whole(best.front().point);
      if (point.cost < choice.best.point.cost && point.cost <= budget_of(wish, *point.family)) {
        // It keeps the wish itself for less, which its search had missed.
        std::erase_if(choice.runners_up, [&](const Candidate& one) { return one.point.family == point.family; });
        if (point.family != choice.best.point.family)
          choice.runners_up.insert(choice.runners_up.begin(), choice.best);
        choice.best = {true, point, excess(point, wish.limits)};
        choice.verified = of_tight;
        choice.verified.excess *= share;
        choice.robust = point;
      }
      return point;
    };
    choice.robust = tighter(0.5, 0.85 * search.most);
    choice.finer = tighter(0.1, 0.95 * search.most);
    if (choice.finer && choice.robust && choice.finer->cost < choice.robust->cost) choice.robust = choice.finer;
  }
  auto limits = wish.limits;
  if (limits.empty()) limits[Error::drift] = 2 * choice.best.point[Error::drift];
  choice.margin = margin(problem, choice.best.point, limits, &choice.spent, search.most / 10);
  return choice;
}

double margin(const Problem& problem, const Point& point, const std::map<Error, double>& limits, Spent* spent,
              double most_work) {
  const NamedScene& scene = problem.scene();
  const auto parameter = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                      [&](const SceneParameter& one) { return one.name == scene.stress; });
  const double value = problem[scene.stress];
  Watch watch{.seconds = screening(problem), .reference = asks_for_reference(limits)};
  for (const auto& [error, limit] : limits) watch.limit[static_cast<std::size_t>(error)] = limit;
  double work = 0;
  const auto holds = [&](double factor) {
    if (factor == 1) return true;
    // Times its largest factor the value may be above its upper end by rounding.
    const Point run = measure(problem.with(scene.stress, std::min(factor * value, parameter->high)), *point.family,
                              point.knobs, watch);
    work += work_of(run);
    if (spent) *spent += {1, work_of(run)};
    return excess(run, limits) <= 1;
  };
  if (!(value > 0)) return NAN;
  const double most = std::min(1000.0, parameter->high / value);
  double low = 1, high = 1;
  // In short strides: where steps are too long for a stiff scene, good bands follow bad ones.
  while (holds(high)) {
    if (work > most_work) return NAN;
    low = high;
    if (high >= most) return INFINITY;
    high = std::min(1.2 * high, most);
  }
  while (high > 1.05 * low) {
    if (work > most_work) return NAN;
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return high;
}

}  // namespace byhand
