#include "lessons/catalogue/chooser.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "lessons/catalogue/cheapest.hpp"
#include "lessons/catalogue/drawn.hpp"

namespace byhand {
namespace {

// For choices that also keep a start that was missed; then by more substeps, and in all.
constexpr int most_searches = 10, most_misses = 40;
constexpr double worth = 1.5;            // times the cheapest: what costs more is not looked for
constexpr double hopeless = 1e13;        // instructions a frame
constexpr std::size_t most_answers = 3;  // the recommended one and its runners-up

/// What a run over the whole time takes that costs so much a frame.
double whole_work(const Problem& problem, double cost) { return cost * problem.scene().duration / frame; }

/// Counts the true motions of other starts, each of which is found once.
class Truths {
 public:
  Truths(const Problem& problem, const Wish& wish) : problem_(problem), wish_(wish) {}

  /// Of a seed's starts of these numbers, those that are new.
  double work(int seed, std::span<const int> numbers) {
    const auto fresh =
        std::ranges::count_if(numbers, [&](int number) { return known_.emplace(seed, number).second; });
    return static_cast<double>(fresh) * work_of_truth(problem_, wish_.limits);
  }

 private:
  const Problem& problem_;
  const Wish& wish_;
  std::set<std::pair<int, int>> known_;  // seed and number
};

/// From how many starts beside the scene's own what a search finds has to reach the wish.
int other_starts(const Problem& problem, const Wish& wish, const Search& search) {
  constexpr double share = 0.05;  // of the search, for their true motions
  return wish.limits.empty()
             ? 0
             : static_cast<int>(std::clamp(share * search.most / work_of_truth(problem, wish.limits), 2.0, 6.0));
}

/// From how many starts runs of that cost are verified.
int count_of_starts(const Problem& problem, const Wish& wish, double cost, const Search& search) {
  constexpr double for_truth = 5;  // times as much, as all verifications share them
  double work = std::max(whole_work(problem, cost), work_of_truth(problem, wish.limits) / for_truth);
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

/// A wish, and the starts that a search holds what it finds against: at first a few, then also those of the
/// verification from which a choice missed it. In the verification others take their place.
struct Contest {
  Wish wish;
  std::vector<Problem> starts = {};
  std::size_t added_from = 0;           // place of the first of the verification among them
  std::vector<int> verified_from = {};  // numbers of the verification's starts
  int next = 0;                         // number
  int left_out = 0;                     // of the verification, as the true motion is not well known
  std::vector<std::vector<Known>> known = std::vector<std::vector<Known>>(families().size());  // by method, start
};

bool well_known(const Problem& start, const Wish& wish) {
  return !wish.limits.contains(Error::trajectory) || well_known(start.reference().uncertainty, wish.limits);
}

/// The choice of one wish: all methods are searched, what they found is verified from other starts, and what is
/// recommended is set beside its neighbours.
class Choosing {
 public:
  Choosing(const Problem& problem, const Wish& wish, const Search& search)
      : problem_(problem), wish_(wish), search_(search), truths_(problem, wish) {
    std::vector<int> others(static_cast<std::size_t>(other_starts(problem, wish, search)));
    std::iota(others.begin(), others.end(), 1);
    for (const int start : others) first_starts_.push_back(problem.variation(start, seed_of_searches));
    if (asks_for_reference(wish.limits))
      search.side_by_side(static_cast<int>(first_starts_.size()),
                          [&](int i) { first_starts_[static_cast<std::size_t>(i)].reference(); });
    begin(contest_);
    choice_.spent.work += truths_.work(seed_of_searches, others);
    choice_.limit = limit_of(problem);
    for (std::size_t i = 0; i < all_.size(); ++i)
      (all_[i].exact && all_[i].solves_rows      ? quick_
       : all_[i].exact || all_[i].name == "XPBD" ? exact_
                                                 : rest_)
          .push_back(i);
  }

  Choice made() {
    search_all();
    kept_ = verified_with_dearer();
    if (kept_.empty() && choice_.at_its_bound && !wish_.limits.empty()) kept_ = verified_with_shorter_steps();
    recommend();
    tell_others();
    if (!choice_.reached) return choice_;
    coarsen();
    const bool time_left = work() < by_finer_;
    if (time_left)
      if (const auto cheaper = drawn(contest_, choice_.best.point, choice_.best.point.cost)) {
        take(with_all_errors(*cheaper->first.point.family, cheaper->first.point.knobs), cheaper->second);
        coarsen();
      }
    certify();
    if (choice_.reached && search_.tighter && time_left && !wish_.limits.empty()) {
      const Point certified = choice_.best.point;
      tighten();
      if (!same_setting(certified, choice_.best.point)) certify();
    }
    if (!choice_.reached) return choice_;
    choice_.at_its_bound = choice_.at_its_bound || work() > 0.9 * by_finer_;
    auto limits = wish_.limits;
    if (limits.empty()) limits[Error::drift] = 2 * choice_.best.point[Error::drift];
    choice_.margin =
        margin(problem_, choice_.best.point, limits, &choice_.spent, search_.most / 10, search_.side_by_side);
    return choice_;
  }

 private:
  double& work() { return choice_.spent.work; }
  /// What one of so many methods may take of what is left until `until`.
  double share(double until, std::size_t among) {
    return std::max(0.0, until - work()) / static_cast<double>(among);
  }
  Point whole(const Problem& start, const Family& family, const Knobs& knobs) {
    const Point point = whole_run(start, family, knobs, wish_);
    choice_.spent += {1, work_of(point)};
    return point;
  }
  Point with_all_errors(const Family& family, const Knobs& knobs) const {
    return whole_run(problem_, family, knobs, wish_, search_.all_errors);
  }

  void begin(Contest& contest) const;
  void look(std::vector<std::size_t> which, double most, double until);
  void look_at_all(double until);
  void search_all();
  Candidate found_by(Contest& contest, const Family& family, double bound, double most, Spent& spent) const;
  Candidate with_more_substeps(const Contest& contest, const Candidate& candidate, int first, int last,
                               double until);
  Candidate found_again(Contest& contest, const Candidate& candidate, int misses, double until);
  struct Counted {
    Verification verification;
    std::optional<int> missed;  // number of the verification's start from which the wish was missed most
  };
  Counted counted(Contest& contest, const Point& point);
  bool keeps_added(const Contest& contest, const Point& point);
  void add(Contest& contest, int missed);
  std::optional<Verification> kept_from_all(Contest& contest, const Point& point);
  std::vector<Candidate> verified(Contest& contest, std::vector<Candidate>& found, std::size_t wanted,
                                  double until, double until_first);
  std::vector<Candidate> verified_with_dearer();
  std::vector<Candidate> verified_with_shorter_steps();
  void recommend();
  Candidate nearest();
  void tell_others();
  void take(const Point& best, const Verification& verification);
  std::optional<std::pair<Candidate, Verification>> drawn(Contest& contest, const Point& from, double bound);
  struct Coarsened {
    Point point;
    Verification verification;
    std::optional<Point> next;  // the next coarser one, which missed or which there was no time to verify
  };
  Coarsened coarsened(Contest& contest, Point point, Verification verification, double until);
  void coarsen();
  void certify();
  void tighten();
  std::optional<Point> tighter(double share, const std::vector<const Family*>& able, double until,
                               double bound = INFINITY);

  const Problem& problem_;
  const Wish& wish_;
  const Search& search_;
  const std::vector<Family>& all_ = families();
  // What is quick to search comes first: it bounds what the rest may cost.
  std::vector<std::size_t> quick_, exact_, rest_;
  const double most_of_one_ = search_.most / 20;
  // What may be spent by the end of each stage.
  const double by_search_ = 0.4 * search_.most, by_verification_ = 0.5 * search_.most,
               by_dearer_ = 0.55 * search_.most, by_robust_ = 0.75 * search_.most, by_finer_ = 0.95 * search_.most;
  Truths truths_;
  std::vector<Candidate> found_{all_.size()};                   // by method
  std::vector<char> settled_ = std::vector<char>(all_.size());  // of which the answer is known
  std::vector<Problem> first_starts_{problem_};
  Contest contest_{.wish = wish_};
  Draws draws_;
  std::vector<Candidate> kept_;  // what keeps the wish from all starts, by cost
  double cheapest_yet_ = INFINITY;
  int starts_ = 0;  // of each verification
  Choice choice_;
};

/// The scene's own start and others whose true motions can judge a run of its wish.
void Choosing::begin(Contest& contest) const {
  for (const Problem& start : first_starts_)
    if (contest.starts.empty() || well_known(start, contest.wish)) contest.starts.push_back(start);
  contest.added_from = contest.starts.size();
}

/// All of these methods that have not reached the wish yet, at a cost of at most `most` a frame, until `until`
/// instructions are spent.
void Choosing::look(std::vector<std::size_t> which, double most, double until) {
  std::erase_if(which, [&](std::size_t at) {
    return found_[at].reached || found_[at].point.outcome == Outcome::refused || settled_[at];
  });
  const double bound = std::min(most, worth * cheapest_yet_),
               each = std::min(most_of_one_, share(until, which.size()));
  std::vector<Spent> spent(which.size());
  search_.side_by_side(static_cast<int>(which.size()), [&](int i) {
    const std::size_t at = which[static_cast<std::size_t>(i)];
    search_.told(all_[at].name);
    Spent& own = spent[static_cast<std::size_t>(i)];
    const Candidate now = wish_.limits.empty() ? most_accurate(problem_, all_[at], wish_, own)
                                               : found_by(contest_, all_[at],
                                                          std::min(bound, budget_of(wish_, all_[at])), each, own);
    // A search that may take little comes less near than one before.
    if (!found_[at].point.family || now.point.outcome == Outcome::refused || preferred(now, found_[at], wish_))
      found_[at] = now;
  });
  for (const Spent& one : spent) choice_.spent += one;
  for (const std::size_t at : which)
    if (found_[at].reached) cheapest_yet_ = std::min(cheapest_yet_, found_[at].point.cost);
}

/// All methods at what is little dearer than the cheapest yet.
void Choosing::look_at_all(double until) {
  look(quick_, INFINITY, until), look(exact_, INFINITY, until);
  if (work() <= search_.enough) look(rest_, INFINITY, until);
}

/// Dearer ways are tried where no cheaper one does. Methods that solve exactly have few choices, so that their
/// search goes on when that of all others has cost enough.
void Choosing::search_all() {
  const double rows = std::max(1, problem_.start().degrees_of_freedom());
  double level = wish_.limits.empty() ? INFINITY : 1000 * rows * choice_.limit.substeps;
  for (;; level *= 2.5) {
    choice_.spent.cut = false;
    look(quick_, level, by_search_), look(exact_, level, by_search_);
    const bool all_of_them = work() <= search_.enough;
    if (all_of_them) look(rest_, level, by_search_);
    const bool spent_all = std::all_of(all_.begin(), all_.end(),
                                       [&](const Family& family) { return level >= budget_of(wish_, family); });
    if (all_of_them) choice_.searched = spent_all ? INFINITY : level;
    // A run at this cost is more than one method may take: a search that was not cut would find no more with more.
    const bool dear = level * screening(problem_) / frame > 2.5 * most_of_one_;
    choice_.at_its_bound = work() > 0.9 * by_search_ || (dear && choice_.spent.cut);
    // Until none is left out that costs little more than the cheapest.
    if (level >= worth * cheapest_yet_ || spent_all || dear || choice_.at_its_bound || level > hopeless ||
        work() > 3 * search_.enough)
      break;
  }
  choice_.searched_exactly = std::max(level, choice_.searched);
  starts_ = std::isfinite(cheapest_yet_) ? count_of_starts(problem_, wish_, cheapest_yet_, search_) : 0;
  contest_.verified_from = first_numbers(starts_), contest_.next = starts_;
}

Candidate Choosing::found_by(Contest& contest, const Family& family, double bound, double most,
                             Spent& spent) const {
  return cheapest(contest.starts, family, contest.wish, bound, &spent, most,
                  &contest.known[static_cast<std::size_t>(&family - all_.data())]);
}

/// A candidate with so few more substeps, from `first` to `last` sixteenths more, that it keeps all of the
/// contest's starts over the whole time.
Candidate Choosing::with_more_substeps(const Contest& contest, const Candidate& candidate, int first, int last,
                                       double until) {
  const Wish& wish = contest.wish;
  const Family& family = *candidate.point.family;
  const double budget = budget_of(wish, family);
  Candidate more = candidate;
  more.reached = false;
  const int from = candidate.point.knobs.substeps;
  const auto kept = [&](const Problem& start) {
    const double cost = candidate.point.cost * more.point.knobs.substeps / from;
    if (work() + whole_work(problem_, cost) > until) return false;
    more.point = whole(start, family, more.point.knobs);
    more.excess = wish.limits.empty() ? more.point[Error::drift] : excess(more.point, wish.limits);
    return more.point.outcome == Outcome::good && (wish.limits.empty() || more.excess <= 1) &&
           more.point.cost <= budget;
  };
  for (int parts = first; parts <= last && !more.reached && more.point.cost <= budget; parts *= 2) {
    more.point.knobs.substeps = std::max(more.point.knobs.substeps + 1, from + from * parts / 16);
    more.reached = std::all_of(contest.starts.rbegin(), contest.starts.rend(), kept);  // the scene's own last
  }
  return more;
}

/// The same method's cheapest that also keeps the starts that were added since. A search watches a part of a run,
/// so that it may not see why its candidate missed one: then that with more substeps, for half as much again. One
/// that has missed often keeps its starts by luck, and needs steps that are shorter by far.
Candidate Choosing::found_again(Contest& contest, const Candidate& candidate, int misses, double until) {
  const Family& family = *candidate.point.family;
  if (!contest.wish.limits.empty() && misses <= most_searches) {
    const double bound = std::min(10 * candidate.point.cost, budget_of(contest.wish, family));
    const Candidate found = found_by(contest, family, bound, until - work(), choice_.spent);
    if (found.reached && found.point.cost > candidate.point.cost) return found;
  }
  return with_more_substeps(contest, candidate, 1 << std::clamp(misses - most_searches, 0, 5), 128,
                            std::max(until, work() + most_of_one_ / 2));
}

/// A run from each start of the verification until one fails. Where true motions leave it few starts, what can be
/// judged without them is from the rest.
Choosing::Counted Choosing::counted(Contest& contest, const Point& point) {
  const auto run_from = [&](const std::vector<int>& numbers, const Wish& wish) {
    const auto result =
        verify(variations(problem_, numbers, seed_of_verifications), point, wish, search_.side_by_side, true);
    const int runs = result.starts + static_cast<int>(result.unknown.size());
    choice_.spent += {runs, runs * whole_work(problem_, point.cost)};
    work() +=
        asks_for_reference(wish.limits) ? truths_.work(seed_of_verifications, std::span(numbers).first(runs)) : 0;
    return result;
  };
  Verification verification = run_from(contest.verified_from, contest.wish);
  while (verification.kept() && !verification.unknown.empty() && contest.left_out < starts_) {
    for (const int place : verification.unknown) contest.verified_from[place] = contest.next++;
    contest.left_out += static_cast<int>(verification.unknown.size());
    verification = run_from(contest.verified_from, contest.wish);
  }
  verification.left_out = contest.left_out;
  if (!verification.kept())
    return {verification, contest.verified_from[static_cast<std::size_t>(verification.worst)]};
  const Wish rest = without_reference(contest.wish);
  const int further_starts = count_of_starts(problem_, rest, point.cost, search_) - starts_;
  if (rest.limits.size() == contest.wish.limits.size() || rest.limits.empty() || further_starts <= 0)
    return {verification, {}};
  std::vector<int> numbers(static_cast<std::size_t>(further_starts));
  std::iota(numbers.begin(), numbers.end(), contest.next);
  const Verification further = run_from(numbers, rest);
  if (!further.kept()) return {further, numbers[static_cast<std::size_t>(further.worst)]};
  verification.further = further.starts;
  verification.excess = std::max(verification.excess, further.excess);
  return {verification, {}};
}

/// Whether it keeps the wish from the starts, too, that others have missed: these are verified from no more, and a
/// search that was before does not know them.
bool Choosing::keeps_added(const Contest& contest, const Point& point) {
  return std::all_of(contest.starts.begin() + static_cast<long>(contest.added_from), contest.starts.end(),
                     [&](const Problem& start) {
                       return excess(whole(start, *point.family, point.knobs), contest.wish.limits) <= 1;
                     });
}

/// Holds the search against this start of the verification, too, in which another takes its place.
void Choosing::add(Contest& contest, int missed) {
  contest.starts.push_back(problem_.variation(missed, seed_of_verifications));
  work() += truths_.work(seed_of_verifications, std::array{missed});
  contest.next = std::max(contest.next, missed + 1);
  std::ranges::replace(contest.verified_from, missed, contest.next++);
}

/// The verification of what keeps the contest's wish from all starts; none of what misses it, whose start is
/// added.
std::optional<Verification> Choosing::kept_from_all(Contest& contest, const Point& point) {
  const auto [verification, missed] = counted(contest, point);
  if (missed) add(contest, *missed);
  if (missed || !keeps_added(contest, point)) return {};
  return verification;
}

/// Of candidates that reach the wish the cheapest that keep it from all starts over the whole time, by their
/// costs: as many as are wanted, and as are paid for until `until` instructions are spent, the first one until
/// `until_first`. One that does not is looked for again, and so takes its place further back. `choice_.verified`
/// becomes that of the first.
std::vector<Candidate> Choosing::verified(Contest& contest, std::vector<Candidate>& found, std::size_t wanted,
                                          double until, double until_first) {
  std::vector<Candidate> kept;
  int misses = 0;
  while (kept.size() < wanted) {
    Candidate* next = nullptr;
    for (Candidate& candidate : found)
      if (candidate.reached && (!next || preferred(candidate, *next, contest.wish))) next = &candidate;
    if (!next) break;
    const double end = kept.empty() ? std::max(until, until_first) : until;
    if (work() > end || misses > most_misses) {
      choice_.at_its_bound = choice_.at_its_bound || kept.empty();
      break;
    }
    if (const auto verification = kept_from_all(contest, next->point)) {
      if (kept.empty()) choice_.verified = *verification;
      kept.push_back(*next);
      next->reached = false;
      continue;
    }
    if (work() > end - most_of_one_) misses = std::max(misses, most_searches);  // no time for another search
    *next = found_again(contest, *next, ++misses, work() + most_of_one_);
  }
  return kept;
}

/// What keeps the wish; and where that is dearer than what was found, what was left out as too dear beside it.
std::vector<Candidate> Choosing::verified_with_dearer() {
  std::vector<Candidate> kept = verified(contest_, found_, most_answers, by_verification_, by_robust_);
  if (wish_.limits.empty() || starts_ == 0) return kept;
  // Nothing yet: up to ten times as dear, and so on.
  double dear = cheapest_yet_;
  while (kept.empty() && work() < by_robust_ && dear < hopeless) {
    cheapest_yet_ = dear *= 10;
    look_at_all(by_robust_);
    kept = verified(contest_, found_, most_answers, by_robust_, by_robust_);
  }
  choice_.at_its_bound = choice_.at_its_bound || (kept.empty() && dear < hopeless);
  if (kept.empty() || work() >= by_verification_ || kept.front().point.cost <= 1.05 * cheapest_yet_) return kept;
  for (const Candidate& one : kept) settled_[static_cast<std::size_t>(one.point.family - all_.data())] = 1;
  cheapest_yet_ = kept.front().point.cost / worth;
  look_at_all(by_verification_);
  const Verification of_first = choice_.verified;
  const std::vector<Candidate> more = verified(contest_, found_, most_answers, by_dearer_, by_dearer_);
  if (more.empty() || !preferred(more.front(), kept.front(), wish_)) choice_.verified = of_first;
  kept.insert(kept.end(), more.begin(), more.end());
  std::stable_sort(kept.begin(), kept.end(),
                   [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish_); });
  if (kept.size() > most_answers) kept.resize(most_answers);
  return kept;
}

/// What came nearest, of the methods that solve their rows exactly and of all others, with steps that are shorter
/// by far: no search has looked for these, as one ends where it found what keeps its own few starts, or where its
/// runs cost too much.
std::vector<Candidate> Choosing::verified_with_shorter_steps() {
  std::array<std::optional<Candidate>, 2> nearest;
  for (const Candidate& one : found_) {
    if (one.point.outcome != Outcome::good || !one.point.family) continue;
    std::optional<Candidate>& of_its_kind = nearest[one.point.family->exact];
    if (!of_its_kind || one.excess < of_its_kind->excess) of_its_kind = one;
  }
  for (std::optional<Candidate>& one : nearest)
    while (one && work() < by_finer_) {
      *one = with_more_substeps(contest_, *one, 16, 1024, by_finer_);
      if (!one->reached) break;
      starts_ = count_of_starts(problem_, wish_, one->point.cost, search_);
      if (work() + starts_ * whole_work(problem_, one->point.cost) > search_.most) break;
      contest_.verified_from = first_numbers(starts_), contest_.next = std::max(contest_.next, starts_);
      if (const auto verification = kept_from_all(contest_, one->point)) {
        choice_.verified = *verification;
        return {*one};
      }
    }
  return {};
}

/// The cheapest that keeps the wish, or what comes nearest.
void Choosing::recommend() {
  choice_.reached = !kept_.empty();
  choice_.best = choice_.reached ? kept_.front() : nearest();
  if (!choice_.reached) return;
  choice_.best.point = with_all_errors(*choice_.best.point.family, choice_.best.point.knobs);
  choice_.runners_up.assign(kept_.begin() + 1, kept_.end());
}

/// Of each method's best runs so far from the scene's own start, over the whole time: the best.
Candidate Choosing::nearest() {
  Candidate nearest = *std::min_element(found_.begin(), found_.end(), [&](const Candidate& a, const Candidate& b) {
    return preferred(a, b, wish_);
  });
  // One that ended early met its errors sooner.
  const auto rank = [&](const Point& point) { return excess(point, wish_.limits) / point.seconds; };
  const auto before = [&](const Point& a, const Point& b) { return rank(a) < rank(b); };
  std::vector<Point> watched;  // in part
  if (nearest.point.outcome == Outcome::good) watched.push_back(nearest.point);
  for (const std::vector<Known>& known : contest_.known) {
    if (known.empty()) continue;
    std::vector<Point> own;
    for (const auto& [knobs, point] : known.front()) own.push_back(point);
    std::ranges::sort(own, before);
    own.resize(std::min<std::size_t>(own.size(), 3));
    watched.insert(watched.end(), own.begin(), own.end());
  }
  std::ranges::sort(watched, before);
  nearest.excess = INFINITY, nearest.reached = false;
  const auto least = std::ranges::min_element(watched, {}, &Point::cost);
  for (const Point& one : watched) {
    if (&one != &*least && work() + whole_work(problem_, one.cost) > search_.most) continue;
    const Point point = whole(problem_, *one.family, one.knobs);
    const Candidate now{false, point, excess(point, wish_.limits)};
    if (preferred(now, nearest, wish_)) nearest = now;
  }
  return nearest;
}

/// What held from the scene's own start, and what cannot run it or failed.
void Choosing::tell_others() {
  std::stable_sort(found_.begin(), found_.end(),
                   [&](const Candidate& a, const Candidate& b) { return preferred(a, b, wish_); });
  for (const Candidate& candidate : found_) {
    const auto is_it = [&](const Candidate& one) { return one.point.family == candidate.point.family; };
    if (is_it(choice_.best) || std::any_of(kept_.begin(), kept_.end(), is_it)) continue;
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

/// Recommends another, and the one before as a runner-up.
void Choosing::take(const Point& best, const Verification& verification) {
  std::erase_if(choice_.runners_up, [&](const Candidate& one) { return one.point.family == best.family; });
  if (best.family != choice_.best.point.family)
    choice_.runners_up.insert(choice_.runners_up.begin(), choice_.best);
  choice_.best = {true, best, excess(best, wish_.limits)};
  choice_.verified = verification;
}

/// What keeps the contest's wish from all starts at less than `bound` a frame, among choices drawn at random, half
/// of them near `from` and near what was recommended or found before.
std::optional<std::pair<Candidate, Verification>> Choosing::drawn(Contest& contest, const Point& from,
                                                                  double bound) {
  constexpr int rounds = 1000, draws = 128;
  if (contest.wish.limits.empty()) return {};
  std::vector<const Family*> methods;
  for (const Candidate& one : found_)
    if (one.point.family && one.point.outcome != Outcome::refused) methods.push_back(one.point.family);
  std::vector<Point> near{from, choice_.best.point};
  for (const Candidate& one : kept_) near.push_back(one.point);
  std::optional<std::pair<Candidate, Verification>> best;
  const double left = by_finer_ - work(),
               until = work() + std::min(std::max(100 * whole_work(problem_, from.cost), search_.enough / 10),
                                         std::max(search_.most / 20, left / 10));
  for (int round = 0; round < rounds && work() < until; ++round) {
    const Candidate now = cheapest_drawn(draws_, contest.starts, contest.wish, near, bound, methods, draws,
                                         until - work(), choice_.spent, search_.side_by_side);
    if (!now.reached) continue;
    near.push_back(now.point);
    if (const auto verification = kept_from_all(contest, now.point))
      best = {now, *verification}, bound = now.point.cost;
  }
  return best;
}

/// With fewer substeps, as long as that keeps the contest's wish from all starts.
Choosing::Coarsened Choosing::coarsened(Contest& contest, Point point, Verification verification, double until) {
  const auto& limits = contest.wish.limits;
  while (point.knobs.substeps > 1) {
    Knobs fewer = point.knobs;
    fewer.substeps = std::max(1, std::min(fewer.substeps - 1, fewer.substeps * 9 / 10));
    const Point next = with_all_errors(*point.family, fewer);
    if (limits.empty() || !(excess(next, limits) <= 1) || work() > until) return {point, verification, next};
    const auto [of_next, missed] = counted(contest, next);
    if (missed || !keeps_added(contest, next)) return {point, verification, next};
    point = next, verification = of_next;
  }
  return {point, verification, {}};
}

void Choosing::coarsen() {
  const auto [point, verification, next] =
      coarsened(contest_, choice_.best.point, choice_.verified, std::max(by_dearer_, work() + most_of_one_ / 2));
  choice_.best.point = point;
  if (!wish_.limits.empty()) choice_.best.excess = excess(point, wish_.limits);
  choice_.verified = verification;
  choice_.coarser = next;
}

/// Among many choices some keep by luck the starts that they are held against. So what is recommended is run from
/// as many others, after the scene's own, and where it misses one, what takes its place is run from others again.
void Choosing::certify() {
  constexpr int most_tries = 5;
  for (int tries = 1; choice_.verified.certified(); ++tries) {
    contest_.verified_from.assign(certain + 1, 0);
    std::iota(contest_.verified_from.begin() + 1, contest_.verified_from.end(), contest_.next);
    contest_.next += certain;
    if (const auto verification = kept_from_all(contest_, choice_.best.point)) {
      choice_.verified = *verification;
      return;
    }
    Candidate next;
    if (tries < most_tries) next = found_again(contest_, choice_.best, tries, work() + most_of_one_);
    const auto other = std::ranges::find(choice_.runners_up, true, &Candidate::reached);
    if (other != choice_.runners_up.end() && (!next.reached || preferred(*other, next, wish_))) {
      next = *other;
      choice_.runners_up.erase(other);
    }
    choice_.reached = next.reached, choice_.coarser = {};
    if (!next.reached) return;
    const Point best = with_all_errors(*next.point.family, next.point.knobs);
    choice_.best = {true, best, excess(best, wish_.limits)};
  }
}

/// Half and a tenth of the limits, by what keeps the wish and by the methods whose search is quick: what is exact
/// costs no more for less.
void Choosing::tighten() {
  std::vector<const Family*> able;
  for (const Candidate& one : kept_) able.push_back(one.point.family);
  for (const std::size_t at : quick_)
    if (std::find(able.begin(), able.end(), &all_[at]) == able.end()) able.push_back(&all_[at]);
  std::vector<const Family*> others;
  for (const Candidate& one : found_)
    if (one.point.family && one.point.outcome != Outcome::refused &&
        std::find(able.begin(), able.end(), one.point.family) == able.end())
      others.push_back(one.point.family);
  // Of what is left half is for all others, where they are a good deal cheaper.
  const auto either = [&](double part, double foreseen) {
    const double until = std::max(foreseen, work() + 2 * most_of_one_);
    const auto first = tighter(part, able, 0.5 * (until + work()));
    const auto other =
        others.empty() ? std::nullopt : tighter(part, others, until, first ? first->cost / 1.2 : INFINITY);
    return other && !(first && first->cost <= other->cost) ? other : first;
  };
  choice_.robust = either(0.5, by_robust_);
  choice_.finer = either(0.1, by_finer_);
  if (choice_.finer && (!choice_.robust || choice_.finer->cost < choice_.robust->cost))
    choice_.robust = choice_.finer;
}

/// The cheapest of these methods that keeps that share of the limits, at a cost of at most `bound`.
std::optional<Point> Choosing::tighter(double part, const std::vector<const Family*>& able, double until,
                                       double bound) {
  Contest tight{.wish = wish_, .verified_from = first_numbers(starts_), .next = starts_};
  for (auto& [error, limit] : tight.wish.limits) limit *= part;
  begin(tight);
  tight.wish.budget = nullptr;
  if (choice_.verified.excess <= part) return choice_.best.point;  // from the starts that it was verified from
  if (work() > until || !well_known(problem_, tight.wish)) return {};
  // What keeps the wish may also keep this with steps that are short enough; a search looks for what is cheaper.
  Candidate shorter;
  for (const Candidate& one : kept_)
    if (!shorter.reached && std::ranges::find(able, one.point.family) != able.end())
      shorter = with_more_substeps(tight, one, 8, 1024, std::min(until, work() + most_of_one_));
  if (shorter.reached) bound = std::min(bound, shorter.point.cost);
  std::vector<Candidate> again(able.size());
  // A search that is allowed much takes long, and finds nothing cheaper than one that found something.
  for (const double times : {4.0, 100.0}) {
    std::vector<Spent> spent(able.size());
    const double each = share(until, able.size());
    search_.side_by_side(static_cast<int>(able.size()), [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      again[at] = found_by(tight, *able[at], std::min(bound, times * choice_.best.point.cost), each, spent[at]);
    });
    for (const Spent& one : spent) choice_.spent += one;
    if (times * choice_.best.point.cost >= bound ||
        std::any_of(again.begin(), again.end(), [](const Candidate& one) { return one.reached; }))
      break;
  }
  again.push_back(shorter);
  const Verification of_best = choice_.verified;
  auto best = verified(tight, again, 1, until, by_robust_);
  Verification of_tight = std::exchange(choice_.verified, of_best);
  if (std::ranges::find(able, choice_.best.point.family) != able.end())
    if (const auto cheaper = drawn(tight, best.empty() ? choice_.best.point : best.front().point,
                                   best.empty() ? bound : best.front().point.cost))
      best = {cheaper->first}, of_tight = cheaper->second;
  if (best.empty()) return {};
  const Point found = with_all_errors(*best.front().point.family, best.front().point.knobs);
  auto [point, verification, next] = coarsened(tight, found, of_tight, work() + most_of_one_ / 2);
  choice_.left_out = std::max(choice_.left_out, verification.left_out);
  if (point.cost < choice_.best.point.cost && point.cost <= budget_of(wish_, *point.family)) {
    // It keeps the wish itself for less, which its search had missed.
    verification.excess *= part;
    take(point, verification);
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
