#include "lessons/practise/judge/probe.hpp"

#include <cmath>

namespace byhand::practise {
namespace {

/// The same on every system, unlike the standard's distributions.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

}  // namespace

double Probe::drawn(double least, double most) {
  double value = 1;
  while (std::abs(std::abs(value) - 1) < 0.05 || std::abs(value) < 0.05 * most)
    value = least + (most - least) * uniform(random_);
  return value;
}

Numbers Probe::given(const std::string& name, const std::string& unit, Numbers values) {
  if (const auto found = set_.find(name); found != set_.end()) values = found->second;
  sheet_.push_back({Line::Kind::given, name, unit, values});
  for (double& value : values) value *= 1 + share_ * (2 * uniform(shaking_) - 1);
  return values;
}

double Probe::number(const std::string& name, const std::string& unit, double least, double most) {
  return given(name, unit, {drawn(least, most)})[0];
}

Vec2 Probe::vector(const std::string& name, const std::string& unit, double size) {
  const double x = drawn(-size, size), y = drawn(-size, size);
  const Numbers values = given(name, unit, {x, y});
  return {values[0], values[1]};
}

BodyRow Probe::row(const std::string& name, double size) {
  BodyRow J;
  J.l1 = vector(name + ".l1", "m", size);
  J.a1 = number(name + ".a1", "m²", -size, size);
  J.l2 = vector(name + ".l2", "m", size);
  J.a2 = number(name + ".a2", "m²", -size, size);
  return J;
}

Velocities Probe::velocities(const std::string& name, double size) {
  Velocities V;
  V.v1 = vector(name + ".v1", "m/s", size);
  V.w1 = number(name + ".w1", "rad/s", -size, size);
  V.v2 = vector(name + ".v2", "m/s", size);
  V.w2 = number(name + ".w2", "rad/s", -size, size);
  return V;
}

InverseMasses Probe::inverse_masses() {
  InverseMasses W;
  W.m1 = 1 / number("m1", "kg", 0.3, 5);
  W.I1 = 1 / number("I1", "kg m²", 0.1, 3);
  W.m2 = 1 / number("m2", "kg", 0.3, 5);
  W.I2 = 1 / number("I2", "kg m²", 0.1, 3);
  return W;
}

}  // namespace byhand::practise
