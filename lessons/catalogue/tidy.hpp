#pragma once

#include <span>
#include <string>

#include "lessons/catalogue/run.hpp"

// Runs as a table that any program reads: one row a run and error.
namespace byhand {

/// "links = 50, end_mass = 100 kg, …", all but gravity.
std::string described_parameters(const Problem& problem);

/// Names of the columns, with a line break.
std::string tidy_head();
/// One row for each of the errors of each point; one row without an error for a run that failed. `start` is the
/// number of the initial condition.
std::string tidy_rows(const Problem& problem, std::span<const Point> points, std::span<const Error> watched,
                      int start = 0);

}  // namespace byhand
