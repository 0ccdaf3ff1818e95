#include "lessons/laws/friction.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lessons/laws/numbers.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/step.hpp"

// Law 10. Coulomb's friction is a vector of at most μ times what presses, a disc. Bounded axis by axis it is a
// square, and each axis brakes with the whole μg: a slide at φ ends after v²cos²φ/2μg along one and v²sin²φ/2μg
// along the other. At 45° that is 1/√2 of the way; elsewhere it turns, to tan φ' = tan²φ. Symplectic Euler moves
// with the new velocity and is short by half a step of the first one, vh/2, on each axis (0.69 of the way, not
// 0.71, at 3 m/s and 60 Hz).
//
// Friction also comes after the normal: its bound is μ times a λ that a cold start has not found yet.
namespace byhand::laws {
namespace {

constexpr double mu = 0.5;

double way_to_stop(double speed) { return speed * speed / (2 * mu * g) - 0.5 * speed * sixtieth; }

}  // namespace

Slide slide(FrictionBound bound, double heading, double speed) {
  using M = SpaceParticle;
  Scene<M> scene;
  const Linear<M> up(0, 1, 0);
  const int ground = scene.add_body({0, 0, 0}, fixed<M>());
  const int particle =
      scene.add_body({0, 0, 0}, with_mass<M>(1), speed * Velocity<M>(std::cos(heading), 0, std::sin(heading)));
  const auto contact = scene.add(Contact<M>{{ground, particle}, up});
  if (bound == FrictionBound::disc) {
    scene.add(Friction<M>{{ground, particle}, tangents_of<M>(up), mu, contact});
  } else {
    for (const Linear<M>& tangent : {Linear<M>(1, 0, 0), Linear<M>(0, 0, 1)})
      scene.add(AxisFriction<M>{{ground, particle}, tangent, mu, contact});
  }
  Simulation<M> simulation{std::move(scene), {GaussSeidel{}, Baumgarte{}}};
  const double stopped_by = speed / (mu * g) + 0.1;
  while (simulation.time < stopped_by) simulation.step(sixtieth);
  const Linear<M> gone = simulation.scene.bodies().pose[particle].position;
  return {gone.norm(), std::atan2(gone.z(), gone.x())};
}

Law friction() {
  Law law{10,
          Family::wrong_rows,
          "bound of friction",
          "friction bounded axis by axis is a square: it brakes harder between the axes and turns the motion",
          "1/√2 of the distance at 45°; tan φ' = tan²φ",
          {}};
  const double degree = std::numbers::pi / 180;
  for (const double speed : {1.0, 3.0, 10.0})
    law.boundaries.push_back({"stopping distance, square / disc", "", fmt::format("45°, {} m/s", speed),
                              std::numbers::sqrt2 * way_to_stop(speed / std::numbers::sqrt2) / way_to_stop(speed),
                              0.01, [=] {
                                return slide(FrictionBound::square, 45 * degree, speed).distance /
                                       slide(FrictionBound::disc, 45 * degree, speed).distance;
                              }});
  for (const double heading : {15.0, 30.0}) {
    const double speed = 10, along = way_to_stop(speed * std::cos(heading * degree)),
                 across = way_to_stop(speed * std::sin(heading * degree));
    law.boundaries.push_back({"heading at the end", "°", fmt::format("{}° at first, {} m/s", heading, speed),
                              std::atan2(across, along) / degree, 0.02, [=] {
                                return slide(FrictionBound::square, heading * degree, speed).heading / degree;
                              }});
  }
  return law;
}

}  // namespace byhand::laws
