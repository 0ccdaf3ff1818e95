#pragma once

#include "solver/constraints/contact.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A unit box of 1 kg that rests on the ground at `contacts` points, evenly spaced from corner to corner of its
/// lower side: more of them than it takes to hold it. Body 0 is the ground, body 1 the box.
inline Scene<PlaneBody> box_on_contacts(int contacts) {
  require(contacts >= 2, "number of contacts", contacts, "at least 2");
  using M = PlaneBody;
  Scene<M> scene;
  const int ground = scene.add_body(Linear<M>(0, 0), fixed<M>());
  const int box_above = scene.add_body(Linear<M>(0, 0.5), box<M>(1, Linear<M>(1, 1)));
  for (int i = 0; i < contacts; ++i) {
    const Linear<M> point(static_cast<double>(i) / (contacts - 1) - 0.5, 0);
    scene.add(Contact<M>{between<M>(scene.bodies(), ground, point, box_above, point)});
  }
  return scene;
}

}  // namespace byhand
