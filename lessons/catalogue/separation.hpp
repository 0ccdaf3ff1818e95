#pragma once

#include <algorithm>
#include <cmath>

#include "solver/contact/contact_manager.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// How far the two points of any joint are apart, or a rod from its length, or two bodies in each other, at most
/// [m].
template <class M>
double separation(const Scene<M>& scene, const ContactManager<M>& contacts) {
  double largest = 0;
  for_each_constraint(scene, contacts, [&](const ConstraintStore<M>& store, const auto& entry) {
    if (store.position_rows == 0) return;
    double C[most_rows<M>];
    store.write_value(entry.index, scene.bodies(), C);
    double apart = -*std::min_element(C, C + store.position_rows);  // of what touches
    if (store.bound == Bound::none)                                 // a rod has one row, a pin one for each axis
      apart = store.position_rows == 1 ? std::abs(C[0]) : Eigen::Map<const Linear<M>>(C).norm();
    largest = std::max(largest, apart);
  });
  return largest;
}

}  // namespace byhand
