#pragma once

#include <type_traits>

#include "solver/integrate/rotation.hpp"

// How many numbers a body moves with. Everything else in the solver is written once over this type, so a bob
// on a rod carries no inertia, no angle and no zeros that stand for them.
namespace byhand {

/// A body that moves along L axes and turns about A axes.
template <int L, int A>
struct Model {
  static constexpr int linear = L;
  static constexpr int angular = A;
  static constexpr int dof = L + A;
};

using PlaneParticle = Model<2, 0>;
using PlaneBody = Model<2, 1>;
using SpaceParticle = Model<3, 0>;
using SpaceBody = Model<3, 3>;

/// Declares, within a struct T<M>, what constructs, copies and destroys it. A source defines that once, as
/// compiling it in each source that copies a simulation takes more than a second.
#define BYHAND_DECLARE_COPIES(T) \
  T();                           \
  T(const T&);                   \
  T(T&&) noexcept;               \
  T& operator=(const T&);        \
  T& operator=(T&&) noexcept;    \
  ~T()
/// A point or direction in the model's world: 2 or 3 numbers.
template <class M, class T = double>
using Linear = Packed<T, M::linear>;

/// A rotation rate or moment: no number for a particle, one in the plane, three in space.
template <class M, class T = double>
using Angular = Packed<T, M::angular>;

/// v and ω of one body packed into one vector, in that order [m/s, rad/s].
template <class M, class T = double>
using Velocity = Packed<T, M::dof>;

/// A particle has no arm and no orientation; these take their place and take no space.
struct NoArm {};
struct NoRotation {};

/// r of (10): from the centre of mass to a point of the body [m].
template <class M, class T = double>
using Arm = std::conditional_t<M::angular == 0, NoArm, Linear<M, T>>;

template <class M, class T = double>
using Rotation = std::conditional_t<M::angular == 0, NoRotation,
                                    std::conditional_t<M::angular == 1, PlaneRotation<T>, Quaternion<T>>>;

/// Where a body is: its centre of mass [m] and its orientation.
template <class M, class T = double>
struct Pose {
  Linear<M, T> position = Linear<M, T>::Zero();
  [[no_unique_address]] Rotation<M, T> rotation = resting();

 private:
  static Rotation<M, T> resting() {
    if constexpr (M::angular == 3)
      return Quaternion<T>(T(1), T(0), T(0), T(0));
    else
      return {};
  }
};

/// r × n: nothing, a scalar or three numbers, so that (14)–(16) serve all four models as they stand.
template <class V>
auto cross(NoArm, const Eigen::MatrixBase<V>&) {
  return Eigen::Matrix<typename V::Scalar, 0, 1>();
}
template <class R, class V>
auto cross(const Eigen::MatrixBase<R>& r, const Eigen::MatrixBase<V>& n) {
  using T = typename V::Scalar;
  if constexpr (R::RowsAtCompileTime == 2)
    return Eigen::Matrix<T, 1, 1>(r.x() * n.y() - r.y() * n.x());
  else
    return Eigen::Matrix<T, 3, 1>(r.cross(n));
}

/// A body's arm [m, body frame] turned into the world by its pose. Always inlined, so that C and J share it.
template <class M, class T>
[[gnu::always_inline]] inline Arm<M, T> in_world(const Pose<M, T>& pose, const Arm<M>& arm) {
  if constexpr (M::angular == 0)
    return {};
  else
    return rotate(pose.rotation, Linear<M, T>(arm.template cast<T>()));
}

/// P = x + r of (10): the world position of the tip of a world-frame arm [m].
template <class M, class T>
Linear<M, T> anchor(const Pose<M, T>& pose, const Arm<M, T>& arm) {
  if constexpr (M::angular == 0)
    return pose.position;
  else
    return pose.position + arm;
}

/// The inverse of `in_world`: the body-frame arm of a world point [m].
template <class M>
Arm<M> arm_to(const Pose<M>& pose, const Linear<M>& point) {
  if constexpr (M::angular == 0)
    return {};
  else
    return rotate(inverse(pose.rotation), Linear<M>(point - pose.position));
}

/// Moves a pose with `velocity` for `time` [s]: exact for constant v and ω.
template <class M, class T>
void move(Pose<M, T>& pose, const Velocity<M, T>& velocity, const T& time) {
  pose.position += velocity.template head<M::linear>() * time;
  if constexpr (M::angular == 1) pose.rotation = rotated_by(pose.rotation, T(velocity[M::linear] * time));
  if constexpr (M::angular == 3)
    pose.rotation = rotated_by(pose.rotation, Angular<M, T>(velocity.template tail<3>() * time));
}

/// The pose that `move` leads to.
template <class M, class T>
Pose<M, T> moved(Pose<M, T> pose, const Velocity<M, T>& velocity, const T& time) {
  move(pose, velocity, time);
  return pose;
}

/// The same pose in another scalar, so that dual numbers can go through a constraint's `value`.
template <class T, class M>
Pose<M, T> cast(const Pose<M>& pose) {
  Pose<M, T> result;
  result.position = pose.position.template cast<T>();
  if constexpr (M::angular == 1) result.rotation = {T(pose.rotation.cos), T(pose.rotation.sin)};
  if constexpr (M::angular == 3) result.rotation = pose.rotation.template cast<T>();
  return result;
}

}  // namespace byhand
