#include "lessons/catalogue/chooser.hpp"

#include <algorithm>
#include <utility>

#include "lessons/catalogue/cheapest.hpp"

namespace byhand {
namespace {

constexpr int most_attempts = 12;        // to find a candidate's choices that keep the wish from all starts
constexpr double worth = 1.5;            // times the cheapest: what costs more is not looked for
constexpr std::size_t most_answers = 3;  // the recommended one and its runners-up

/// Instructions that the true motion from another start takes.
double work_of_truth(const Problem& problem, const Wish& wish) {
  const auto& work = problem.scene().reference_work;
  return work && asks_for_reference(wish.limits) ? work->load() : 0;
}

/// What a run over the whole time takes that costs so much a frame.
double whole_work(const Problem& problem, double cost) { return cost * problem.scene().duration / frame; }

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
  double work = std::max(whole_work(problem, cost), work_of_truth(problem, wish) / for_truth);
  if (asks_for_reference(wish.limits) && problem.scene().chaotic)
    work =
        std::max(work, search.verification / 160 * limit_of(problem).substeps);  // each has a reference of its own
  return std::clamp(static_cast<int>(search.verification / work), std::min(4, search.starts), search.starts);
}

/// The least drift within a budget.
Candidate most_accurate(const Problem& problem, const Family& family, const Wish& wish, Spent& spent) {
  Runs runs(problem, family, {.seconds = screening(problem), .reference = false, .most = budget_of(wish, family)});
  explore(runs, std::array{Error::drift}, 80);
  spent += {runs.made(), runs.work()};
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

/// The choice of one wish: all methods are searched, what they found is verified from other starts, and what is
/// recommended is set beside its neighbours.
class Choosing {
 public:
  Choosing(const Problem& problem, const Wish& wish, const Search& search)
      : problem_(problem), wish_(wish), search_(search), truths_(problem, wish) {
    choice_.limit = limit_of(problem);
    for (std::size_t i = 0; i < all_.size(); ++i)
      (all_[i].exact && all_[i].solves_rows      ? quick_
       : all_[i].exact || all_[i].name == "XPBD" ? exact_
                                                 : rest_)
          .push_back(i);
  }

  Choice made() {
    search_all();
    std::vector<Candidate> kept = verified_with_dearer();
    recommend(kept);
    tell_others(kept);
    if (!choice_.reached) return choice_;
    coarsen();
    if (search_.tighter && !wish_.limits.empty()) tighten(kept);
    auto limits = wish_.limits;
    if (limits.empty()) limits[Error::drift] = 2 * choice_.best.point[Error::drift];
    choice_.margin = margin(problem_, choice_.best.point, limits, &choice_.spent, search_.most / 10);
    return choice_;
  }

 private:
  double& work() { return choice_.spent.work; }
  /// What one method may take of what is left until `until`, where so many share it.
  double share(double until, std::size_t among = 1) {
    return std::min(most_of_one_, std::max(0.0, until - work()) / static_cast<double>(among));
  }
  Point whole(const Problem& start, const Family& family, const Knobs& knobs) {
    const Point point = whole_run(start, family, knobs, wish_);
    choice_.spent += {1, work_of(point)};
    return point;
  }
  Point with_all_errors(const Family& family, const Knobs& knobs) const {
    return whole_run(problem_, family, knobs, wish_, search_.all_errors);
  }

  void look(std::vector<std::size_t> which, double most, double until);
  void search_all();
  Candidate strengthened(const Wish& wish, const Candidate& candidate, const std::vector<Problem>& missed,
                         double until);
  Verification counted(const Wish& wish, const Point& point, int seed);
  std::vector<Candidate> verified(const Wish& wish, std::vector<Candidate>& found, std::size_t wanted,
                                  double until);
  std::vector<Candidate> verified_with_dearer();
  void recommend(const std::vector<Candidate>& kept);
  void tell_others(const std::vector<Candidate>& kept);
  void coarsen();
  void tighten(const std::vector<Candidate>& kept);
  std::optional<Point> tighter(double share, const std::vector<const Family*>& able, double until);

  const Problem& problem_;
  const Wish& wish_;
  const Search& search_;
  const std::vector<Family>& all_ = families();
  // What is quick to search comes first: it bounds what the rest may cost.
  std::vector<std::size_t> quick_, exact_, rest_;
  const double most_of_one_ = search_.most / 20;
  Truths truths_;
  std::vector<Candidate> found_{all_.size()};  // by method
  std::vector<Known> known_{all_.size()};
  std::vector<char> settled_ = std::vector<char>(all_.size());  // of which the answer is known
  double cheapest_yet_ = INFINITY;
  int starts_ = 0;  // of each verification
  Choice choice_;
};

/// All of these methods that have not reached the wish yet, at a cost of at most `most` a frame, until `until`
/// instructions are spent.
void Choosing::look(std::vector<std::size_t> which, double most, double until) {
  std::erase_if(which, [&](std::size_t at) {
    return found_[at].reached || found_[at].point.outcome == Outcome::refused || settled_[at];
  });
  const double bound = std::min(most, worth * cheapest_yet_), each = share(until, which.size());
  std::vector<Spent> spent(which.size());
  search_.side_by_side(static_cast<int>(which.size()), [&](int i) {
    const std::size_t at = which[static_cast<std::size_t>(i)];
    search_.told(all_[at].name);
    Spent& own = spent[static_cast<std::size_t>(i)];
    const Candidate now = wish_.limits.empty()
                              ? most_accurate(problem_, all_[at], wish_, own)
                              : cheapest(problem_, all_[at], wish_, std::min(bound, budget_of(wish_, all_[at])),
                                         &own, each, &known_[at]);
    // A search that may take little comes less near than one before.
    if (!found_[at].point.family || now.point.outcome == Outcome::refused || preferred(now, found_[at], wish_))
      found_[at] = now;
  });
  for (const Spent& one : spent) choice_.spent += one;
  for (const std::size_t at : which)
    if (found_[at].reached) cheapest_yet_ = std::min(cheapest_yet_, found_[at].point.cost);
}

/// Dearer ways are tried where no cheaper one does. Methods that solve exactly have few choices, so that their
/// search goes on when that of all others has cost enough.
void Choosing::search_all() {
  constexpr double hopeless = 1e13;  // instructions a frame
  const double rows = std::max(1, problem_.start().degrees_of_freedom()), half = search_.most / 2;
  double level = wish_.limits.empty() ? INFINITY : 1000 * rows * choice_.limit.substeps;
  for (;; level *= 2.5) {
    look(quick_, level, half), look(exact_, level, half);
    const bool all_of_them = work() <= search_.enough;
    if (all_of_them) look(rest_, level, half);
    const bool spent_all = std::all_of(all_.begin(), all_.end(),
                                       [&](const Family& family) { return level >= budget_of(wish_, family); });
    if (all_of_them) choice_.searched = spent_all ? INFINITY : level;
    // Or a run at this cost is more than one method may take.
    choice_.at_its_bound = work() > 0.9 * half || level * screening(problem_) / frame > 2.5 * most_of_one_;
    // Until none is left out that costs little more than the cheapest.
    if (level >= worth * cheapest_yet_ || spent_all || choice_.at_its_bound || level > hopeless ||
        work() > 3 * search_.enough)
      break;
  }
  choice_.searched_exactly = std::max(level, choice_.searched);
  starts_ = std::isfinite(cheapest_yet_) ? starts_of(problem_, wish_, cheapest_yet_, search_) : 0;
}

/// A candidate with so few more substeps that it keeps its own start and those it has missed; or, if that costs
/// more than `worth_a_search`, the same method tuned anew for the last of those, where it is cheaper.
Candidate Choosing::strengthened(const Wish& wish, const Candidate& candidate, const std::vector<Problem>& missed,
                                 double until) {
  const Family& family = *candidate.point.family;
  const double budget = budget_of(wish, family);
  Candidate more = candidate;
  more.reached = false;
  const auto kept = [&](const Problem& start) {
    more.point = whole(start, family, more.point.knobs);
    more.excess = wish.limits.empty() ? more.point[Error::drift] : excess(more.point, wish.limits);
    return more.point.outcome == Outcome::good && (wish.limits.empty() || more.excess <= 1) &&
           more.point.cost <= budget;
  };
  for (int parts = 1; parts <= 128 && !more.reached && more.point.cost <= budget && work() <= until; parts *= 2) {
    const int from = candidate.point.knobs.substeps;
    more.point.knobs.substeps = std::max(more.point.knobs.substeps + 1, from + from * parts / 16);
    // The hardest first.
    more.reached = std::all_of(missed.rbegin(), missed.rend(), kept) && kept(problem_);
  }
  constexpr double worth_a_search = 1.15;  // times the candidate's cost
  if (wish.limits.empty() || (more.reached && more.point.cost <= worth_a_search * candidate.point.cost))
    return more;
  const double most = std::min({more.reached ? more.point.cost : INFINITY, 10 * candidate.point.cost, budget});
  const Candidate tuned = cheapest(missed.back(), family, wish, most, &choice_.spent, until - work());
  return tuned.reached && tuned.point.cost > candidate.point.cost ? tuned : more;
}

/// A run from each of the first starts of a seed until one fails.
Verification Choosing::counted(const Wish& wish, const Point& point, int seed) {
  const Verification verification = verify(problem_, point, wish, starts_, search_.side_by_side, seed, true);
  choice_.spent += {verification.starts, verification.starts * whole_work(problem_, point.cost) +
                                             truths_.work(seed, verification.starts)};
  return verification;
}

/// Of candidates that reach the wish the cheapest that keep it from all starts over the whole time, by their
/// costs: as many as are wanted, and as are paid for until `until` instructions are spent. One that does not is
/// strengthened, and so takes its place further back. `choice_.verified` becomes that of the first.
std::vector<Candidate> Choosing::verified(const Wish& wish, std::vector<Candidate>& found, std::size_t wanted,
                                          double until) {
  std::vector<Candidate> kept;
  std::vector<Attempts> attempts(found.size());
  while (kept.size() < wanted) {
    Candidate* next = nullptr;
    for (Candidate& candidate : found)
      if (candidate.reached && (!next || preferred(candidate, *next, wish))) next = &candidate;
    if (!next) break;
    if (work() > until) {
      choice_.at_its_bound = true;
      break;
    }
    // From other starts after each failure: none of those for which it was tuned.
    auto& [left, missed] = attempts[static_cast<std::size_t>(next - found.data())];
    const int seed = 1 + most_attempts - left;
    const Verification verification = counted(wish, next->point, seed);
    if (verification.kept()) {
      if (kept.empty()) choice_.verified = verification;
      kept.push_back(*next);
      next->reached = false;
      continue;
    }
    missed.push_back(problem_.variation(verification.worst, seed));
    *next = strengthened(wish, *next, missed, work() + std::min(most_of_one_, until - work()));
    next->reached = next->reached && --left > 0;
  }
  return kept;
}

/// What keeps the wish; and where that is dearer than what was found, what was left out as too dear beside it.
std::vector<Candidate> Choosing::verified_with_dearer() {
  std::vector<Candidate> kept = verified(wish_, found_, most_answers, 0.7 * search_.most);
  if (wish_.limits.empty() || starts_ == 0 || work() >= 0.7 * search_.most ||
      (!kept.empty() && kept.front().point.cost <= 1.05 * cheapest_yet_))
    return kept;
  for (const Candidate& one : kept) settled_[static_cast<std::size_t>(one.point.family - all_.data())] = 1;
  cheapest_yet_ = kept.empty() ? 10 * cheapest_yet_ : kept.front().point.cost / worth;
  const double until = 0.7 * search_.most;
  look(quick_, INFINITY, until), look(exact_, INFINITY, until);
  if (work() <= search_.enough) look(rest_, INFINITY, until);
  const Verification of_first = choice_.verified;
  const std::vector<Candidate> more = verified(wish_, found_, most_answers, 0.8 * search_.most);
  if (!kept.empty() && (more.empty() || !preferred(more.front(), kept.front(), wish_)))
    choice_.verified = of_first;
  kept.insert(kept.end(), more.begin(), more.end());
  std::stable_sort(kept.begin(), kept.end(),
                   [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish_); });
  if (kept.size() > most_answers) kept.resize(most_answers);
  return kept;
}

/// The cheapest that keeps the wish, or what comes nearest.
void Choosing::recommend(const std::vector<Candidate>& kept) {
  choice_.reached = !kept.empty();
  if (choice_.reached) {
    choice_.best = kept.front();
    choice_.best.point = with_all_errors(*choice_.best.point.family, choice_.best.point.knobs);
    choice_.runners_up.assign(kept.begin() + 1, kept.end());
    return;
  }
  choice_.best = *std::min_element(found_.begin(), found_.end(),
                                   [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish_); });
  if (choice_.best.point.outcome != Outcome::good) return;
  // So far it may have been watched in part.
  choice_.best.point = with_all_errors(*choice_.best.point.family, choice_.best.point.knobs);
  choice_.best.excess = excess(choice_.best.point, wish_.limits);
}

