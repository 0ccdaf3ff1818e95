#pragma once

#include <array>
#include <string_view>

#include "lessons/catalogue/any_scene.hpp"

// What a run costs, in instructions of the processor, so that it is the same whatever else runs. What a method
// executes is counted where it is done, and each count has a price: what it takes in instructions as callgrind
// counts them, with g++ 12.2 -O3 on x86-64.
namespace byhand {

/// Instructions that one of each count of an Effort takes.
struct Prices {
  double row_solve = 0, laid_out_row = 0, solve = 0, pass = 0, prepared_row = 0, projected_row = 0,
         written_row = 0, body = 0, contact = 0, substep = 0, step = 0, planned = 0, computed_pair = 0;
};
Prices operator+(const Prices& a, const Prices& b);

/// The counts of an Effort, in the order of Prices.
using Counts = std::array<double, sizeof(Prices) / sizeof(double)>;
Counts counts_of(const Effort& effort);

/// Of a part of a step: a family of methods by its name, for those that solve rows "stepping" besides, and a cure
/// by its name; "free" of what nothing holds. Nothing for a part that has no price. Measured by
/// tests/lessons/catalogue/prices.cpp.
Prices prices_of(std::string_view kind, std::string_view part);

/// Instructions.
double cost_of(const Counts& counts, const Prices& prices);
inline double cost_of(const Effort& effort, const Prices& prices) { return cost_of(counts_of(effort), prices); }

}  // namespace byhand
