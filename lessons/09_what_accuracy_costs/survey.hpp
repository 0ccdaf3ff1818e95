#pragma once

#include <initializer_list>
#include <string_view>

#include "lessons/09_what_accuracy_costs/setting.hpp"
#include "lessons/catalogue/front.hpp"

// All ways to go about a scene, each tuned at every point, and drawn as a work–precision chart.
namespace byhand::accuracy {

/// What the surveys of swinging scenes watch, and up to which cost a frame.
inline const std::vector<Error> swing_errors{Error::drift, Error::trajectory, Error::energy, Error::reaction},
    spin_errors{Error::drift, Error::trajectory, Error::energy, Error::momentum, Error::reaction};
inline constexpr double swing_most = 2.5e5;

/// The runs of all families on one problem.
struct Survey {
  Problem problem;
  std::vector<Error> watched;
  std::vector<std::vector<byhand::Point>> runs;  // by family

  /// Every run.
  std::vector<byhand::Point> points() const;
  /// The best that one family can do: its lower envelope over all choices, for this error.
  std::vector<byhand::Point> front(const Family& family, Error error) const;
};

/// Runs all families on the problem, each tuned for each error that is watched, up to a cost of `most` a frame and
/// about `runs` runs a family. Kept: a problem that two steps look at is measured once.
const Survey& survey(const course::Page& page, const Problem& problem, std::vector<Error> watched, double most,
                     int runs = 300);

/// Initial conditions from which what was tuned on the scene's own is run again, and which share of them has to
/// keep an error.
inline constexpr int starts = 20;
inline constexpr double kept_share = 0.95;

/// Whether the error of this run's choices stays below `at_most` from 95 % of twenty initial conditions, none of
/// them the one on which they were tuned. A run that fails has missed it.
bool kept(const course::Page& page, const Survey& survey, const byhand::Point& point, Error error, double at_most);
/// The cheapest run of one family whose error stays below `at_most` from 95 % of them; none if none does.
std::optional<byhand::Point> best(const course::Page& page, const Survey& survey, const Family& family,
                                  Error error, double at_most);

/// "the 7 methods without contacts (step 1a)".
std::string without_contacts();

/// "chain: links = 50, end_mass = 100 kg, …".
std::string description(const Problem& problem);
/// The same for a chart, where _ would lower a letter: with spaces.
std::string title_of(const Problem& problem);

/// Error against cost on logarithmic axes: at most seven methods, those on the front and the article's own, by the
/// errors that 95 % of twenty initial conditions keep (fewer where these runs would take long), and the others
/// pale. Its CSV file has all runs. `explained`: how to read the curves, in the caption.
void show(course::Page& page, const std::string& name, const Survey& survey, Error error, bool explained = false);
/// The charts of several errors, each named "prefix_error".
void show(course::Page& page, const std::string& prefix, const Survey& survey,
          std::initializer_list<Error> errors);

/// Runs with these choices at 1, 2, 4 … substeps.
std::vector<byhand::Point> refined(const Problem& problem, std::string_view family, Knobs knobs, int last);
/// Claims that the trajectory of the direct solve with substeps is of order 1, from what `source` says.
void claim_first_order(course::Page& page, const Problem& problem, const std::string& source = "symplectic Euler");

/// How the runs of each family ended, as a list; those that refuse the problem with the reason.
std::string failures(const Survey& survey);

/// What the cheapest run of any of these families costs whose error stays below `at_most` from 95 % of the initial
/// conditions; infinite if there is none.
double least_cost(const course::Page& page, const Survey& survey, Error error, double at_most,
                  const std::vector<std::string_view>& families);

}  // namespace byhand::accuracy
