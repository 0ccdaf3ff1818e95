#pragma once

#include <optional>

#include "lessons/09_what_accuracy_costs/catalogue/work_precision.hpp"

// Which method is the cheapest that is accurate enough here? Asked of runs, not of opinions.
namespace byhand {

/// What is wanted: an error of at most so much at the least cost, or the least error at a cost of at most so much.
struct Wish {
  Error error = Error::drift;
  double accuracy = NAN;  // in the unit of the error; or
  double budget = NAN;    // a frame: row-solves or [ns]
  Cost cost = Cost::row_solves;
};

struct Choice {
  bool reached = false;
  Point best;                     // what is recommended; where nothing reaches the wish, what comes nearest
  std::vector<Point> runners_up;  // the best of each other configuration, in the order of preference
  std::vector<Point> passed;      // what cannot run this scene or failed, one point a configuration
  std::optional<Point> finer;     // the cheapest of all with a tenth of the error; where accuracy is wanted
  // The factor on the scene's stress parameter at which what is recommended no longer reaches the accuracy, or
  // twice the error that it has within a budget; infinite if it does at a thousand and at the parameter's upper
  // end, NaN if the parameter is not above zero.
  double margin = NAN;
};

struct Search {
  // A configuration is left when it costs so many times the cheapest that reaches the wish, or when three
  // doublings of its knob have not brought the error down by a third.
  double give_up = 10;
  std::function<void(const std::string&)> told = [](const std::string&) {};  // of each configuration as it begins
};

/// Runs the configurations over the problem with their knobs doubled and then halved in between, and chooses. The
/// answer has been run, and points into `among`. With Cost::wall_time runs are also timed, one after the other.
/// Throws std::invalid_argument unless the wish names an accuracy or a budget, one of them and above zero, and an
/// error that this scene has.
Choice choose(const Problem& problem, const Wish& wish, const std::vector<Configuration>& among = configurations(),
              const Search& search = {});

/// The factor on the scene's stress parameter, at least 1 and within 5 %, at which this point's method stops to
/// keep the error within `limit`.
double margin(const Problem& problem, const Point& point, Error error, double limit);

}  // namespace byhand
