#pragma once

#include <vector>

#include "renderer/canvas.hpp"
#include "solver/measure.hpp"

namespace byhand::pictures {

/// What a scene in the plane looks like at one instant: a value, so that a figure or a frame can be drawn later,
/// when the scene has moved on.
struct Linkage {
  struct Bob {
    renderer::Point at;
    double mass;  // [kg]
  };
  struct Bar {
    renderer::Point from, to;
  };
  std::vector<Bob> bobs = {};   // bodies that move, held by rods
  std::vector<Bar> rods = {};   // massless rods: Distance, NormalisedDistance
  std::vector<Bar> links = {};  // bodies that move, held by pins: from the first pin through the centre
  std::vector<renderer::Point> hinges = {};   // pins between two bodies that move
  std::vector<renderer::Point> anchors = {};  // where the world holds the scene
};

/// Reads the linkage off a scene of particles or bodies in the plane, held by rods, pins or both. A fixed body
/// shows only where a constraint leans on it.
template <class S>
Linkage rods_and_bobs(const S& scene) {
  using M = typename S::model;
  static_assert(M::linear == 2, "a linkage is a picture in the plane");
  const auto& bodies = scene.bodies();
  Linkage linkage;
  std::vector<bool> is_link(bodies.size());
  const auto end = [&](int body, const Arm<M>& arm) {
    return renderer::Point(anchor<M, double>(bodies.pose[body], in_world<M, double>(bodies.pose[body], arm)));
  };
  scene.for_each([&](const auto& constraint) {
    const auto [body1, body2, arms] = constraint.at;
    const renderer::Point p1 = end(body1, arms.first), p2 = end(body2, arms.second);
    const bool moves1 = moves(bodies.inverse_mass[body1]), moves2 = moves(bodies.inverse_mass[body2]);
    if constexpr (std::remove_cvref_t<decltype(constraint)>::rows == 1) {
      linkage.rods.push_back({p1, p2});
    } else {
      if (moves1 && moves2) linkage.hinges.push_back(p2);
      for (const auto& [body, pin] : {std::pair{body1, p1}, std::pair{body2, p2}}) {
        if (!moves(bodies.inverse_mass[body]) || is_link[body]) continue;
        is_link[body] = true;
        linkage.links.push_back({pin, 2 * bodies.pose[body].position - pin});
      }
    }
    if (!moves1) linkage.anchors.push_back(p1);
    if (!moves2) linkage.anchors.push_back(p2);
  });
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]) && !is_link[i])
      linkage.bobs.push_back({bodies.pose[i].position, 1 / bodies.inverse_mass[i].linear});
  return linkage;
}

struct LinkageStyle {
  double bob = 15;   // radius of the lightest bob [points]; heavier ones grow as balls of one material, with the
                     // cube root of the mass
  double rod = 6;    // thickness [points]
  double link = 16;  // thickness [points]
  renderer::Look rods{renderer::palette::constraint, {renderer::palette::ink, 0}};
  renderer::Look bodies = renderer::body_look;
};

/// Draws a linkage in the world of the canvas's camera.
void draw(renderer::Canvas& canvas, const Linkage& linkage, const LinkageStyle& style = {});

/// Radius of a bob as it is drawn [points].
double bob_radius(const Linkage& linkage, const Linkage::Bob& bob, const LinkageStyle& style = {});

}  // namespace byhand::pictures
