#pragma once

#include <algorithm>
#include <cmath>

#include "solver/constraints/distance.hpp"
#include "solver/contact/contact_manager.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// How far the two points of any joint are apart, or a rod from its length, or two bodies in each other, at most
/// [m].
template <class M>
double separation(const Scene<M>& scene, const ContactManager<M>& contacts) {
  double largest = 0;
  for_each_constraint(scene, contacts, [&](const ConstraintStore<M>& store, const auto& entry) {
    if (store.position_rows == 0 || dynamic_cast<const Store<M, Distance<M>>*>(&store)) return;
    double C[most_rows<M>];
    store.write_value(entry.index, scene.bodies(), C);
    double apart = -*std::min_element(C, C + store.position_rows);  // of what touches
    if (store.bound == Bound::none)                                 // a rod has one row, a pin one for each axis
      apart = store.position_rows == 1 ? std::abs(C[0]) : Eigen::Map<const Linear<M>>(C).norm();
    largest = std::max(largest, apart);
  });
  // Its C is in m².
  for (const auto& rod : scene.template all<Distance<M>>()) {
    const auto& pose = scene.bodies().pose;
    const double apart = rod.at.separation(pose[rod.at.body1], pose[rod.at.body2]).norm();
    largest = std::max(largest, std::abs(apart - rod.length));
  }
  return largest;
}

}  // namespace byhand
