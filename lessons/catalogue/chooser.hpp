#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lessons/catalogue/limits.hpp"
#include "lessons/catalogue/verification.hpp"

// Which method is the cheapest that is accurate enough here? The laws leave out what cannot do it; the rest is
// run.
namespace byhand {

inline constexpr double finest_drift = 1e-9;  // [m]: less is rounding, and no more told apart

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
  int left_out = 0;           // starts left out of theirs: the true motion is not known well enough for so little
  double margin = NAN;        // see `margin`
  Spent spent;                // on all of it
  bool at_its_bound = false;  // whether the search ended because it had taken what it may
  double searched = 0;        // up to which cost a frame all methods were tried; infinite: within the budget
  double searched_exactly = 0;  // and those that solve each step exactly, and XPBD
};

/// Whether two answers are the same method in the same setting.
inline bool same_setting(const Point& a, const Point& b) { return a.family == b.family && a.knobs == b.knobs; }

struct Search {
  std::function<void(const std::string&)> told = [](const std::string&) {};  // of each method as it begins
  SideBySide side_by_side = one_after_another;
  int starts = certain;        // initial conditions of the verification
  double verification = 3e10;  // instructions of one, beyond which it takes fewer
  bool tighter = true;         // whether half and a tenth of the limits are looked for, too
  double enough = 2e10;  // instructions after which only methods that solve each step exactly are tried further
  // Instructions that it may take; then it shows what it has found. Four tenths are for the search among all
  // methods, and of one method for a twentieth.
  double most = std::numeric_limits<double>::infinity();
  bool all_errors = true;  // whether the answer's errors are measured that nobody asked for, too
};

/// Throws std::invalid_argument unless the wish has a limit or a budget, all above zero, and only errors that this
/// scene has.
Choice choose(const Problem& problem, const Wish& wish, const Search& search = {});

}  // namespace byhand
