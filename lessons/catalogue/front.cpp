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

double cost_to_reach(std::span<const Point> front, Error error, double wanted, Cost cost) {
  const Point* finer = nullptr;
  for (const Point& point : front) {
    if (point[error] <= wanted) {
      finer = &point;
      continue;
    }
    if (!finer) return INFINITY;
    // An error of rounding would stretch the line over decades in which there are no runs.
    const double fine = std::max((*finer)[error], wanted / 100);
    const double share = std::log(point[error] / wanted) / std::log(point[error] / fine);
    return cost_of(point, cost) * std::pow(cost_of(*finer, cost) / cost_of(point, cost), share);
  }
  return finer ? cost_of(*finer, cost) : INFINITY;
}

std::optional<Order> fitted_order(std::span<const Point> points, Error error) {
  constexpr double rounding = 1e-12, line = 0.1;
  std::vector<std::pair<double, double>> all;  // log h, log error; from the finest
  for (const Point& point : points)
    if (point.has(error) && point[error] > rounding)
      all.emplace_back(-std::log(static_cast<double>(point.knobs.substeps)), std::log(point[error]));
  std::sort(all.begin(), all.end());
  const auto fit = [&](std::size_t count) {
    double x = 0, y = 0, xx = 0, xy = 0, scatter = 0;
    for (std::size_t i = 0; i < count; ++i) x += all[i].first, y += all[i].second;
    const double n = static_cast<double>(count);
    x /= n, y /= n;
    for (std::size_t i = 0; i < count; ++i)
      xx += std::pow(all[i].first - x, 2), xy += (all[i].first - x) * (all[i].second - y);
    const double slope = xy / xx;
    for (std::size_t i = 0; i < count; ++i) scatter += std::pow(all[i].second - y - slope * (all[i].first - x), 2);
    constexpr double student[] = {12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31};  // by degrees of freedom
    const double t = student[std::min<std::size_t>(count - 3, std::size(student) - 1)];
    return std::pair{Order{slope, t * std::sqrt(scatter / (n - 2) / xx)}, std::sqrt(scatter / n)};
  };
  std::optional<Order> order;
  for (std::size_t count = 3; count <= all.size(); ++count) {
    const auto [fitted, scatter] = fit(count);
    if (scatter > line) break;
    order = fitted;
  }
  return order;
}

}  // namespace byhand
