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

/// The pieces of one step of a rod between two bodies, in the order of the article.
struct RodPieces {
  std::function<BodyRow(Vec2 r1, Vec2 r2, Vec2 d)> jacobian;
  std::function<double(const BodyRow& J, const InverseMasses& W)> inverse_mass;
  std::function<double(double C, double beta, double h)> bias;
  std::function<double(const BodyRow& J, const Velocities& V, double b, double K)> impulse;
  std::function<void(Velocities& V, const BodyRow& J, double lambda, const InverseMasses& W)> apply;
};
RodPieces right_pieces();

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

/// Vec2 turned by an angle [rad].
Vec2 turned(Vec2 a, double angle);

/// M⁻¹Jᵀ.
BodyRow over_masses(const BodyRow& J, const InverseMasses& W);

}  // namespace byhand::practise
