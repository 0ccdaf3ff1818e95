#pragma once

#include "solver/model.hpp"

namespace byhand {

/// One number for each of a constraint's K rows.
template <int K, class T = double>
using Rows = Eigen::Matrix<T, K, 1>;

/// J of (4) for a constraint of K rows between two bodies: K × 2 dof numbers in the order of (6), l1 a1 l2
/// a2.
template <class M, int K>
struct Jacobian {
  Eigen::Matrix<double, K, 2 * M::dof, Eigen::RowMajor> matrix;

  auto l1() const { return matrix.template leftCols<M::linear>(); }
  auto a1() const { return matrix.template middleCols<M::angular>(M::linear); }
  auto l2() const { return matrix.template middleCols<M::linear>(M::dof); }
  auto a2() const { return matrix.template rightCols<M::angular>(); }
  auto side1() const { return matrix.template leftCols<M::dof>(); }
  auto side2() const { return matrix.template rightCols<M::dof>(); }

  /// Sets one row from its four parts, as (14)–(16) list them.
  void set_row(int k, const Linear<M>& l1, const Angular<M>& a1, const Linear<M>& l2, const Angular<M>& a2) {
    auto row = matrix.row(k);
    row.template segment<M::linear>(0) = l1;
    row.template segment<M::angular>(M::linear) = a1;
    row.template segment<M::linear>(M::dof) = l2;
    row.template segment<M::angular>(M::dof + M::linear) = a2;
  }
};

//! [along]
/// The row that (14), (15) and (16) share, along a world direction u: [-u  -r1 × u  u  r2 × u].
template <class M, int K>
void set_row_along(Jacobian<M, K>& J, int k, const Linear<M>& u, const Arm<M>& r1, const Arm<M>& r2) {
  J.set_row(k, -u, -cross(r1, u), u, cross(r2, u));
}
//! [along]

//! [8]
/// (8): JV = l1·v1 + a1·ω1 + l2·v2 + a2·ω2, the rate at which the constraint's value changes [units of C per
/// second]. A side of J is its l and a, as V is v and ω.
template <class M, int K>
Rows<K> dot(const Jacobian<M, K>& J, const Velocity<M>& V1, const Velocity<M>& V2) {
  return J.side1().lazyProduct(V1) + J.side2().lazyProduct(V2);
}
//! [8]

}  // namespace byhand
