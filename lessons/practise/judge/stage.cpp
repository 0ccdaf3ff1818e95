#include "lessons/practise/judge/stage.hpp"

#include <Eigen/LU>
#include <cmath>

namespace byhand::practise {
namespace {

constexpr double h = 1.0 / 60, beta = 0.2;
constexpr int steps = 180;

using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 column(const BodyRow& J) {
  Vector6 x;
  x << J.l1.x, J.l1.y, J.a1, J.l2.x, J.l2.y, J.a2;
  return x;
}
Vector6 column(const Velocities& V) { return column(BodyRow{V.v1, V.w1, V.v2, V.w2}); }
Eigen::DiagonalMatrix<double, 6> diagonal(const InverseMasses& W) {
  Vector6 x;
  x << W.m1, W.m1, W.I1, W.m2, W.m2, W.I2;
  return Eigen::DiagonalMatrix<double, 6>(x);
}

void move(Body& body) {
  body.at += h * body.v;
  body.angle += h * body.w;
}

}  // namespace

Vec2 turned(Vec2 a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

Vec2 unit(Vec2 a) { return a / length(a); }

Solved solved(const BodyRow& J, const Velocities& V, const InverseMasses& W, double rate) {
  Eigen::Matrix<double, 7, 7> A = Eigen::Matrix<double, 7, 7>::Identity();
  A.topRightCorner<6, 1>() = -(diagonal(W) * column(J));
  A.bottomLeftCorner<1, 6>() = column(J).transpose();
  A(6, 6) = 0;
  Eigen::Matrix<double, 7, 1> right;
  right << column(V), rate;
  const Eigen::Matrix<double, 7, 1> x = A.partialPivLu().solve(right);
  return {{{x[0], x[1]}, x[2], {x[3], x[4]}, x[5]}, x[6]};
}

double inverse_mass_along(const BodyRow& J, const InverseMasses& W) { return 1 / solved(J, {}, W, 1).lambda; }

BodyRow over_masses(const BodyRow& J, const InverseMasses& W) {
  const Vector6 x = diagonal(W) * column(J);
  return {{x[0], x[1]}, x[2], {x[3], x[4]}, x[5]};
}

double rate_that_keeps(double C, double kept, double step) { return (kept * C - C) / step; }

double rod_error(Vec2 d, double L) { return (dot(d, d) - L * L) / 2; }

BodyRow rod_slope(Vec2 r1, Vec2 r2, Vec2 d) {
  constexpr double t = 1e-4;
  Vector6 slope;
  for (int i = 0; i < 6; ++i) {
    const auto error = [&](double by) {
      Vector6 moved = Vector6::Zero();
      moved[i] = by;
      return rod_error(d + Vec2{moved[3], moved[4]} + turned(r2, moved[5]) - r2 - Vec2{moved[0], moved[1]} -
                           turned(r1, moved[2]) + r1,
                       0);
    };
    slope[i] = (8 * (error(t) - error(-t)) - (error(2 * t) - error(-2 * t))) / (12 * t);
  }
  return {{slope[0], slope[1]}, slope[2], {slope[3], slope[4]}, slope[5]};
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
  for (int i = 0; i <= steps; ++i) {
    const Vec2 r1 = turned(arm1, one.angle), r2 = turned(arm2, two.angle), P1 = one.at + r1, P2 = two.at + r2;
    const Vec2 d = P2 - P1;
    if (i % 2 == 0)
      film.frames.push_back({{{Shape::box, one.at, one.sides, one.angle},
                              {Shape::box, two.at, two.sides, two.angle},
                              {Shape::rod, P1, P2}},
                             length(d)});
    const double C = rod_error(d, L);
    const BodyRow J = pieces.jacobian ? pieces.jacobian(r1, r2, d) : rod_slope(r1, r2, d);
    const double rate = pieces.bias ? -pieces.bias(C, beta, h) : rate_that_keeps(C, 1 - beta, h);
    Velocities V{one.v, one.w, two.v, two.w};
    const Solved right = solved(J, V, W, rate);
    const double K = inverse_mass_along(J, W);
    double lambda = pieces.impulse ? pieces.impulse(J, V, -rate, K) : right.lambda;
    if (pieces.inverse_mass) lambda *= K / pieces.inverse_mass(J, W);
    if (pieces.apply)
      pieces.apply(V, J, lambda, W);
    else
      V += lambda * over_masses(J, W);
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
