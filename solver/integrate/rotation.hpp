#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "solver/support/packed.hpp"

// Rotations and angles by + − × ÷ and square roots alone, because libm's sine differs between processors.
// Functions take double and any scalar with `.value()` (Jet, Eigen::AutoDiffScalar, also nested); they branch on
// the value only where both sides have the same derivatives. All polynomials are minimax approximations with
// coefficients from fdlibm (k_sin.c, k_cos.c, s_atan.c; Sun Microsystems, 1993).
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

/// c0 + c1·z + … + c5·z⁵ by Estrin's scheme, whose three independent pairs have half the latency of Horner's.
template <class T>
T quintic(const T& z, const double (&c)[6]) {
  const T z2 = z * z;
  const T low = c[1] * z + c[0], middle = c[3] * z + c[2], high = c[5] * z + c[4];
  return low + z2 * (middle + z2 * high);
}

/// (sin(x)/x − 1)/z, z = x², |x| <= π/4.
template <class T>
T sine_tail(const T& z) {
  return quintic<T>(z, {-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
                        2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10});
}
/// (cos(x) − 1 + z/2)/z², z = x², |x| <= π/4.
template <class T>
T cosine_tail(const T& z) {
  return quintic<T>(z, {4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                        -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11});
}
/// 1 − z/2 + rest; the rounding error of 1 − z/2 is added back with the small terms.
template <class T>
T one_minus(const T& half_z, const T& rest) {
  const T rounded = 1.0 - half_z;
  return rounded + (((1.0 - rounded) - half_z) + rest);
}

/// Sine and cosine of x + low for |x| <= π/4; `low` is the rounding error of x.
template <class T>
SinCos<T> sin_cos_within_quarter_pi(const T& x, double low) {
  const T z = x * x, half_z = 0.5 * z;
  return {x + (z * x * sine_tail<T>(z) + low * (1.0 - half_z)),
          one_minus<T>(half_z, z * z * cosine_tail<T>(z) - x * low)};
}

/// Sine and cosine of half an angle in [−π, π], by the root without cancellation.
template <class T>
SinCos<T> half_of(const SinCos<T>& whole) {
  using std::sqrt;
  if (value_of(whole.cos) >= 0) {
    const T cos = sqrt(T(0.5 + 0.5 * whole.cos));
    return {T(0.5 * whole.sin / cos), cos};
  }
  const T size = sqrt(T(0.5 - 0.5 * whole.cos)), sin = value_of(whole.sin) < 0 ? T(-size) : size;
  return {sin, T(0.5 * whole.sin / sin)};
}

/// arctan(t) [rad] for |t| <= tan(π/8).
template <class T>
T arctangent(const T& t) {
  constexpr double c[] = {3.33333333333329318027e-01,  -1.99999999998764832476e-01, 1.42857142725034663711e-01,
                          -1.11111104054623557880e-01, 9.09088713343650656196e-02,  -7.69187620504482999495e-02,
                          6.66107313738753120669e-02,  -5.83357013379057348645e-02, 4.97687799461593236017e-02,
                          -3.65315727442169155270e-02, 1.62858201153657823623e-02};
  const T z = t * t;
  T sum = T(c[10]);
  for (int i = 9; i >= 0; --i) sum = T(c[i] + z * sum);
  return t - t * (z * sum);
}

}  // namespace detail

