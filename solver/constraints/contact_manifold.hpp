#pragma once

#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"

// Two bodies in the plane that touch along a face: (15) at the face's two ends and (16) once, in its middle.
//
//   C_0, C_1, (23)    the separations at the two ends, >= 0                                      [m]
//   slip              s = t · (P2 - P1) in the middle, t = n turned by -90°; a rate, without a C [m]
//   J by inspection   J_0, J_1 = [ -n   -r1 × n   n   r2 × n ] with the arms of each end,     (15)
//                     J_2      = [ -t   -r1 × t   t   r2 × t ] with the arms of the middle    (16)
//
// λ_0, λ_1 >= 0 and |λ_2| <= μ (λ_0 + λ_1) [N s]. One friction row does for two, because a face can slip along
// itself only as a whole. The three rows are one block: solved one after the other, the ends would take turns at
// tilting the body. Two bodies that touch at a point alone have their second end without effect.
namespace byhand {

template <class M>
struct ContactManifold {
  static_assert(std::is_same_v<M, PlaneBody>, "a face has two ends in the plane only");
  static constexpr int rows = 3;
  static constexpr Bound bound = Bound::manifold;
  static constexpr int position_rows = 2;

  Anchors<M> at;                          // the first end
  Arms<M> second = {};                    // the second end's arms, in the frames of the bodies [m]
  bool point = false;                     // whether there is no second end
  Linear<M> normal = Linear<M>::Unit(1);  // n from body 1 to body 2, a unit vector in the world
  double coefficient = 0;                 // μ >= 0
  double restitution = 0;                 // e in [0, 1]
  double softness = 0;                    // γ [1/kg] >= 0

  /// (23) at both ends and the slip in the middle, at two poses [m], for any scalar; n and t stay as they are.
  template <class T>
  Rows<3, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> n = normal.template cast<T>(), t = tangents_of<M>(normal).template cast<T>();
    const Linear<M, T> first = at.separation(pose1, pose2);
    if (point) return {first.dot(n), T(0), first.dot(t)};
    const Linear<M, T> last = Anchors<M>{at.body1, at.body2, second}.separation(pose1, pose2);
    return {first.dot(n), last.dot(n), T(0.5 * (first + last).dot(t))};
  }

  /// (15), (15) and (16) at two poses [1 and m].
  Jacobian<M, 3> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> t = tangents_of<M>(normal);
    const auto r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, 3> J;
    set_row_along<M, 3>(J, 0, normal, r1, r2);
    if (point) {
      J.matrix.row(1).setZero();
      set_row_along<M, 3>(J, 2, t, r1, r2);
      return J;
    }
    const auto s1 = in_world<M, double>(pose1, second.first), s2 = in_world<M, double>(pose2, second.second);
    set_row_along<M, 3>(J, 1, normal, s1, s2);
    set_row_along<M, 3>(J, 2, t, Linear<M>(0.5 * (r1 + s1)), Linear<M>(0.5 * (r2 + s2)));
    return J;
  }

  /// Throws std::invalid_argument unless the normal has length 1, μ >= 0, e is in [0, 1] and softness >= 0.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_in("length of the normal", normal.norm(), 1 - 1e-9, 1 + 1e-9);
    require_in("friction coefficient", coefficient, 0, 1e300);
    require_in("restitution", restitution, 0, 1);
    require_in("softness", softness, 0, 1e300);
  }
};

BYHAND_STORE_IN_LIBRARY(PlaneBody, ContactManifold);

}  // namespace byhand
