#pragma once

#include <cmath>
#include <span>

// What an exercise's code works with: plain structs of doubles, in SI units, in the plane.
namespace plain {

struct Vec2 {
  double x = 0, y = 0;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
inline Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
inline Vec2 operator*(Vec2 a, double s) { return s * a; }
inline Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
inline Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
inline Vec2& operator-=(Vec2& a, Vec2 b) { return a = a - b; }
inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// The z component of a × b.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// ω × r for a turn about z.
inline Vec2 cross(double w, Vec2 r) { return {-w * r.y, w * r.x}; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// J of a constraint between two particles: C changes at the rate l1·v1 + l2·v2.
struct ParticleRow {
  Vec2 l1, l2;
};

/// J of (6), between two bodies that turn.
struct BodyRow {
  Vec2 l1;
  double a1 = 0;
  Vec2 l2;
  double a2 = 0;
};

/// V of (7): velocities [m/s] and rates of turn [rad/s].
struct Velocities {
  Vec2 v1;
  double w1 = 0;
  Vec2 v2;
  double w2 = 0;
};

/// The diagonal of (18): 1/m [1/kg] and 1/I [1/(kg m²)] of both bodies.
struct InverseMasses {
  double m1 = 0, I1 = 0, m2 = 0, I2 = 0;
};

inline double dot(const ParticleRow& J, Vec2 v1, Vec2 v2) { return dot(J.l1, v1) + dot(J.l2, v2); }
/// JV of (8).
inline double dot(const BodyRow& J, const Velocities& V) {
  return dot(J.l1, V.v1) + J.a1 * V.w1 + dot(J.l2, V.v2) + J.a2 * V.w2;
}
inline BodyRow operator*(double s, const BodyRow& J) { return {s * J.l1, s * J.a1, s * J.l2, s * J.a2}; }
inline Velocities& operator+=(Velocities& V, const BodyRow& change) {
  V.v1 += change.l1;
  V.w1 += change.a1;
  V.v2 += change.l2;
  V.w2 += change.a2;
  return V;
}

/// Time step [s] where a task gives no other.
inline constexpr double time_step = 1.0 / 60;

/// What a stub says instead of an answer.
[[noreturn]] void not_written_yet();

}  // namespace plain

using namespace plain;
