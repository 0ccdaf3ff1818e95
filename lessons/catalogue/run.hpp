#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "lessons/catalogue/methods.hpp"

// One run of a problem: whether it did what the scene has to do, what it got wrong, and what it cost.
namespace byhand {

/// What a run gets wrong, kept apart.
enum class Error {
  drift,       // largest separation of a joint or overlap over the run
  trajectory,  // largest distance of any centre from the reference at compared_at()
  energy,      // largest change over the run, by the scene's energy scale
  momentum,    // largest change of the angular momentum about the vertical over the run, by what it was
  reaction,    // of what holds the scene, mean over the last frame before compared_at(), by the larger of it and
               // weight
  contact,     // residual of complementarity and friction cone at compared_at()
  algebraic,   // of one step at compared_at(), against the direct solve
};
inline constexpr std::array errors{Error::drift,    Error::trajectory, Error::energy,   Error::momentum,
                                   Error::reaction, Error::contact,    Error::algebraic};
inline constexpr int error_count = static_cast<int>(errors.size());

/// "drift" and so on, and its unit.
std::string_view name_of(Error error);
std::string_view unit_of(Error error);
/// The error of that name. Throws std::invalid_argument for another.
Error error_named(std::string_view name);
/// Whether the scene has that error: a block that slides has no energy to keep.
bool has(const NamedScene& scene, Error error);
/// Whether it is the difference from the true motion, so that this has to be known.
constexpr bool needs_truth(Error error) { return error == Error::trajectory || error == Error::reaction; }

/// How a run ends. Only of one that is good an error counts.
enum class Outcome {
  good,         // it stood, held or slid as it had to
  refused,      // the method cannot run this scene
  opened,       // a joint came apart, or a block sank in, by more than a tenth of a body
  fell,         // a box left its place by more than half a box
  strayed,      // the block was more than half its length from where it should be, or the energy was another
  blew_up,      // energy beyond a hundred times its scale, or no number
  no_solution,  // a step had none
  too_slow,     // it cost more than was allowed
};
/// "stood", "held", "slid"; "fell" and so on.
std::string_view name_of(Outcome outcome, Duty duty);

/// One run. A run that fails is a point too.
struct Point {
  const Family* family = nullptr;
  Knobs knobs;
  Outcome outcome = Outcome::good;
  std::string reason;                                 // of a failure, in one sentence
  std::array<double, error_count> error = nothing();  // NaN where it is not defined
  double seconds = 0;                                 // that it was watched, or until it failed
  double row_solves = NAN;                            // a frame
  double cost = NAN;                                  // a frame, see cost.hpp
  double nanoseconds = NAN;                           // a frame, where it was timed
  double uncertainty = 0;                             // of the true motion that the trajectory is held against [m]

  double operator[](Error which) const { return error[static_cast<int>(which)]; }
  /// Whether it did its duty and has that error.
  bool has(Error which) const { return outcome == Outcome::good && std::isfinite((*this)[which]); }
  /// "Gauss–Seidel, 4 substeps, 2 sweeps, β = 0.05".
  std::string described() const;

 private:
  static std::array<double, error_count> nothing() {
    std::array<double, error_count> all;
    all.fill(NAN);
    return all;
  }
};

/// The counted cost of a whole run.
inline double work_of(const Point& point) {
  return std::isfinite(point.cost) ? point.cost * point.seconds / frame : 0;
}

struct Watch {
  double seconds = 0;                                     // how long; 0: the scene's duration
  bool reference = true;                                  // whether trajectory and reaction are wanted
  bool algebraic = false;                                 // needs one more step, solved densely
  double most = std::numeric_limits<double>::infinity();  // cost a frame, beyond which the run is too slow
  // A run ends as soon as an error is over its limit, with the errors that it had then.
  std::array<double, error_count> limit = everything();

 private:
  static std::array<double, error_count> everything() {
    std::array<double, error_count> all;
    all.fill(std::numeric_limits<double>::infinity());
    return all;
  }
};

/// Runs the problem so, from its beginning. Deterministic; throws nothing that a method throws.
Point measure(const Problem& problem, const Family& family, const Knobs& knobs, const Watch& watch = {});

/// Wall time of a frame, the mean of a run as for the cost [ns]: the median of as many runs as begin within
/// `seconds` of wall time. Of a run that takes more than eight times as long only what that leaves is timed. Only
/// meaningful while nothing else runs.
double nanoseconds_a_frame(const Problem& problem, const Setting& setting, double seconds = 0.05);

}  // namespace byhand