/// What held from the scene's own start, and what cannot run it or failed.
void Choosing::tell_others(const std::vector<Candidate>& kept) {
  std::stable_sort(found_.begin(), found_.end(),
                   [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish_); });
  for (const Candidate& candidate : found_) {
    const auto is_it = [&](const Candidate& one) { return one.point.family == candidate.point.family; };
    if (is_it(choice_.best) || std::any_of(kept.begin(), kept.end(), is_it)) continue;
    if (!candidate.point.family || candidate.point.outcome == Outcome::too_slow) continue;
    if (candidate.point.outcome != Outcome::good || !std::isfinite(candidate.excess)) {
      choice_.passed.push_back(candidate.point);
      continue;
    }
    // The search stopped it where it had passed a limit: the errors of the whole run count, if it is paid for.
    if (work() + whole_work(problem_, candidate.point.cost) > search_.most) {
      choice_.at_its_bound = true;
      continue;
    }
    const Point point = whole(problem_, *candidate.point.family, candidate.point.knobs);
    if (point.outcome == Outcome::good)
      choice_.runners_up.push_back({false, point, excess(point, wish_.limits)});
    else
      choice_.passed.push_back(point);
  }
}

/// Fewer substeps, until they do not keep it from all starts.
void Choosing::coarsen() {
  while (choice_.best.point.knobs.substeps > 1) {
    Knobs fewer = choice_.best.point.knobs;
    fewer.substeps = std::max(1, std::min(fewer.substeps - 1, fewer.substeps * 9 / 10));
    choice_.coarser = with_all_errors(*choice_.best.point.family, fewer);
    const double over = excess(*choice_.coarser, wish_.limits);
    if (wish_.limits.empty() || !(over <= 1) || work() > 0.8 * search_.most) return;
    const Verification verification = counted(wish_, *choice_.coarser, 1);
    if (!verification.kept()) return;
    choice_.best = {true, *choice_.coarser, over};
    choice_.verified = verification;
  }
}

