#pragma once

#include "lessons/04_baumgarte/setting.hpp"

// The article's step for two bodies on a rod in the plane, written out, and the ways of getting a line of it
// wrong.
namespace byhand::baumgarte {

using Vector = Linear<PlaneParticle>;

/// What is wrong with a step.
enum class Fault {
  none,
  gravity_last,      // after λ
  sign_of_lambda,    // λ = (JV + b)/K
  sign_of_l1,        // the row pushes both bodies the same way
  second_body_only,  // (20) for body 2 alone
  lambda_times_h,    // an impulse taken for a force
  no_mass,           // (19) without m⁻¹
  mixed_forms,       // C = |d| − L, but the J of ½(d² − L²)
  sign_of_bias,      // b = −(β/h)C
  no_half,           // C = d² − L², but the J of ½(d² − L²)
  no_frame_rate,     // b = βC
  lever_backwards,   // n × r for r × n
  lever_left,        // r does not turn with its body
  between_centres    // C of the centres, J of the anchors
};

/// A rigid body, or a bob if nothing can turn it; the world if nothing can move it.
struct Body {
  Vector x = Vector::Zero(), v = Vector::Zero();  // [m], [m/s]
  PlaneRotation<double> rotation = {1, 0};
  double spin = 0;                               // [rad/s]
  double inverse_mass = 0, inverse_inertia = 0;  // [1/kg], [1/(kg m²)]

  Vector turned(const Vector& arm) const { return rotate(rotation, arm); }
};

/// Two bodies on a rod. The arms [m] lead from the centres to its ends, in the frames of the bodies.
struct RodBetween {
  Body one = {}, two = {};
  Vector arm1 = Vector::Zero(), arm2 = Vector::Zero();
  double length = 0;  // [m]

  /// From the rod's end on body 1 to that on body 2 [m].
  Vector d() const { return two.x + two.turned(arm2) - one.x - one.turned(arm1); }
  /// By how much the rod is too long [m].
  double too_long() const { return d().norm() - length; }
};

/// How to step. Only bodies that can move fall.
struct Recipe {
  double beta = 0, h = 1.0 / 60, gravity = standard_gravity;  // [1], [s], [m/s²]
  Fault fault = Fault::none;
};

/// One time step.
void advance(RodBetween& rod, const Recipe& recipe);

}  // namespace byhand::baumgarte
