#include "solver/contact/touches.hpp"

#include <algorithm>
#include <iterator>

#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
std::vector<Touch<M>> touches(const Scene<M>& scene, const ContactManager<M>& contacts) requires(M::angular > 0) {
  std::vector<Touch<M>> result;
  for (const ContactPair<M>& pair : contacts.pairs()) {
    const auto [body1, body2] = pair.bodies;
    if (!is_of(scene, pair)) continue;
    if (!std::ranges::binary_search(contacts.pressed(), pair.bodies)) continue;
    const auto tangents = tangents_of<M>(pair.normal);
    Touch<M>& touch = result.emplace_back(Touch<M>{body1, body2, pair.normal, Linear<M>::Zero()});
    touch.began = !std::ranges::binary_search(contacts.pressed_before(), pair.bodies);
    const Manifold<M> manifold = points_of(scene.bodies(), pair);
    for (int p = 0; p < pair.size; ++p) {
      const auto& [feature, arms, normal_impulse, tangent_impulse] = pair.points[p];
      const ContactPoint<M>& point = manifold.points[p];
      touch.points.push_back({0.5 * (point.p1 + point.p2), point.separation, normal_impulse});
      touch.impulse += pair.normal * normal_impulse + tangents * tangent_impulse;
    }
  }
  return result;
}

template <class M>
std::vector<BodyPair> parted(const ContactManager<M>& contacts) requires(M::angular > 0) {
  std::vector<BodyPair> result;
  std::ranges::set_difference(contacts.pressed_before(), contacts.pressed(), std::back_inserter(result));
  return result;
}

#define BYHAND_INSTANTIATE(M)                                                        \
  template std::vector<Touch<M>> touches(const Scene<M>&, const ContactManager<M>&); \
  template std::vector<BodyPair> parted(const ContactManager<M>&)
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