/// Half and a tenth of the limits, by what keeps the wish and by the methods whose search is quick: what is exact
/// costs no more for less.
void Choosing::tighten(const std::vector<Candidate>& kept) {
  std::vector<const Family*> able;
  for (const Candidate& one : kept) able.push_back(one.point.family);
  for (const std::size_t at : quick_)
    if (std::find(able.begin(), able.end(), &all_[at]) == able.end()) able.push_back(&all_[at]);
  std::vector<const Family*> others;
  for (const Candidate& one : found_)
    if (one.point.family && one.point.outcome != Outcome::refused &&
        std::find(able.begin(), able.end(), one.point.family) == able.end())
      others.push_back(one.point.family);
  // Where none of them does, all others.
  const auto either = [&](double part, double until, double at_last) {
    auto found = tighter(part, able, until);
    return found || others.empty() ? found : tighter(part, others, at_last);
  };
  choice_.robust = either(0.5, 0.8 * search_.most, 0.85 * search_.most);
  choice_.finer = either(0.1, 0.9 * search_.most, 0.95 * search_.most);
  if (choice_.finer && choice_.robust && choice_.finer->cost < choice_.robust->cost)
    choice_.robust = choice_.finer;
}

/// The cheapest of these methods that keeps that share of the limits.
std::optional<Point> Choosing::tighter(double part, const std::vector<const Family*>& able, double until) {
  Wish tight = wish_;
  for (auto& [error, limit] : tight.limits) limit *= part;
  tight.budget = nullptr;
  if (work() > until) return {};
  if (choice_.verified.excess <= part) return choice_.best.point;  // from the starts that it was verified from
  std::vector<Candidate> again(able.size());
  // A search that is allowed much takes long, and finds nothing cheaper than one that found something.
  for (const double times : {4.0, 100.0}) {
    std::vector<Spent> spent(able.size());
    const double each = share(until, able.size());
    search_.side_by_side(static_cast<int>(able.size()), [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      again[at] = cheapest(problem_, *able[at], tight, times * choice_.best.point.cost, &spent[at], each);
    });
    for (const Spent& one : spent) choice_.spent += one;
    if (std::any_of(again.begin(), again.end(), [](const Candidate& one) { return one.reached; })) break;
  }
  const Verification of_best = choice_.verified;
  const auto best = verified(tight, again, 1, until);
  const Verification of_tight = std::exchange(choice_.verified, of_best);
  if (best.empty()) return {};
  const Point point = with_all_errors(*best.front().point.family, best.front().point.knobs);
  if (point.cost < choice_.best.point.cost && point.cost <= budget_of(wish_, *point.family)) {
    // It keeps the wish itself for less, which its search had missed.
    std::erase_if(choice_.runners_up, [&](const Candidate& one) { return one.point.family == point.family; });
    if (point.family != choice_.best.point.family)
      choice_.runners_up.insert(choice_.runners_up.begin(), choice_.best);
    choice_.best = {true, point, excess(point, wish_.limits)};
    choice_.verified = of_tight;
    choice_.verified.excess *= part;
    choice_.robust = point;
  }
  return point;
}

}  // namespace

Choice choose(const Problem& problem, const Wish& wish, const Search& search) {
  require_valid(problem, wish);
  if (asks_for_reference(wish.limits)) problem.reference();  // before the threads, which would wait for it
  return Choosing(problem, wish, search).made();
}

}  // namespace byhand
