#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>

// Rotations that advance by + − × ÷ and square roots alone: libm's sine is not the same on every processor.
// Every function takes any scalar with `.value()` (Eigen::AutoDiffScalar, also nested) besides double, and
// branches on the value only where both sides have the same derivatives.
namespace byhand {

template <class T>
struct SinCos {
  T sin, cos;
};

namespace detail {

inline constexpr double quarter_pi = 0x1.921fb54442d18p-1;

inline double value_of(double x) { return x; }
template <class T>
double value_of(const T& x) {
  return value_of(x.value());
}

/// c0 + c1·z + … + c5·z⁵ by Estrin's scheme, whose three independent pairs halve Horner's latency.
template <class T>
T quintic(const T& z, const double (&c)[6]) {
  const T z2 = z * z;
  const T low = c[1] * z + c[0], middle = c[3] * z + c[2], high = c[5] * z + c[4];
  return low + z2 * (middle + z2 * high);
}

// Minimax coefficients for |x| <= π/4, z = x², from fdlibm's k_sin.c and k_cos.c (Sun Microsystems, 1993).

/// (sin(x)/x − 1)/z
template <class T>
T sine_tail(const T& z) {
  return quintic<T>(z, {-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
                        2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10});
}

/// (cos(x) − 1 + z/2)/z²
template <class T>
T cosine_tail(const T& z) {
  return quintic<T>(z, {4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                        -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11});
}

/// 1 − z/2 + rest; what is lost when 1 − z/2 is rounded goes back in with the small terms.
template <class T>
T one_minus(const T& half_z, const T& rest) {
  const T rounded = 1.0 - half_z;
  return rounded + (((1.0 - rounded) - half_z) + rest);
}

/// Sine and cosine of x + low for |x| <= π/4; `low` is what x was too short to hold.
template <class T>
SinCos<T> sin_cos_within_quarter_pi(const T& x, double low) {
  const T z = x * x, half_z = 0.5 * z;
  return {x + (z * x * sine_tail<T>(z) + low * (1.0 - half_z)),
          one_minus<T>(half_z, z * z * cosine_tail<T>(z) - x * low)};
}

}  // namespace detail

/// Sine and cosine of `angle` [rad], to 1 ulp for |angle| <= 1e5; far beyond, the reduction runs out of digits.
template <class T>
SinCos<T> sin_cos(const T& angle) {
  const double value = detail::value_of(angle);
  if (std::abs(value) <= detail::quarter_pi) return detail::sin_cos_within_quarter_pi<T>(angle, 0.0);

  // Cody and Waite: π/2 in three parts, the first two of 33 bits so that their multiples are exact. Adding
  // 1.5·2^52 rounds to a whole number and leaves it, modulo 4, in the last two bits.
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1, to_whole = 0x1.8p52;
  constexpr double high = 0x1.921fb544p+0, middle = 0x1.0b4611a6p-34, low = 0x1.3198a2e037073p-69;
  const double shifted = value * two_over_pi + to_whole, quarters = shifted - to_whole;
  const T first = angle - quarters * high, second = first - quarters * middle;
  const double lost = ((detail::value_of(first) - detail::value_of(second)) - quarters * middle) - quarters * low;
  const T reduced = second + lost;
  const double rest = (detail::value_of(second) - detail::value_of(reduced)) + lost;

  SinCos<T> at = detail::sin_cos_within_quarter_pi<T>(reduced, rest);
  switch (std::bit_cast<std::uint64_t>(shifted) & 3) {
    case 0: return at;
    case 1: return {at.cos, -at.sin};
    case 2: return {-at.sin, -at.cos};
    default: return {-at.cos, at.sin};
  }
}

/// A rotation in the plane: the unit complex number cos + i sin.
template <class T = double>
struct PlaneRotation {
  T cos = T(1), sin = T(0);
};
static_assert(sizeof(PlaneRotation<>) == 16);

/// The rotation by `angle` [rad].
template <class T>
PlaneRotation<T> plane_rotation(const T& angle) {
  const SinCos<T> at = sin_cos<T>(angle);
  return {at.cos, at.sin};
}

/// First `b`, then `a` (in the plane the order does not matter).
template <class T>
PlaneRotation<T> operator*(const PlaneRotation<T>& a, const PlaneRotation<T>& b) {
  return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}

/// The rotation that undoes `r`.
template <class T>
PlaneRotation<T> inverse(const PlaneRotation<T>& r) {
  return {r.cos, -r.sin};
}

/// `r` turned on by `angle` [rad]. One Newton step for 1/|r| holds |r| = 1 to rounding, over any number of
/// turns.
template <class T>
PlaneRotation<T> rotated_by(const PlaneRotation<T>& r, const T& angle) {
  const PlaneRotation<T> turned = plane_rotation<T>(angle) * r;
  const T to_unit = 1.5 - 0.5 * (turned.cos * turned.cos + turned.sin * turned.sin);
  return {turned.cos * to_unit, turned.sin * to_unit};
}

/// The vector `v`, given in the body's axes, in the world's.
template <class T, class Vector>
Eigen::Matrix<T, 2, 1> rotate(const PlaneRotation<T>& r, const Eigen::MatrixBase<Vector>& v) {
  const auto& u = v.eval();
  return {r.cos * u.x() - r.sin * u.y(), r.sin * u.x() + r.cos * u.y()};
}

/// The angle of `r` in (−π, π] [rad]. Measures only: it is libm's.
inline double angle(const PlaneRotation<>& r) { return std::atan2(r.sin, r.cos); }

static_assert(sizeof(Eigen::Quaterniond) == 32);

/// exp(turn/2) as a unit quaternion: the rotation by |turn| [rad] about `turn`.
template <class T>
Eigen::Quaternion<T> space_rotation(const Eigen::Matrix<T, 3, 1>& turn) {
  const Eigen::Matrix<T, 3, 1> half = turn * T(0.5);
  const T z = half.x() * half.x() + half.y() * half.y() + half.z() * half.z();
  T cos, sine_over_angle;
  if (detail::value_of(z) <= detail::quarter_pi * detail::quarter_pi) {
    // Both are series in the squared angle, so that no square root spoils the derivatives of a turn by zero.
    cos = detail::one_minus<T>(0.5 * z, z * z * detail::cosine_tail<T>(z));
    sine_over_angle = 1.0 + z * detail::sine_tail<T>(z);
  } else {
    using std::sqrt;
    const T half_angle = sqrt(z);
    const SinCos<T> at = sin_cos<T>(half_angle);
    cos = at.cos;
    sine_over_angle = at.sin / half_angle;
  }
  return {cos, sine_over_angle * half.x(), sine_over_angle * half.y(), sine_over_angle * half.z()};
}

/// The rotation that undoes the unit quaternion `q`.
template <class T>
Eigen::Quaternion<T> inverse(const Eigen::Quaternion<T>& q) {
  return q.conjugate();
}

/// `q` turned on by `turn` = ω·h [rad], a vector in the world's axes; |q| = 1 is held as in the plane.
template <class T>
Eigen::Quaternion<T> rotated_by(const Eigen::Quaternion<T>& q, const Eigen::Matrix<T, 3, 1>& turn) {
  Eigen::Quaternion<T> turned = space_rotation<T>(turn) * q;
  const T to_unit = 1.5 - 0.5 * turned.squaredNorm();
  turned.coeffs() *= to_unit;
  return turned;
}

/// The vector `v`, given in the body's axes, in the world's: v + 2w (q × v) + q × 2(q × v). Inlined by force, for
/// every arm of every row is turned by it.
template <class T, class Vector>
[[gnu::always_inline]] inline Eigen::Matrix<T, 3, 1> rotate(const Eigen::Quaternion<T>& q,
                                                            const Eigen::MatrixBase<Vector>& v) {
  const Eigen::Matrix<T, 3, 1>& u = v.template cast<T>();
  const T x = q.x(), y = q.y(), z = q.z(), w = q.w();
  const T a = y * u.z() - z * u.y(), b = z * u.x() - x * u.z(), c = x * u.y() - y * u.x();
  const T p = a + a, r = b + b, s = c + c;
  return {u.x() + w * p + (y * s - z * r), u.y() + w * r + (z * p - x * s), u.z() + w * s + (x * r - y * p)};
}

}  // namespace byhand
