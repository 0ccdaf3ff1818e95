#pragma once

#include "lessons/pictures/prelude.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/integrate/euler.hpp"

namespace byhand::single_constraint {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

using Pendulum = Scene<PlaneParticle>;
using Vector = Linear<PlaneParticle>;

/// The lesson's parameters: one bob on one rod.
struct Setting {
  course::Parameter<double> length, mass, h, angle, release;  // [m], [kg], [s], [deg], [deg]
};

/// The course's scenes fall with this [m/s²].
inline double gravity() { return -Pendulum().gravity.y(); }

/// The bob held at the angle, at rest, with one step of gravity already in its velocity.
inline Pendulum let_go(const Setting& setting) {
  Pendulum scene = pendulum<PlaneParticle>(radians(setting.angle()), setting.length(), setting.mass());
  scene.set_position(1, course::without_rounding(scene.bodies().pose[1].position));
  add_gravity(scene.state(), scene.gravity, setting.h());
  return scene;
}

/// Two free bobs, the second four times as heavy, on a rod that leans like the pendulum's; the first is hit along
/// `velocity` [m/s].
inline Pendulum two_free_bobs(const Setting& setting, const Vector& velocity = Vector::Zero()) {
  Pendulum scene;
  scene.gravity.setZero();
  const Vector along = course::without_rounding(from_straight_down<PlaneParticle>(radians(setting.angle())));
  scene.add_body(Vector::Zero(), with_mass<PlaneParticle>(setting.mass()), velocity);
  scene.add_body(setting.length() * along, with_mass<PlaneParticle>(4 * setting.mass()));
  scene.add(Distance<PlaneParticle>{{0, 1}, setting.length()});
  return scene;
}

/// What the article computes for a scene's only rod, at one instant: (8), (18), (19), (17).
struct OneRow {
  explicit OneRow(const Pendulum& scene);
  /// The scene's velocities after the impulse (20).
  std::pair<Vector, Vector> velocities_after(double impulse) const;
  std::pair<Vector, Vector> velocities_after() const { return velocities_after(lambda); }

  Jacobian<PlaneParticle, 1> J, W;  // (14) and M⁻¹Jᵀ
  Vector v1, v2, d;
  double JV = 0;      // [m²/s]
  double K = 0;       // JM⁻¹Jᵀ [m²/kg]
  double lambda = 0;  // [N s/m]; times |d| it is in N s
};

/// The row of `let_go` with zeros in place of what is only rounding: for sentences, formulas and answers.
OneRow shown_row(const Setting& setting);

}  // namespace byhand::single_constraint
