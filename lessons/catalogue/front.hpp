#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "lessons/catalogue/run.hpp"

// What many runs say together.
namespace byhand {

enum class Cost { counted, row_solves, wall_time };
double cost_of(const Point& point, Cost cost);

/// The points that no other beats in both, by rising error. Of points alike in both the first stays.
std::vector<Point> pareto_front(std::span<const Point> points, Error error, Cost cost = Cost::counted);

/// The slope of a line through points on logarithmic axes, with its 95 % interval from the scatter about the line.
struct Order {
  double slope, uncertainty;
};
/// y grows as that power of x; none where fewer than four points are above zero and finite.
std::optional<Order> fitted_power(std::span<const double> x, std::span<const double> y);
/// Log error over log substep, of runs that differ in their substeps alone, from the three finest above rounding
/// (1e-12) on as many as lie on a line within a tenth; none where there are not three.
std::optional<Order> fitted_order(std::span<const Point> points, Error error);

}  // namespace byhand
