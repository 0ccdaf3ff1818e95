#pragma once

#include "lessons/desk/vocabulary.hpp"

namespace byhand::desk {

/// A rule of differentiation that learners get wrong, and how.
enum class Slip {
  none,
  first_rate_only,       // (ab)' = a'b
  second_rate_only,      // (ab)' = ab'
  product_of_rates,      // (ab)' = a'b'
  square_without_two,    // (a·a)' = a·a'
  arm_held,              // r' = 0
  arm_reversed,          // r' = r × ω
  other_arm,             // r2' = ω2 × r1
  other_spin,            // r2' = ω1 × r2
  whole_position,        // r' = ω × (x + r)
  velocity_held,         // x' = 0
  body_sign,             // of all rates of a body
  turn_sign,             // of r' of a body
  frame_held,            // u' = 0
  frame_reversed,        // u' = u × ω
  frame_of_other_body,   // u' = ω2 × u
  world_turned,          // n' = ω × n
  length_of_rate,        // |a|' = |a'|
  length_unnormalised,   // |a|' = a·a'
  length_twice,          // |a|' = 2 a·a'/|a|
  divisor_held,          // (a/b)' = a'/b
  numerator_held,        // (a/b)' = -ab'/b²
  quotient_sign,         // (a/b)' = a'/b + ab'/b²
  root_without_half,     // √a' = a'/√a
  sine_sign,             // sin' = -cos
  cosine_sign,           // cos' = sin
  sine_kept,             // sin' = sin, cos' = -cos
  arctangent_sign,       // of atan2'
  arctangent_undivided,  // atan2' without x² + y²
  exponent_lost,         // (aⁿ)' = aⁿ⁻¹a'
};

/// A slip of one body (or -1: of any), at one of its occurrences (or -1: at all).
struct Slipping {
  Slip slip = Slip::none;
  int body = -1, occurrence = -1;
};

struct Differentiated {
  Expression rate;
  int occurrences = 0;            // of the slip
  Expression of, right, slipped;  // where it was made first
};

/// dC/dt along the motion of both bodies by rule: ẋ = v, ṙ = ω × r, constants rest.
Expression derivative(const Expression& e, const Vocabulary& words);
Differentiated derivative(const Expression& e, const Vocabulary& words, Slipping how);

/// c with e = c·w for a scalar e that is linear in the velocity w: isolates w by the triple product. Nothing if a
/// term cannot be isolated.
Expression coefficient(const Expression& e, const Symbol& w);

}  // namespace byhand::desk
