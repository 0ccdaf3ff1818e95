#include "lessons/catalogue/front.hpp"

#include <algorithm>

namespace byhand {

double cost_of(const Point& point, Cost cost) {
  return cost == Cost::counted ? point.cost : cost == Cost::row_solves ? point.row_solves : point.nanoseconds;
}

std::vector<Point> pareto_front(std::span<const Point> points, Error error, Cost cost) {
  std::vector<Point> sorted;
  for (const Point& point : points)
    if (point.has(error) && std::isfinite(cost_of(point, cost))) sorted.push_back(point);
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Point& a, const Point& b) {
    return a[error] != b[error] ? a[error] < b[error] : cost_of(a, cost) < cost_of(b, cost);
  });
  std::vector<Point> front;
  for (const Point& point : sorted)
    if (front.empty() || cost_of(point, cost) < cost_of(front.back(), cost)) front.push_back(point);
  return front;
}

namespace {

using LogPoint = std::pair<double, double>;  // log x, log y

struct Fit {
  Order order;
  double scatter;  // root of the mean square about the line
};

/// Least squares through at least three points.
Fit fitted(std::span<const LogPoint> points) {
  double x = 0, y = 0, xx = 0, xy = 0, squares = 0;
  for (const auto& [px, py] : points) x += px, y += py;
  const double n = static_cast<double>(points.size());
  x /= n, y /= n;
  for (const auto& [px, py] : points) xx += (px - x) * (px - x), xy += (px - x) * (py - y);
  const double slope = xy / xx;
  for (const auto& [px, py] : points) squares += std::pow(py - y - slope * (px - x), 2);
  constexpr double student[] = {12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31};  // by degrees of freedom
  const double t = student[std::min(points.size() - 3, std::size(student) - 1)];
  return {{slope, t * std::sqrt(squares / (n - 2) / xx)}, std::sqrt(squares / n)};
}

}  // namespace

std::optional<Order> fitted_power(std::span<const double> x, std::span<const double> y) {
  std::vector<LogPoint> all;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (y[i] > 0 && std::isfinite(y[i])) all.emplace_back(std::log(x[i]), std::log(y[i]));
  if (all.size() < 4) return {};
  return fitted(all).order;
}

std::optional<Order> fitted_order(std::span<const Point> points, Error error) {
  constexpr double rounding = 1e-12, line = 0.1;
  std::vector<LogPoint> all;  // from the finest
  for (const Point& point : points)
    if (point.has(error) && point[error] > rounding)
      all.emplace_back(-std::log(static_cast<double>(point.knobs.substeps)), std::log(point[error]));
  std::sort(all.begin(), all.end());
  std::optional<Order> order;
  for (std::size_t count = 3; count <= all.size(); ++count) {
    const Fit fit = fitted(std::span(all).first(count));
    if (fit.scatter > line) break;
    order = fit.order;
  }
  return order;
}

}  // namespace byhand
