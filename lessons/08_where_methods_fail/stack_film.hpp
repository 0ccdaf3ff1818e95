#pragma once

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::failures {

/// What outcomes are called in maps of stacks.
inline const OutcomeNames stack_outcomes{"stands", "leans", "rings", "has fallen", "no solution"};

/// A kicked stack and how it is solved.
struct SolvedStack {
  std::string name;
  VelocityStepping method;
};
/// Stacks of unit boxes, shown `hurry` times as fast as they are; their gauge is how far the top box is off.
Film<PlaneBody> film_of_stacks(int boxes, const std::vector<SolvedStack>& stacks, double hurry);

}  // namespace byhand::failures
