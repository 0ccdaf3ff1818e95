#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/held_scene.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double wall = 4.5;  // to the left and the right of the middle [m]

Scene<PlaneBody> boxes_between_walls(double mass, const Surface& surface) {
  Scene<PlaneBody> scene;
  add_ground(scene, surface);
  for (const double side : {-1, 1}) {
    const int body = scene.add_body(Linear<PlaneBody>(side * wall, 0), fixed<PlaneBody>());
    scene.set_shape(body, HalfSpace<PlaneBody>{{-side, 0}}, surface);
  }
  for (const auto& [x, y] : {std::pair{-2.0, 0.5}, {-2.0, 1.5}, {0.4, 0.5}, {2.4, 0.5}})
    add_unit_box(scene, x, y, mass, surface);
  return scene;
}

}  // namespace

course::Hold in_hand(const Setting& setting) {
  return {"boxes_in_hand", "Four boxes on the floor between two walls; two of them begin as a stack.", [setting] {
            const GaussSeidel solver{.sweeps = setting.sweeps};
            return pictures::in_hand<PlaneBody>(
                {.start = {boxes_between_walls(setting.mass, {.friction = setting.friction}),
                           {solver, Baumgarte{.beta = setting.beta, .slop = 0.005}}},
                 .h = setting.h(),
                 .view = {-wall - 0.3, -0.9, 2 * wall + 0.6, 6.4},
                 .body = "box",
                 .law = "A step of h must not carry a box through another; try a smaller one."});
          }};
}

}  // namespace byhand::contact
