#include "lessons/practise/judge/stage.hpp"

#include <cmath>

namespace byhand::practise {
namespace {

constexpr double h = 1.0 / 60, beta = 0.2;
constexpr int steps = 180;

void move(Body& body) {
  body.at += h * body.v;
  body.angle += h * body.w;
}

}  // namespace

Vec2 turned(Vec2 a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

BodyRow over_masses(const BodyRow& J, const InverseMasses& W) {
  return {W.m1 * J.l1, W.I1 * J.a1, W.m2 * J.l2, W.I2 * J.a2};
}

RodPieces right_pieces() {
  return {
      .jacobian =
          [](Vec2 r1, Vec2 r2, Vec2 d) {
            return BodyRow{-d, -cross(r1, d), d, cross(r2, d)};
          },
      .inverse_mass =
          [](const BodyRow& J, const InverseMasses& W) {
            const BodyRow changed = over_masses(J, W);
            return dot(J, {changed.l1, changed.a1, changed.l2, changed.a2});
          },
      .bias = [](double C, double share, double step) { return share / step * C; },
      .impulse = [](const BodyRow& J, const Velocities& V, double b, double K) { return -(dot(J, V) + b) / K; },
      .apply = [](Velocities& V, const BodyRow& J, double lambda,
                  const InverseMasses& W) { V += lambda * over_masses(J, W); }};
}

void two_boxes(Film& film, const RodPieces& pieces) {
  Body one{.at = {-0.9, 0}, .v = {0, -0.5}, .w = 0.5, .mass = 3, .inertia = 0.4, .sides = {0.9, 0.9}};
  Body two{.at = {1.1, 0.2}, .v = {0, 1.5}, .w = -1, .mass = 1, .inertia = 0.05, .sides = {0.7, 0.4}};
  const Vec2 arm1{0.45, 0.45}, arm2{-0.35, -0.2};
  const InverseMasses W{1 / one.mass, 1 / one.inertia, 1 / two.mass, 1 / two.inertia};
  constexpr double L = 1;
  film.title = "Two boxes on a rod of 1 m that begins too long";
  film.quantity = "length of the rod";
  film.unit = "m";
  film.height = 4.5;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 r1 = turned(arm1, one.angle), r2 = turned(arm2, two.angle), P1 = one.at + r1, P2 = two.at + r2;
    const Vec2 d = P2 - P1;
    if (i % 2 == 0)
      film.frames.push_back({{{Shape::box, one.at, one.sides, one.angle},
                              {Shape::box, two.at, two.sides, two.angle},
                              {Shape::rod, P1, P2}},
                             length(d)});
    const BodyRow J = pieces.jacobian(r1, r2, d);
    const double b = pieces.bias((dot(d, d) - L * L) / 2, beta, h);
    Velocities V{one.v, one.w, two.v, two.w};
    pieces.apply(V, J, pieces.impulse(J, V, b, pieces.inverse_mass(J, W)), W);
    one.v = V.v1, one.w = V.w1, two.v = V.v2, two.w = V.w2;
    move(one);
    move(two);
  }
}

void box_on_ground(Film& film, Body box, Vec2 gravity, double slope,
                   const std::function<void(Body&, std::vector<GroundContact>&, double h)>& solve) {
  for (int i = 0; i <= steps; ++i) {
    std::vector<GroundContact> contacts;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Vec2 r = turned({x * box.sides.x, y * box.sides.y}, box.angle);
        contacts.push_back({r, box.at.y + r.y});
      }
    if (i % 2 == 0)
      film.frames.push_back({{{Shape::ground, turned({-20, 0}, slope), turned({20, 0}, slope)},
                              {Shape::box, turned(box.at, slope), box.sides, box.angle + slope}},
                             1000 * box.at.y});
    box.v += h * gravity;
    solve(box, contacts, h);
    move(box);
  }
}

}  // namespace byhand::practise
