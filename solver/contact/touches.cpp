#include "solver/contact/touches.hpp"

#include <algorithm>
#include <iterator>

#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
std::vector<Touch<M>> touches(const Bodies<M>& bodies,
                              const ContactManager<M>& contacts) requires(M::angular > 0) {
  std::vector<Touch<M>> result;
  for (const ContactPair<M>& pair : contacts.pairs()) {
    const auto [body1, body2] = pair.bodies;
    if (!pair.presses() || !bodies.has(body1) || !bodies.has(body2)) continue;
    const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
    const auto tangents = tangents_of<M>(pair.normal);
    Touch<M>& touch = result.emplace_back(Touch<M>{body1, body2, pair.normal, Linear<M>::Zero()});
    touch.began = !std::ranges::binary_search(contacts.pressed_before(), pair.bodies);
    for (int p = 0; p < pair.size; ++p) {
      const auto& [feature, arms, normal_impulse, tangent_impulse] = pair.points[p];
      const Linear<M> P1 = anchor<M, double>(pose1, in_world<M, double>(pose1, arms.first)),
                      P2 = anchor<M, double>(pose2, in_world<M, double>(pose2, arms.second));
      touch.points.push_back({0.5 * (P1 + P2), pair.normal.dot(P2 - P1), normal_impulse});
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

#define BYHAND_INSTANTIATE(M)                                                         \
  template std::vector<Touch<M>> touches(const Bodies<M>&, const ContactManager<M>&); \
  template std::vector<BodyPair> parted(const ContactManager<M>&)
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
