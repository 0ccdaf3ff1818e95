#pragma once

#include "solver/integrate/rotation.hpp"

// The angle of a rotation by + − × ÷ and square roots alone, so that a joint's error may advance the state.
namespace byhand {

namespace detail {

/// Sine and cosine of half an angle in [−π, π], by whichever of the two roots cancels nothing.
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

/// The angle whose tangent is |t| <= tan(π/8) [rad]. Minimax coefficients from fdlibm's s_atan.c (Sun
/// Microsystems, 1993).
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

/// The angle in [−π, π] [rad] whose half has this sine and this cosine >= 0. Halved twice more, its tangent is
/// small enough for one polynomial: tan(φ/8) = sin(φ/4) / (1 + cos(φ/4)).
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

/// The turn [rad], a vector of at most π in the world's axes, whose rotation is the unit quaternion `q`: the
/// inverse of `space_rotation`, to a few ulps.
inline Eigen::Vector3d turn_of(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0 ? -1 : 1, sin = q.vec().norm();
  return sin > 0 ? Eigen::Vector3d(sign * angle_from_half<double>({sin, sign * q.w()}) / sin * q.vec())
                 : Eigen::Vector3d(2 * sign * q.vec());
}

}  // namespace byhand
