#pragma once

#include <map>
#include <span>
#include <vector>

#include "lessons/catalogue/front.hpp"

// Fair tuning: at every point the best of all choices, for the error that is asked about. The laws say where to
// begin; from there the search goes wherever it gains, and ends where no step of any knob gains 5 %.
namespace byhand {

/// Runs by their choices.
using Known = std::map<Knobs, Point>;

/// All runs of one family on one problem, each made once. `earlier` are those of another search of the same with
/// the same watch but for its `most`: what they tell is not run again, and what is run is added to them.
class Runs {
 public:
  Runs(Problem problem, const Family& family, Watch watch = {}, Known* earlier = nullptr)
      : problem_(std::move(problem)), family_(&family), watch_(watch), earlier_(earlier) {}

  const Problem& problem() const { return problem_; }
  const Family& family() const { return *family_; }
  Watch& watch() { return watch_; }
  /// The run with these choices.
  const Point& at(const Knobs& knobs);
  std::vector<Point> points() const;
  /// How long a run is watched [s].
  double seconds() const { return watch_.seconds > 0 ? watch_.seconds : problem_.scene().duration; }
  int count() const { return static_cast<int>(known_.size()); }
  /// Those that were not known from earlier.
  int made() const { return made_; }
  /// The counted cost of all runs.
  double work() const { return work_; }

 private:
  Problem problem_;
  const Family* family_;
  Watch watch_;
  Known* earlier_;
  Known known_;
  int made_ = 0;
  double work_ = 0;
};

/// The same choices within what the laws and the method allow: β by laws 1 and 6.
Knobs within_laws(const Problem& problem, const Family& family, Knobs knobs);

/// Where the laws let a method with these passes and this cure begin.
Knobs first_knobs(const Problem& problem, const Family& family, Cure cure, int passes);

/// One step of each knob to either side, and each other cure.
std::vector<Knobs> neighbours(const Problem& problem, const Family& family, const Knobs& knobs);

/// Runs neighbours of the points on the front of each error until no step moves it by 5 %, or `most` runs are
/// made.
void explore(Runs& runs, std::span<const Error> watched, int most);

}  // namespace byhand
