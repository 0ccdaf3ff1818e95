#pragma once

#include <map>
#include <span>
#include <vector>

#include "lessons/catalogue/front.hpp"

// Fair tuning: at every point the best of all choices, for the error that is asked about. The laws say where to
// begin; from there the search goes wherever it gains, and ends where no step of any knob gains 5 %.
namespace byhand {

/// All runs of one family on one problem, each made once.
class Runs {
 public:
  Runs(Problem problem, const Family& family, Watch watch = {})
      : problem_(std::move(problem)), family_(&family), watch_(watch) {}

  const Problem& problem() const { return problem_; }
  const Family& family() const { return *family_; }
  Watch& watch() { return watch_; }
  /// The run with these choices.
  const Point& at(const Knobs& knobs);
  std::vector<Point> points() const;
  /// How long a run is watched [s].
  double seconds() const { return watch_.seconds > 0 ? watch_.seconds : problem_.scene().duration; }
  int count() const { return static_cast<int>(known_.size()); }
  /// The counted cost of all runs.
  double work() const { return work_; }

 private:
  Problem problem_;
  const Family* family_;
  Watch watch_;
  std::map<Knobs, Point> known_;
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
