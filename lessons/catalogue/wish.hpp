#pragma once

#include <functional>
#include <map>

#include "lessons/catalogue/run.hpp"

// What is wanted of a method on a scene, and how near a run comes to it.
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

/// What a method may cost a frame [instructions].
double budget_of(const Wish& wish, const Family& family);

/// Throws std::invalid_argument unless the wish has a limit or a budget, all above zero, and only errors that this
/// scene has.
void require_valid(const Problem& problem, const Wish& wish);

/// Whether what is known of the true motion is needed, which may take longer to find out than all runs.
bool asks_for_reference(const std::map<Error, double>& limits);

/// Instructions that the true motion from another start takes, if it is needed, at most as far as is known.
double work_of_truth(const Problem& problem, const std::map<Error, double>& limits);

/// The wish with only those limits that can be judged without it.
Wish without_reference(Wish wish);

/// The largest error over its limit, of a trajectory with what is not known of the true one; infinite unless the
/// run did its duty and has all these errors.
double excess(const Point& point, const std::map<Error, double>& limits);

/// Whether a true motion that is known to so much [m] can judge a run: to a quarter of the trajectory's limit.
bool well_known(double uncertainty, const std::map<Error, double>& limits);

/// A run from beginning to end, with what the wish asks about, or with all errors.
Point whole_run(const Problem& problem, const Family& family, const Knobs& knobs, const Wish& wish,
                bool all_errors = false);

/// How long a run of a search is watched [s], at least until errors are compared: what stands only by chance is
/// found out by the verification.
double screening(const Problem& problem);

/// One method at its best.
struct Candidate {
  bool reached = false;
  Point point;               // the cheapest that reaches the wish, or what comes nearest
  double excess = INFINITY;  // the largest error over its limit
};

/// The cheaper of two that reach a wish; without limits the more accurate.
bool preferred(const Candidate& a, const Candidate& b, const Wish& wish);

/// What a search takes: runs, and their counted cost.
struct Spent {
  int runs = 0;
  double work = 0;
  bool cut = false;  // whether it ended because a run or all of them cost more than was allowed

  Spent& operator+=(const Spent& other) {
    runs += other.runs;
    work += other.work;
    cut = cut || other.cut;
    return *this;
  }
};

}  // namespace byhand
