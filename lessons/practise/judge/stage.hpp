#pragma once

#include <functional>
#include <vector>

#include "lessons/practise/judge/film.hpp"
#include "lessons/practise/learner/practise.hpp"

// The scenes in which a film shows what a learner's piece does, every other piece being right.
namespace byhand::practise {

struct Body {
  Vec2 at{}, v{};
  double angle = 0, w = 0, mass = 1, inertia = 1;
  Vec2 sides{0.5, 0.5};
};

/// V and λ at once from M(V' − V) = Jᵀλ and JV' = `rate`, as a system of linear equations: what a course gets is
/// not to hold the formulas that its learners derive.
struct Solved {
  Velocities V;
  double lambda = 0;
};
Solved solved(const BodyRow& J, const Velocities& V, const InverseMasses& W, double rate);
/// The row's K: how much its rate changes for an impulse of 1.
double inverse_mass_along(const BodyRow& J, const InverseMasses& W);
/// What an impulse of 1 changes, M⁻¹Jᵀ as a product of matrices.
BodyRow over_masses(const BodyRow& J, const InverseMasses& W);
/// The rate of C that leaves `kept` of it after a step.
double rate_that_keeps(double C, double kept, double h);
/// ½(d² − L²) of a rod, and its slope by differences.
double rod_error(Vec2 d, double L);
BodyRow rod_slope(Vec2 r1, Vec2 r2, Vec2 d);

/// The piece of a step of a rod between two bodies that a learner wrote; the stage does the others.
struct RodPieces {
  std::function<BodyRow(Vec2 r1, Vec2 r2, Vec2 d)> jacobian = nullptr;
  std::function<double(const BodyRow& J, const InverseMasses& W)> inverse_mass = nullptr;
  std::function<double(double C, double beta, double h)> bias = nullptr;
  std::function<double(const BodyRow& J, const Velocities& V, double b, double K)> impulse = nullptr;
  std::function<void(Velocities& V, const BodyRow& J, double lambda, const InverseMasses& W)> apply = nullptr;
};

/// Two boxes, corner to corner on a rod that begins too long, three seconds without gravity.
void two_boxes(Film& film, const RodPieces& pieces);

/// One contact point of a box on the ground y = 0.
struct GroundContact {
  Vec2 r;        // from the box's centre
  double C = 0;  // height of the point [m]
};

/// Reads the height of the centre [mm] of a box whose corners meet the ground, under `gravity`; `solve` ends the
/// box's step with new velocities. The ground is drawn at `slope` [rad].
void box_on_ground(Film& film, Body box, Vec2 gravity, double slope,
                   const std::function<void(Body&, std::vector<GroundContact>&, double h)>& solve);

/// df/dt at t = 0 of a function of time [s], by differences of sixth order: only rounding is left of its error.
template <class F>
double rate_of(const F& f) {
  constexpr double t = 1e-3;
  return (45 * (f(t) - f(-t)) - 9 * (f(2 * t) - f(-2 * t)) + (f(3 * t) - f(-3 * t))) / (60 * t);
}

/// Vec2 turned by an angle [rad].
Vec2 turned(Vec2 a, double angle);
Vec2 unit(Vec2 a);

}  // namespace byhand::practise
