#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/09_what_accuracy_costs/catalogue/catalogue.hpp"

// Error against cost: atlas of methods, each run over the same scene with one knob swept.
namespace byhand {

/// What a run gets wrong, kept apart.
enum class Error {
  drift,       // largest separation of a joint or overlap over the run
  trajectory,  // largest distance of any centre from the reference at scene().time
  energy,      // largest change over the run, by the scene's energy scale
  momentum,    // largest change of the angular momentum about the vertical over the run, by what it was
  reaction,    // of what holds the scene, mean over the last frame before scene().time, by the larger of it and
               // weight
  algebraic,   // of one step at scene().time, against the direct solve
};
inline constexpr std::array errors{Error::drift,    Error::trajectory, Error::energy,
                                   Error::momentum, Error::reaction,   Error::algebraic};
inline constexpr int error_count = static_cast<int>(errors.size());

/// "drift" and so on, and its unit.
std::string_view name_of(Error error);
std::string_view unit_of(Error error);
/// The error of that name. Throws std::invalid_argument for another.
Error error_named(std::string_view name);

/// A method with all its choices, and into how many steps of it a frame is cut.
struct Setting {
  Method method;
  int steps = 1;
};

/// One way to go about a scene, with a knob that buys accuracy.
struct Configuration {
  std::string name;             // "direct, substeps"
  std::string knob;             // "substeps", "sweeps", "steps"
  std::vector<int> values;      // of the knob, ascending
  std::string tuning;           // what is chosen best for each scene, "β"; empty where there is nothing
  std::vector<double> tunings;  // at least one
  bool defaults = false;        // what people leave as it comes
  bool shortens_step = true;    // whether the knob divides the time step, so that an order can be fitted
  std::function<Setting(int knob, double tuning)> setting;
};

/// All ways that the solver knows.
const std::vector<Configuration>& configurations();
/// Throws std::invalid_argument for a name that is none of them.
const Configuration& configuration_named(std::string_view name);

enum class Outcome { finished, refused, failed };

/// One run: what it got wrong and what it cost. A run that fails is a point too.
struct Point {
  const Configuration* configuration = nullptr;
  int knob = 0;
  double tuning = 0;
  Outcome outcome = Outcome::finished;
  std::string reason;                                 // why refused or failed, in one sentence
  std::array<double, error_count> error = nothing();  // NaN where it is not defined
  double row_solves = NAN;                            // a frame
  double nanoseconds = NAN;                           // a frame, where it was timed

  double operator[](Error which) const { return error[static_cast<int>(which)]; }
  /// Whether it ran to its end and has that error.
  bool has(Error which) const { return outcome == Outcome::finished && std::isfinite((*this)[which]); }
  /// "direct, substeps = 16, β = 1".
  std::string described() const;

 private:
  static std::array<double, error_count> nothing() {
    std::array<double, error_count> all;
    all.fill(NAN);
    return all;
  }
};

struct Watch {
  bool algebraic = false;  // needs one more step, solved densely
  // Where only this matters a run ends as soon as it is over the limit, with the error that it had then.
  Error over = Error::drift;
  double limit = std::numeric_limits<double>::infinity();
};

/// Runs the problem so, from its beginning to its duration. Deterministic; throws nothing that a method throws.
Point measure(const Problem& problem, const Configuration& configuration, int knob, double tuning,
              const Watch& watch = {});

/// The tuning with the least of that error at the middle of the knob's values, among runs that finish.
double best_tuning(const Problem& problem, const Configuration& configuration, Error error);

/// Median wall time of a frame [ns] over at least `seconds` of wall time, once warm; from the scene's beginning,
/// over and over. Only meaningful while nothing else runs.
double nanoseconds_a_frame(const Problem& problem, const Setting& setting, double seconds = 0.05);

enum class Cost { row_solves, wall_time };
double cost_of(const Point& point, Cost cost);

/// The points that no other beats in both, by rising error. Of points alike in both the first stays.
std::vector<Point> pareto_front(std::span<const Point> points, Error error, Cost cost);

/// The slope of log error over log step, as the median between neighbours of one configuration; NaN where there
/// are fewer than two points above rounding (1e-12), or the knob does not shorten the step.
double fitted_order(std::span<const Point> points, Error error);

}  // namespace byhand
