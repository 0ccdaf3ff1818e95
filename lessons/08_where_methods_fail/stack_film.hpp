#pragma once

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::failures {

/// A kicked stack and how it is solved.
struct SolvedStack {
  std::string name;
  VelocityStepping method;
};
/// Stacks of unit boxes, shown `hurry` times as fast as they are; their gauge is how far the top box is off.
Film<PlaneBody> film_of_stacks(int boxes, const std::vector<SolvedStack>& stacks, double hurry);

}  // namespace byhand::failures
