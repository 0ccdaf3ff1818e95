#pragma once

#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"

// Two bodies in the plane touch along a face: (15) at both ends of the face and (16) once, at its middle.
//
//   C_0, C_1, (23)    the separations at the two ends, >= 0                                      [m]
//   slip              s = t · (P2 - P1) at the middle, t = n turned by -90°; a rate, without a C [m]
//   J by inspection   J_0, J_1 = [ -n   -r1 × n   n   r2 × n ] with the arms of each end,     (15)
//                     J_2      = [ -t   -r1 × t   t   r2 × t ] with the arms of the middle    (16)
//
// λ_0, λ_1 >= 0 and |λ_2| <= μ (λ_0 + λ_1) [N s]. One friction row is enough, because a face slips along itself
// only as a whole. The three rows are one block: solved in turn, the two ends would alternately tilt the body.
namespace byhand {

template <class M>
struct ContactManifold {
  static_assert(std::is_same_v<M, PlaneBody>, "a face has two ends in the plane only");
  static constexpr int rows = 3, position_rows = 2;
  static constexpr Bound bound = Bound::manifold;
  static constexpr bool holds_where_found = true;

  Anchors<M> at;                          // the first end
  Arms<M> second = {};                    // arms of the second end, in the frames of the bodies [m]
  bool point = false;                     // whether the bodies touch at the first end only: J_1 = 0
  Linear<M> normal = Linear<M>::Unit(1);  // n from body 1 to body 2, a unit vector in the world
  double coefficient = 0;                 // μ >= 0
  double restitution = 0;                 // e in [0, 1]
  double softness = 0;                    // γ [1/kg] >= 0

  template <class T>
  Rows<3, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> n = normal.template cast<T>(), t = tangents_of<M>(normal).template cast<T>();
    const Linear<M, T> first = at.separation(pose1, pose2);
    const Linear<M, T> last =
        point ? first : Anchors<M>{at.body1, at.body2, second}.template separation<T>(pose1, pose2);
    return {first.dot(n), point ? T(0) : T(last.dot(n)), T(0.5 * (first + last).dot(t))};
  }

  Jacobian<M, 3> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> t = tangents_of<M>(normal);
    const Linear<M> r1 = in_world<M, double>(pose1, at.arms.first),
                    r2 = in_world<M, double>(pose2, at.arms.second);
    const Linear<M> s1 = point ? r1 : in_world<M, double>(pose1, second.first);
    const Linear<M> s2 = point ? r2 : in_world<M, double>(pose2, second.second);
    Jacobian<M, 3> J;
    set_row_along<M, 3>(J, 0, normal, r1, r2);
    set_row_along<M, 3>(J, 1, normal, s1, s2);
    set_row_along<M, 3>(J, 2, t, 0.5 * (r1 + s1), 0.5 * (r2 + s2));
    if (point) J.matrix.row(1).setZero();
    return J;
  }

  void require_valid(const Bodies<M>&) const { require_unit("length of the normal", normal.norm()); }
};

extern BYHAND_STORE(PlaneBody, ContactManifold);

}  // namespace byhand