/// Sine and cosine of `angle` [rad], to 1 ulp for |angle| <= 1e5; far beyond, the range reduction loses accuracy.
template <class T>
SinCos<T> sin_cos(const T& angle) {
  const double value = detail::value_of(angle);
  if (std::abs(value) <= detail::quarter_pi) return detail::sin_cos_within_quarter_pi<T>(angle, 0.0);

  // Range reduction by Cody and Waite: π/2 in three parts, the first two of 33 bits so that their multiples are
  // exact. Adding 1.5·2^52 rounds to a whole number whose last two bits are the quadrant.
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

/// The rotation by `angle` [rad].
template <class T>
PlaneRotation<T> plane_rotation(const T& angle) {
  const SinCos<T> at = sin_cos<T>(angle);
  return {at.cos, at.sin};
}

template <class T>
PlaneRotation<T> operator*(const PlaneRotation<T>& a, const PlaneRotation<T>& b) {
  return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}
template <class T>
PlaneRotation<T> inverse(const PlaneRotation<T>& r) {
  return {r.cos, -r.sin};
}

/// `r` turned further by `angle` [rad]. One Newton step for 1/|r| keeps |r| = 1 to rounding, over any number of
/// steps.
template <class T>
PlaneRotation<T> rotated_by(const PlaneRotation<T>& r, const T& angle) {
  const PlaneRotation<T> turned = plane_rotation<T>(angle) * r;
  const T to_unit = 1.5 - 0.5 * (turned.cos * turned.cos + turned.sin * turned.sin);
  return {turned.cos * to_unit, turned.sin * to_unit};
}

/// The world-frame components of a body-frame vector.
template <class T, class Vector>
Packed<T, 2> rotate(const PlaneRotation<T>& r, const Eigen::MatrixBase<Vector>& v) {
  const auto& u = v.eval();
  return {r.cos * u.x() - r.sin * u.y(), r.sin * u.x() + r.cos * u.y()};
}

/// The angle of `r` in (−π, π] [rad] by libm: for measurements, not for state.
inline double angle(const PlaneRotation<>& r) { return std::atan2(r.sin, r.cos); }

/// exp(turn/2), the unit quaternion of the rotation by |turn| [rad] about `turn`.
template <class T>
Quaternion<T> space_rotation(const Packed<T, 3>& turn) {
  const Packed<T, 3> half = turn * T(0.5);
  const T z = half.x() * half.x() + half.y() * half.y() + half.z() * half.z();
  T cos, sine_over_angle;
  if (detail::value_of(z) <= detail::quarter_pi * detail::quarter_pi) {
    // Series in the squared angle: a square root has no derivatives at zero.
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

template <class Q>
Quaternion<typename Q::Scalar> inverse(const Eigen::QuaternionBase<Q>& q) {
  return q.conjugate();
}

/// `q` turned further by `turn` = ω·h [rad] in world axes; |q| = 1 is kept as in the plane.
template <class T, class Q>
Quaternion<T> rotated_by(const Eigen::QuaternionBase<Q>& q, const Packed<T, 3>& turn) {
  Quaternion<T> turned = space_rotation<T>(turn) * q;
  turned.coeffs() *= T(1.5 - 0.5 * turned.squaredNorm());
  return turned;
}

/// The world-frame components of a body-frame vector: v + 2w (q × v) + q × 2(q × v). Always inlined: it rotates
/// every arm of every row.
template <class Q, class Vector, class T = typename Q::Scalar>
[[gnu::always_inline]] inline Packed<T, 3> rotate(const Eigen::QuaternionBase<Q>& q,
                                                  const Eigen::MatrixBase<Vector>& v) {
  const Packed<T, 3>& u = v.template cast<T>();
  const T &x = q.x(), &y = q.y(), &z = q.z(), &w = q.w();
  const T a = y * u.z() - z * u.y(), b = z * u.x() - x * u.z(), c = x * u.y() - y * u.x();
  const T p = a + a, r = b + b, s = c + c;
  return {u.x() + w * p + (y * s - z * r), u.y() + w * r + (z * p - x * s), u.z() + w * s + (x * r - y * p)};
}

/// The angle φ in [−π, π] [rad], given sine and cosine >= 0 of φ/2: φ = 8 arctan(sin(φ/4) / (1 + cos(φ/4))).
template <class T>
T angle_from_half(const SinCos<T>& half) {
  const SinCos<T> quarter = detail::half_of<T>(half);
  return 8.0 * detail::arctangent<T>(T(quarter.sin / (1.0 + quarter.cos)));
}

/// The angle of `r` in [−π, π] [rad], to a few ulps.
template <class T>
T principal_angle(const PlaneRotation<T>& r) {
  return angle_from_half<T>(detail::half_of<T>({r.sin, r.cos}));
}

/// The inverse of `space_rotation`, to a few ulps: the turn [rad] of a unit quaternion, at most π long, in world
/// axes.
inline Packed<double, 3> turn_of(const Quaternion<double>& q) {
  const double sign = q.w() < 0 ? -1 : 1, sin = q.vec().norm();
  return sin > 0 ? Packed<double, 3>(sign * angle_from_half<double>({sin, sign * q.w()}) / sin * q.vec())
                 : Packed<double, 3>(2 * sign * q.vec());
}

}  // namespace byhand
