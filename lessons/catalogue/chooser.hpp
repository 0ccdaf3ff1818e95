#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lessons/catalogue/front.hpp"
#include "lessons/catalogue/limits.hpp"
#include "lessons/catalogue/tuning.hpp"

// Which method is the cheapest that is accurate enough here? The laws leave out what cannot do it; the rest is
// run.
namespace byhand {

/// What is wanted: errors of at most so much at the least cost, or the least error at a cost of at most so much,
/// or both.
struct Wish {
  std::map<Error, double> limits = {};  // in the unit of each error
  // Instructions a frame that a method may take: a time allows each its own, by its own pace. Without limits the
  // least drift within it is looked for.
  std::function<double(const Family&)> budget = nullptr;
};
/// The same for every method.
inline std::function<double(const Family&)> at_most(double instructions) {
  return [=](const Family&) { return instructions; };
}

/// One method at its best.
struct Candidate {
  bool reached = false;
  Point point;               // the cheapest that reaches the wish, or what comes nearest
  double excess = INFINITY;  // the largest error over its limit
};

inline constexpr double finest_drift = 1e-9;  // [m]: less is rounding, and no more told apart

/// As many starts have to keep a wish, all of them, before more than 95 % of such starts do with 95 % confidence:
/// 0.95⁵⁹ < 0.05.
inline constexpr int certain = 59;

/// A run from each of several initial conditions.
struct Verification {
  int starts = 0, good = 0, within = 0;  // did their duty; had errors within the limits, too
  double seconds = 0;                    // of each
  double excess = 0;                     // the largest error of those over its limit; infinite where one failed
  int worst = 0;                         // the start from which it was so
  std::string first_failure = {};        // "a joint opened …"; empty if all are good

  bool kept() const { return within == starts; }
  bool certified() const { return kept() && starts >= certain; }
};

/// What a search takes: runs, and their counted cost.
struct Spent {
  int runs = 0;
  double work = 0;

  Spent& operator+=(const Spent& other) {
    runs += other.runs;
    work += other.work;
    return *this;
  }
};

struct Choice {
  bool reached = false;
  Candidate best;                     // what is recommended; where nothing reaches the wish, what comes nearest
  Verification verified;              // of what is recommended, and of each other that is said to reach the wish
  LawLimit limit;                     // what the laws say
  std::vector<Candidate> runners_up;  // other methods: those that keep the wish from as many starts, by their
                                      // costs, then what held from the scene's own start
  std::vector<Point> passed;          // what cannot run this scene or failed, one point a method
  std::optional<Point> coarser;       // the next coarser choice of the same method that was tried, and missed
  // The cheapest that keep half and a tenth of each limit from as many starts; `best` where that does.
  std::optional<Point> robust, finer;
  double margin = NAN;          // see `margin`
  Spent spent;                  // on all of it
  bool at_its_bound = false;    // whether the search ended because it had taken what it may
  double searched = 0;          // up to which cost a frame all methods were tried; infinite: within the budget
  double searched_exactly = 0;  // and those that solve each step exactly, and XPBD
};

struct Search {
  std::function<void(const std::string&)> told = [](const std::string&) {};  // of each method as it begins
  /// Calls work(0) … work(count - 1), each once.
  std::function<void(int count, const std::function<void(int)>& work)> side_by_side =
      [](int count, const std::function<void(int)>& work) {
        for (int i = 0; i < count; ++i) work(i);
      };
  int starts = certain;        // initial conditions of the verification
  double verification = 3e10;  // instructions of one, beyond which it takes fewer
  bool tighter = true;         // whether half and a tenth of the limits are looked for, too
  double enough = 2e10;  // instructions after which only methods that solve each step exactly are tried further
  // Instructions that it may take; then it shows what it has found. Half are for the search among all methods, and
  // of one method for a twentieth.
  double most = std::numeric_limits<double>::infinity();
  bool all_errors = true;  // whether the answer's errors are measured that nobody asked for, too
};

/// Throws std::invalid_argument unless the wish has a limit or a budget, all above zero, and only errors that this
/// scene has.
Choice choose(const Problem& problem, const Wish& wish, const Search& search = {});

/// The largest error over its limit, of a trajectory with what is not known of the true one; infinite unless the
/// run did its duty and has all these errors.
double excess(const Point& point, const std::map<Error, double>& limits);

/// Runs a point's choices from other initial conditions, the scene's own first. `until_one_fails` leaves the rest.
Verification verify(const Problem& problem, const Point& point, const Wish& wish, int starts,
                    const Search& search = {}, int seed = 1, bool until_one_fails = false);

/// The factor on the scene's stress parameter, at least 1 and within 5 %, at which this point's method no longer
/// keeps within the limits; infinite if it does at the parameter's upper end and up to a thousand, NaN if the
/// parameter is not above zero, or this takes more than `most` instructions.
double margin(const Problem& problem, const Point& point, const std::map<Error, double>& limits,
              Spent* spent = nullptr, double most = std::numeric_limits<double>::infinity());

/// The cheapest run of one method within the limits that costs at most `bound`, or what came nearest until `most`
/// instructions were spent. `known` are runs of earlier searches with the same limits.
Candidate cheapest(const Problem& problem, const Family& family, const Wish& wish, double bound,
                   Spent* spent = nullptr, double most = std::numeric_limits<double>::infinity(),
                   Known* known = nullptr);

}  // namespace byhand
