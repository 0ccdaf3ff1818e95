#pragma once

#include "lessons/05_contact/setting.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"

namespace byhand::contact {

inline constexpr double tilt = 30;  // of the box that comes down on its corner [deg]

/// A unit box that comes down on a corner, and what its two rows make of that, one after the other.
class OnACorner {
 public:
  /// It moves `along` the ground [m/s] besides.
  OnACorner(double mass, double speed, double friction, double along = 0) : friction_(friction) {
    const auto [sin, cos] = sin_cos(radians(tilt));
    corner_ = {0.5 * (sin - cos), -0.5 * (sin + cos)};
    const Pose<PlaneBody> tilted{-corner_, plane_rotation(radians(tilt))};
    Scene<PlaneBody> scene;
    const int ground = scene.add_body(Pose<PlaneBody>(), fixed<PlaneBody>());
    const int box = scene.add_body(tilted, byhand::box<PlaneBody>(mass, {1, 1}), {along, -speed, 0});
    const Contact<PlaneBody> contact{between<PlaneBody>(scene.bodies(), ground, {0, 0}, box, {0, 0})};
    bodies_ = scene.bodies();
    normal_ = contact.jacobian(bodies_.pose[0], bodies_.pose[1]);
    tangent_ = Friction<PlaneBody>{contact.at, tangents_of<PlaneBody>(contact.normal)}.jacobian(bodies_.pose[0],
                                                                                                bodies_.pose[1]);
  }

  void solve_normal() { pressed_ += solve(normal_, 0, INFINITY, pressed_); }
  void solve_friction() { rubbed_ += solve(tangent_, -friction_ * pressed_, friction_ * pressed_, rubbed_); }

  /// λ of friction without its bound.
  double rubbed_if_unbounded() const {
    return rubbed_ + impulse(tangent_, over_mass(tangent_), bodies_.velocity[0], bodies_.velocity[1], 0.0);
  }

  double approach() const { return rate(normal_); }
  double slip() const { return rate(tangent_); }
  double pressed() const { return pressed_; }
  double rubbed() const { return rubbed_; }
  /// A = JM⁻¹Jᵀ between two rows, in 1/m.
  double coupling(double mass) const { return mass * entry(tangent_, normal_); }
  double normal_share(double mass) const { return mass * entry(normal_, normal_); }
  double tangent_share(double mass) const { return mass * entry(tangent_, tangent_); }

  Linear<PlaneBody> centre() const { return bodies_.pose[1].position; }
  Linear<PlaneBody> corner_velocity() const { return {slip(), approach()}; }
  double spin() const { return bodies_.velocity[1][2]; }

 private:
  using Row = Jacobian<PlaneBody, 1>;

  Row over_mass(const Row& J) const {
    return times_inverse_mass(J, bodies_.inverse_mass[0], bodies_.pose[0], bodies_.inverse_mass[1],
                              bodies_.pose[1]);
  }
  double rate(const Row& J) const { return dot(J, bodies_.velocity[0], bodies_.velocity[1])[0]; }
  double entry(const Row& one, const Row& other) const { return one.matrix.dot(over_mass(other).matrix); }
  double solve(const Row& J, double lower, double upper, double before) {
    const Row W = over_mass(J);
    //! [bounded]
    const double wanted = before + impulse(J, W, bodies_.velocity[0], bodies_.velocity[1], 0.0);  // (17)
    const double change = std::clamp(wanted, lower, upper) - before;
    apply_impulse(W, Rows<1>(change), bodies_.velocity[0], bodies_.velocity[1]);  // (20)
    //! [bounded]
    return change;
  }

  Bodies<PlaneBody> bodies_;
  Linear<PlaneBody> corner_;  // from the centre [m]
  Row normal_, tangent_;
  double friction_, pressed_ = 0, rubbed_ = 0;
};

/// The film of its rows, one after the other, if it also moves sideways: the impulse moves in the cone of
/// friction. `sticks_without`: whether its corner sticks if it does not.
void within_the_cone(const Setting& setting, bool sticks_without, course::Page& page);

}  // namespace byhand::contact
