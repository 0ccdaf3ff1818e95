#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/09_what_accuracy_costs/catalogue/work_precision.hpp"
#include "lessons/tutor/page.hpp"
#include "renderer/chart.hpp"

// All ways to go about a scene, measured, and drawn as a work–precision chart.
namespace byhand::accuracy {

/// What one configuration does on one problem: its runs by rising knob, at the tuning that is best there.
struct Series {
  const Configuration* configuration = nullptr;
  double tuning = 0;
  std::vector<byhand::Point> points;
};

/// What all of them do.
struct Survey {
  Problem problem;
  Error tuned_for;
  std::vector<Series> series;

  /// Every run.
  std::vector<byhand::Point> points() const;
  /// The series of that configuration; none if the solver has no such configuration.
  const Series* find(std::string_view configuration) const;
};

/// Runs all configurations on the problem, side by side; each with the tuning that has the least of `tuned_for`,
/// and each knob as far as a run costs `most` row-solves. Kept: a problem that two steps look at is measured once.
const Survey& survey(const tutor::Page& page, const Problem& problem, Error tuned_for, double most = 1e7);

/// "chain: links = 50, end_mass = 100 kg, …".
std::string description(const Problem& problem);
/// The same for a chart, where _ would lower a letter: with spaces.
std::string title_of(const Problem& problem);

/// Error against cost in row-solves, log–log: a curve a configuration with its tuning and its fitted order in the
/// legend, the knob at the points, failures at the edge, and the front of those that no other beats.
renderer::Chart work_precision(const Survey& survey, Error error, Cost cost = Cost::row_solves);

/// The chart, with a caption that names the reference and its uncertainty.
void show(tutor::Page& page, const std::string& name, const Survey& survey, Error error);

/// The same against wall time, measured when it is wanted.
void show_clocked(tutor::Page& page, const std::string& name, const Survey& survey, Error error);

/// The charts of several errors, each named "prefix_error".
void show(tutor::Page& page, const std::string& prefix, const Survey& survey, std::initializer_list<Error> errors);

/// Claims that the trajectory of the direct solve with substeps is of order 1, from what `source` says.
void claim_first_order(tutor::Page& page, const std::string& scene, const Survey& survey,
                       const std::string& source = "symplectic Euler");

/// What cannot run the problem or fails, at which knobs, and why, as a list; empty if all goes well.
std::string failures(const Survey& survey);

/// The least cost [row-solves a frame] at which any configuration that `counts` has at most that error, along the
/// straight line on logarithmic axes between the two knobs on either side of it; infinite if none has.
double least_cost(const Survey& survey, Error error, double at_most,
                  const std::function<bool(const Configuration&)>& counts);

}  // namespace byhand::accuracy
