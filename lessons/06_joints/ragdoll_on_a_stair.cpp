// Deeper: everything at once.

#include <memory>
#include <set>
#include <utility>

#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/ragdoll.hpp"

namespace byhand::joints {
namespace {

using Doll = Simulation<PlaneBody>;

constexpr double fall_seconds = 2.7, doll_settles = 20, step = 1.0 / 120;  // [s]
constexpr int sweeps = 60, stairs = 4;

Doll above_a_stair() {
  Doll doll{{}, {GaussSeidel{.sweeps = sweeps}, Baumgarte{.beta = 0.2, .slop = 1e-3, .speed_cap = 3}}};
  auto& scene = doll.scene;
  add_ground(scene, {0.6});
  for (int i = 0; i < stairs; ++i) {
    const double high = 0.2 * (stairs - i);  // [m]
    const int body = scene.add_body(Linear<PlaneBody>(0.3 * i, high / 2), fixed<PlaneBody>());
    scene.set_shape(body, Box<PlaneBody>{{0.3, high}}, {0.6});
  }
  const int torso = add_ragdoll(scene, {0.2, 2.2});
  scene.set_velocity(torso, {1, 0, -2});
  return doll;
}

/// By how much the joints' stops are passed at most [rad].
double passed(const Doll& doll) {
  double worst = 0;
  const auto& poses = doll.scene.bodies().pose;
  for (const auto& stop : doll.scene.all<Limit<PlaneBody, Turn>>())
    worst = std::max(worst, -stop.value<double>(poses[stop.at.body1], poses[stop.at.body2])[0]);
  return worst;
}

/// The least λ of all stops as the last step left them [N m s].
double least_of_stops(const Doll& doll) {
  double least = INFINITY;
  for (int place = 0; place < doll.scene.count(); ++place)
    if (doll.scene.get_if<Limit<PlaneBody, Turn>>(place))
      least = std::min(least, doll.impulse(doll.scene.entries()[place].id)[0]);
  return least;
}

/// The bodies of each joint at which a stop pushed in the last step.
std::set<std::pair<int, int>> pushing_stops(const Doll& doll) {
  std::set<std::pair<int, int>> joints;
  if (doll.time == 0) return joints;
  for (int place = 0; place < doll.scene.count(); ++place) {
    const auto& entry = doll.scene.entries()[place];
    if (doll.scene.get_if<Limit<PlaneBody, Turn>>(place) && doll.impulse(entry.id)[0] > 0)
      joints.insert({entry.body1, entry.body2});
  }
  return joints;
}

/// What ground and stairs carry, upright [N].
double carried(const Doll& doll) {
  double sum = 0;
  for (const Touch<PlaneBody>& touch : doll.touches())
    if (!moves(doll.scene.bodies().inverse_mass[touch.body1])) sum += touch.impulse.y() / doll.work.h;
  return sum;
}

}  // namespace

void ragdoll_on_a_stair(const Setting&, Page& page) {
  const Doll start = above_a_stair();
  double worst = 0, least = INFINITY, weight = 0;
  Doll doll = start;
  for (const auto& mass : doll.scene.bodies().inverse_mass)
    if (moves(mass)) weight += gravity / mass.linear;
  advance_to(doll, doll_settles, step, [&] {
    worst = std::max(worst, passed(doll));
    least = std::min(least, least_of_stops(doll));
  });
  const double at_rest = passed(doll);

  page.text(
      R"(Ten boxes, nine pins, two stops on each pin, and contacts wherever something touches: a ragdoll of @ kg falls
      onto a flight of stairs. Nothing in the solver knows about ragdolls. (@ a step of 1/@ s, β = @, @ mm of slop.))",
      Value(weight / gravity, 3), several(sweeps, "sweep"), std::round(1 / step), 0.2, 1);
  page.sequence(
      "ragdoll",
      R"(Head, torso, arms and legs are boxes; each joint is a pin with two stops. Orange: a joint at which a stop
      pushes.)",
      Seconds{fall_seconds}, [doll = start](Canvas& canvas, double time) mutable {
        advance_to(doll, time, step);
        canvas.look(fit({-0.9, -0.15, 4.3, 3.3}, canvas.page(0.8), 0));
        pictures::draw(canvas, pictures::shapes_of(doll.scene));
        const std::set<std::pair<int, int>> stopped = pushing_stops(doll);
        for (const auto& joint : doll.scene.all<Pin>()) {
          const Pose<PlaneBody>& pose = doll.scene.bodies().pose[joint.at.body2];
          const Point at =
              anchor<PlaneBody, double>(pose, in_world<PlaneBody, double>(pose, joint.at.arms.second));
          if (stopped.contains({joint.at.body1, joint.at.body2}))
            canvas.disc(at, 14 / canvas.camera().scale, {palette::force, {palette::ink, 1.4}});
          canvas.hinge(at);
        }
        canvas.look_at_page();
      });
  page.text(
      R"(A joint's stop is one more row for the sweeps, so an impact can drive a joint past its stop, here by up to @°. At
      rest only @° of that is left, no stop ever pulled, and ground and stairs carry @ N, the doll's weight.)",
      Value(degrees(worst), 2), Value(degrees(at_rest), 2), Value(carried(doll), 5));
  page.claim("least λ of any stop in any step", least, "N m s", is_at_least(0, "its bound, kept exactly"));
  page.claim(say("what ground and stairs carry after @ s", doll_settles), carried(doll), "N",
             is(weight, "the doll's weight", relative(1e-3)));
  page.claim("stops passed at rest", at_rest, "rad", is_at_most(2e-3, "nothing pushes any more"));
}

}  // namespace byhand::joints
