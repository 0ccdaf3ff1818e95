#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

#include "lessons/scene_file/scene_file.hpp"

// The members of everything that a file describes, once for reading, writing and the schema: each is a function
// that shows them to an Io in turn.
namespace byhand::scene_file {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A member that is a number.
struct Number {
  const char *name, *unit, *meaning;
  double low = -endless, high = endless;
  std::optional<double> otherwise = {};  // where the member is missing; empty: it has to be there
  bool above_low = false;                // whether `low` itself is not allowed
  bool may_be_infinite = false;          // then "infinite" may be written
  bool angle = false;                    // then "30°" may be written
};

inline Number softness(const char* unit) {
  return {.name = "softness",
          .unit = unit,
          .meaning = "γ of (17), for each row",
          .low = 0,
          .high = 1e300,
          .otherwise = 0};
}
inline constexpr Number stiffness{.name = "stiffness",
                                  .unit = "N/m or N m/rad",
                                  .meaning = "k of Hooke's law",
                                  .low = 0,
                                  .high = 1e300,
                                  .above_low = true};
inline constexpr Number damping{.name = "damping",
                                .unit = "N s/m or N m s/rad",
                                .meaning = "c of the damper beside it",
                                .low = 0,
                                .high = 1e300,
                                .otherwise = 0};
inline constexpr Number strength{.name = "strength",
                                 .unit = "N m or N",
                                 .meaning = "largest torque or force",
                                 .low = 0,
                                 .may_be_infinite = true};
inline constexpr Number friction{.name = "friction",
                                 .unit = "1",
                                 .meaning = "μ; two that touch have √(μ₁μ₂)",
                                 .low = 0,
                                 .high = 1e300,
                                 .otherwise = 0.6};
inline constexpr Number contact_margin{.name = "contact_margin",
                                       .unit = "m",
                                       .meaning = "bodies nearer than this get a contact",
                                       .low = 0,
                                       .high = 1e300,
                                       .otherwise = 0.02,
                                       .above_low = true};
inline constexpr Number contact_lookahead{.name = "contact_lookahead",
                                          .unit = "1",
                                          .meaning = "plus so many steps of their speed",
                                          .low = 0,
                                          .high = 1e300,
                                          .otherwise = 1};
inline constexpr Number restitution{.name = "restitution",
                                    .unit = "1",
                                    .meaning = "e; the larger of two that touch counts",
                                    .low = 0,
                                    .high = 1,
                                    .otherwise = 0};

// Freedoms of joints.
template <class Io, class M>
void members(Io& io, Slide<M>& freedom) {
  io.anchors(freedom);
  io.direction("axis1", freedom.axis, freedom.body1);
}
template <class Io, class M>
void members(Io& io, Turn<M>& freedom) {
  io.bodies(freedom.body1, freedom.body2);
  io.rest(freedom.rest, freedom.body1, freedom.body2);
  if constexpr (M::angular == 3) io.direction("axis1", freedom.axis, freedom.body1);
}
template <class Io, class M>
void members(Io& io, Swing<M>& freedom) {
  io.bodies(freedom.body1, freedom.body2);
  io.direction("axis1", freedom.axis1, freedom.body1);
  io.direction("axis2", freedom.axis2, freedom.body2);
}

// Constraints.
template <class Io, class M>
void members(Io& io, Distance<M>& rod) {
  io.anchors(rod.at);
  io.length(rod.length, rod.at);
  io.number(softness("m²/kg"), rod.softness);
}
template <class Io, class M>
void members(Io& io, NormalisedDistance<M>& rod) {
  io.anchors(rod.at);
  io.length(rod.length, rod.at);
  io.number(softness("1/kg"), rod.softness);
}
template <class Io, class M>
void members(Io& io, Rope<M>& rope) {
  io.anchors(rope.at);
  io.length(rope.length, rope.at);
  io.number(softness("1/kg"), rope.softness);
}
template <class Io, class M>
void members(Io& io, Spring<M>& spring) {
  io.anchors(spring.at);
  io.length(spring.length, spring.at);
  io.number(stiffness, spring.elastic.stiffness);
  io.number(damping, spring.elastic.damping);
}
template <class Io, class M>
void members(Io& io, Pin<M>& pin) {
  io.anchors(pin.at);
  io.number(softness("1/kg"), pin.softness);
}
template <class Io, class M>
void members(Io& io, Weld<M>& weld) {
  io.anchors(weld.at);
  io.rest(weld.right.rest, weld.at.body1, weld.at.body2);
  io.number(softness("1/kg"), weld.softness);
}
template <class Io, class M>
void members(Io& io, Slider<M>& slider) {
  io.anchors(slider.at);
  io.across(slider.across, slider.at.body1);
  io.rest(slider.right.rest, slider.at.body1, slider.at.body2);
  io.number(softness("1/kg"), slider.softness);
}
template <class Io, class M>
void members(Io& io, Hinge<M>& hinge) {
  io.anchors(hinge.at);
  io.across(hinge.across, hinge.at.body1);
  io.direction("axis2", hinge.axis, hinge.at.body2);
  io.number(softness("1/kg"), hinge.softness);
}
template <class Io, class M, template <class> class Freedom>
void members(Io& io, Limit<M, Freedom>& limit) {
  members(io, limit.at);
  io.stop(limit.place, limit.stop);
  io.number(softness("1/(kg m²) or 1/kg"), limit.softness);
}
template <class Io, class M, template <class> class Freedom>
void members(Io& io, Motor<M, Freedom>& motor) {
  members(io, motor.at);
  io.number({.name = "speed", .unit = "rad/s or m/s", .meaning = "at which it drives its freedom", .angle = true},
            motor.speed);
  io.number(strength, motor.strength);
}
template <class Io, class M, template <class> class Freedom>
void members(Io& io, Servo<M, Freedom>& servo) {
  members(io, servo.at);
  io.number({.name = "target", .unit = "rad or m", .meaning = "where it drives its freedom", .angle = true},
            servo.target);
  io.number(stiffness, servo.elastic.stiffness);
  io.number(damping, servo.elastic.damping);
  io.number(strength, servo.strength);
}
inline constexpr Number coefficient{
    .name = "friction", .unit = "1", .meaning = "μ of this contact", .low = 0, .high = 1e300, .otherwise = 0};
template <class Io, class M>
void members(Io& io, Contact<M>& contact) {
  io.anchors(contact.at);
  io.vector("normal", "unit vector from the first body to the second, in the world", contact.normal);
  io.number(softness("1/kg"), contact.softness);
  io.number(restitution, contact.restitution);
}
template <class Io, class M, int K>
void members(Io& io, FrictionAlong<M, K>& slip) {
  io.anchors(slip.at);
  io.columns("tangents", "unit vectors at right angles to the normal, in the world", slip.tangents);
  io.number(coefficient, slip.coefficient);
  io.contact(slip.contact);
  io.number(softness("1/kg"), slip.softness);
}
template <class Io, class M>
void members(Io& io, ContactManifold<M>& contact) {
  io.anchors(contact.at);
  io.arms("second_arms", "arms of the face's other end, in the bodies' frames [m]", contact.second);
  io.flag("single", "whether they touch at the first end alone", contact.point, false);
  io.vector("normal", "unit vector from the first body to the second, in the world", contact.normal);
  io.number(coefficient, contact.coefficient);
  io.number(restitution, contact.restitution);
  io.number(softness("1/kg"), contact.softness);
}

/// Calls f.template operator()<Kind>("name", "freedom or empty") for each kind that scenes of a model can have.
template <class M, class F>
void for_each_kind(F&& f) {
  f.template operator()<Distance<M>>("distance", "");
  f.template operator()<NormalisedDistance<M>>("normalised_distance", "");
  f.template operator()<Rope<M>>("rope", "");
  f.template operator()<Spring<M>>("spring", "");
  f.template operator()<Pin<M>>("pin", "");
  f.template operator()<Contact<M>>("contact", "");
  f.template operator()<Friction<M>>("friction", "");
  if constexpr (M::linear == 3) f.template operator()<AxisFriction<M>>("axis_friction", "");
  if constexpr (M::angular > 0) {
    f.template operator()<Weld<M>>("weld", "");
    f.template operator()<Slider<M>>("slider", "");
    f.template operator()<Limit<M, Turn>>("limit", "turn");
    f.template operator()<Limit<M, Slide>>("limit", "slide");
    f.template operator()<Motor<M, Turn>>("motor", "turn");
    f.template operator()<Motor<M, Slide>>("motor", "slide");
    f.template operator()<Servo<M, Turn>>("servo", "turn");
    f.template operator()<Servo<M, Slide>>("servo", "slide");
  }
  if constexpr (M::angular == 3) {
    f.template operator()<Limit<M, Swing>>("limit", "swing");
    f.template operator()<Hinge<M>>("hinge", "");
  }
  if constexpr (M::angular == 1) f.template operator()<ContactManifold<M>>("contact_manifold", "");
}

// Methods.
inline Number counted(const char* name, const char* meaning, double otherwise) {
  return {.name = name, .unit = "", .meaning = meaning, .low = 1, .high = 1e9, .otherwise = otherwise};
}
inline constexpr Number relaxation{.name = "relaxation",
                                   .unit = "1",
                                   .meaning = "ω; other than 1 this is SOR",
                                   .low = 0,
                                   .high = 1.999999,
                                   .otherwise = 1,
                                   .above_low = true};
inline Number tolerance(double otherwise) {
  return {.name = "tolerance",
          .unit = "1",
          .meaning = "stop at this share of the largest λ",
          .low = 0,
          .high = 1,
          .otherwise = otherwise};
}
template <class Io>
void members(Io& io, ByGraph& solver) {
  io.number({.name = "unlike",
             .unit = "1",
             .meaning = "ratio of masses from which Newton's method begins at once",
             .low = 1,
             .high = 1e300,
             .otherwise = 50},
            solver.unlike);
}
template <class Io>
void members(Io& io, GaussSeidel& solver) {
  io.whole(counted("sweeps", "over all rows", 10), solver.sweeps);
  io.flag("warm_start", "begin with the last step's λ", solver.warm_start, true);
  io.name("order", "of the rows", solver.order, {"natural", "reverse", "coloured", "symmetric"});
  io.name("block", "how the rows of one constraint are solved", solver.block_solve, {"whole", "row_by_row"});
  io.number(relaxation, solver.relaxation);
  io.number(tolerance(0), solver.tolerance);
}
template <class Io>
void members(Io& io, Jacobi& solver) {
  io.whole(counted("sweeps", "over all rows", 10), solver.sweeps);
  io.flag("warm_start", "begin with the last step's λ", solver.warm_start, true);
  io.name("block", "how the rows of one constraint are solved", solver.block_solve, {"whole", "row_by_row"});
  io.number(relaxation, solver.relaxation);
}
template <class Io>
void members(Io& io, ConjugateSweeps& solver) {
  io.whole(counted("sweeps", "over all rows at most", 50), solver.sweeps);
  io.number(tolerance(1e-6), solver.tolerance);
}
template <class Io>
void members(Io& io, Direct& solver) {
  io.number({.name = "regularisation",
             .unit = "1",
             .meaning = "share of each row's JM⁻¹Jᵀ that is added to its γ",
             .low = 0,
             .high = 1,
             .otherwise = 0},
            solver.regularisation);
}
template <class Io>
void members(Io& io, SemismoothNewton& solver) {
  io.whole(counted("rounds", "factorisations at most", 20), solver.rounds);
}
inline constexpr Number beta{.name = "beta",
                             .unit = "1",
                             .meaning = "β, the share of an error that a step takes back",
                             .low = 0,
                             .high = 3,
                             .otherwise = 0.2};
inline constexpr Number slop{.name = "slop",
                             .unit = "m",
                             .meaning = "overlap that is not corrected",
                             .low = 0,
                             .high = 1e300,
                             .otherwise = 0.001};
template <class Io>
void members(Io&, NoDriftCure&) {}
template <class Io>
void members(Io& io, Baumgarte& cure) {
  io.number(beta, cure.beta);
  io.number(slop, cure.slop);
}
template <class Io>
void members(Io& io, SplitImpulse& cure) {
  io.number(beta, cure.beta);
  io.number(slop, cure.slop);
}
template <class Io>
void members(Io& io, Projection& cure) {
  io.whole(counted("projection_sweeps", "over all rows that have a C", 4), cure.sweeps);
  io.number(slop, cure.slop);
}
template <class Io>
void members(Io& io, SoftConstraints& cure) {
  io.number({.name = "frequency",
             .unit = "rad/s",
             .meaning = "ω of each row",
             .low = 0,
             .high = 1e300,
             .otherwise = 90,
             .above_low = true},
            cure.frequency);
  io.number(
      {.name = "damping_ratio", .unit = "1", .meaning = "ζ of each row", .low = 0, .high = 1e300, .otherwise = 1},
      cure.damping_ratio);
  io.flag("relax", "solve again without bias", cure.relax, true);
  io.flag("refresh", "with rows at the new poses", cure.refresh, true);
  io.number(slop, cure.slop);
}
template <class Io>
void members(Io& io, VelocityStepping& method) {
  io.one_of("solver", "of the rows", method.solver, row_solver_names, 5);
  io.one_of("cure", "of drift", method.drift, drift_cure_names, 1);
  io.whole(counted("substeps", "equal parts of a step", 1), method.substeps);
}

}  // namespace byhand::scene_file
