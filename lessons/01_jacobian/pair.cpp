#include "lessons/01_jacobian/pair.hpp"

namespace byhand::lesson01 {
namespace {

using Vector = Linear<PlaneBody>;

/// ω × r in the plane.
Vector turning(double spin, const Vector& r) { return spin * Vector(-r.y(), r.x()); }

/// An upper bound of |d| within `time`: the arms may turn by anything.
double longest(const Pair& pair, double time) {
  return pair.d().norm() + (pair.V2 - pair.V1).head<2>().norm() * time + 2 * (pair.r1().norm() + pair.r2().norm());
}

}  // namespace

Pair Pair::after(double time) const {
  Pair later = *this;
  later.pose1 = moved<PlaneBody, double>(pose1, V1, time);
  later.pose2 = moved<PlaneBody, double>(pose2, V2, time);
  return later;
}

double Pair::second_rate() const {
  // d̈ of d = P2 - P1: only the turning arms accelerate, towards the centres.
  const Vector velocity = V2.head<2>() + turning(V2[2], r2()) - V1.head<2>() - turning(V1[2], r1());
  const Vector acceleration = V1[2] * V1[2] * r1() - V2[2] * V2[2] * r2();
  return velocity.squaredNorm() + d().dot(acceleration);
}

double Pair::third_rate_bound(double time) const {
  const double w1 = std::abs(V1[2]), w2 = std::abs(V2[2]), a1 = r1().norm(), a2 = r2().norm();
  const double velocity = (V2 - V1).head<2>().norm() + w1 * a1 + w2 * a2;
  const double acceleration = w1 * w1 * a1 + w2 * w2 * a2, jerk = w1 * w1 * w1 * a1 + w2 * w2 * w2 * a2;
  return longest(*this, time) * jerk + 3 * velocity * acceleration;
}

Vector box_sides(const Settings& set) { return set.length * Vector(0.6, 0.4); }

Pair pair_of(const Settings& set) {
  const double length = set.length, speed = set.speed, spin = set.spin;
  const Vector corner = 0.5 * box_sides(set);
  Pair pair;
  pair.rod = {{0, 1, {Vector(corner.x(), corner.y()), Vector(-corner.x(), corner.y())}}, length};
  pair.pose1.rotation = plane_rotation(-0.4);
  pair.pose2.rotation = plane_rotation(0.5);
  const Vector d = (length + set.stretch) * Vector(0.96, 0.28);
  pair.pose2.position = pair.r1() + d - pair.r2();
  pair.V1 = {0.2 * speed, 0.1 * speed, -0.7 * spin};
  pair.V2 = {0.6 * speed, -0.4 * speed, spin};
  return pair;
}

double fastest(const Settings& set) {
  return 0.73 * set.speed() + std::abs(set.spin()) * box_sides(set).norm() / 2;
}

double watched(const Settings& set) {
  return std::min(set.length / set.speed, 4 / std::max(std::abs(set.spin()), 1e-3));
}

double difference(const Pair& pair, double step) {
  return (pair.after(step).value() - pair.after(-step).value()) / (2 * step);
}

double difference_tolerance(const Pair& pair, double step) {
  return step * step / 6 * pair.third_rate_bound(step) + rounding(pair, step) / step;
}

double rounding(const Pair& pair, double time) {
  // About ten operations, each within half a unit in the last place of numbers no larger than these.
  const double away = std::max(pair.pose1.position.norm(), pair.pose2.position.norm()) +
                      std::max(pair.V1.head<2>().norm(), pair.V2.head<2>().norm()) * time;
  const double size = longest(pair, time);
  return 10 * std::numeric_limits<double>::epsilon() * size * (size + away);
}

}  // namespace byhand::lesson01
