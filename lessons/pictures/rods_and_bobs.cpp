#include "lessons/pictures/rods_and_bobs.hpp"

#include <algorithm>
#include <cmath>

#include "solver/constraints/distance.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/spring.hpp"

namespace byhand::pictures {

using renderer::Canvas;
using renderer::Point;

namespace {

/// Where a constraint holds its bodies, if it is of one of these kinds.
template <template <class> class... Kinds, class M>
const Anchors<M>* anchors_of(const Scene<M>& scene, const typename Scene<M>::Entry& entry) {
  const std::type_info& kind = scene.store(entry.kind).kind();
  const Anchors<M>* at = nullptr;
  ((kind == typeid(Kinds<M>) ? void(at = &scene.template all<Kinds>()[entry.index].at) : void()), ...);
  return at;
}

}  // namespace

template <class M>
Linkage rods_and_bobs(const Scene<M>& scene) {
  const Bodies<M>& bodies = scene.bodies();
  Linkage linkage;
  std::vector<bool> is_link(bodies.size());
  const auto end = [&](int body, const Arm<M>& arm) {
    return Point(anchor<M, double>(bodies.pose[body], in_world<M, double>(bodies.pose[body], arm)));
  };
  for (const auto& entry : scene.entries()) {
    const Anchors<M>* pin = anchors_of<Pin>(scene, entry);
    const Anchors<M>* at = pin ? pin : anchors_of<Distance, NormalisedDistance, Rope, Spring>(scene, entry);
    if (!at) continue;
    const auto [body1, body2, arms] = *at;
    const Point p1 = end(body1, arms.first), p2 = end(body2, arms.second);
    const bool moves1 = moves(bodies.inverse_mass[body1]), moves2 = moves(bodies.inverse_mass[body2]);
    if (!pin) {
      linkage.rods.push_back({p1, p2});
    } else {
      if (moves1 && moves2) linkage.hinges.push_back(p2);
      for (const auto& [body, point] : {std::pair{body1, p1}, std::pair{body2, p2}}) {
        if (!moves(bodies.inverse_mass[body]) || is_link[body]) continue;
        is_link[body] = true;
        linkage.links.push_back({point, 2 * bodies.pose[body].position - point});
      }
    }
    if (!moves1) linkage.anchors.push_back(p1);
    if (!moves2) linkage.anchors.push_back(p2);
  }
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]) && !is_link[i])
      linkage.bobs.push_back({bodies.pose[i].position, 1 / bodies.inverse_mass[i].linear});
  return linkage;
}
template Linkage rods_and_bobs(const Scene<PlaneParticle>&);
template Linkage rods_and_bobs(const Scene<PlaneBody>&);

double bob_radius(const Linkage& linkage, const Linkage::Bob& bob, const LinkageStyle& style) {
  double lightest = bob.mass;
  for (const Linkage::Bob& other : linkage.bobs) lightest = std::min(lightest, other.mass);
  return style.bob * std::cbrt(bob.mass / lightest);
}

void draw(Canvas& canvas, const Linkage& linkage, const LinkageStyle& style) {
  for (const Point& at : linkage.anchors) canvas.anchor(at);
  for (const Linkage::Bar& rod : linkage.rods) canvas.rod(rod.from, rod.to, style.rods, style.rod);
  for (const Linkage::Bar& link : linkage.links) canvas.rod(link.from, link.to, style.bodies, style.link);
  for (const Linkage::Bob& bob : linkage.bobs)
    canvas.disc(bob.at, bob_radius(linkage, bob, style) / canvas.camera().scale, style.bodies);
  for (const Point& at : linkage.hinges) canvas.hinge(at);
  for (const Point& at : linkage.anchors) canvas.hinge(at);
}

}  // namespace byhand::pictures
