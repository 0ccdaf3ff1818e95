#include "lessons/04_baumgarte/faults.hpp"

namespace byhand::baumgarte {
namespace {

void fall(RodBetween& rod, const Recipe& recipe) {
  for (Body* body : {&rod.one, &rod.two})
    if (body->inverse_mass > 0) body->v.y() -= recipe.gravity * recipe.h;
}

/// (20) for one body.
void push(Body& body, double lambda, const Vector& l, double a) {
  body.v += body.inverse_mass * lambda * l;
  body.spin += body.inverse_inertia * lambda * a;
}

void move(Body& body, double h) {
  body.x += h * body.v;
  body.rotation = rotated_by(body.rotation, h * body.spin);
}

}  // namespace

void advance(RodBetween& rod, const Recipe& recipe) {
  const auto is = [&recipe](Fault fault) { return recipe.fault == fault; };
  const double h = recipe.h;
  auto& [one, two, arm1, arm2, L] = rod;
  if (!is(Fault::gravity_last)) fall(rod, recipe);

  const Vector r1 = is(Fault::lever_left) ? arm1 : one.turned(arm1);
  const Vector r2 = is(Fault::lever_left) ? arm2 : two.turned(arm2);
  const Vector d = two.x + r2 - one.x - r1;  // (11)
  double C = d.norm() - L;
  if (is(Fault::no_half)) C = d.dot(d) - L * L;
  if (is(Fault::between_centres)) C = (two.x - one.x).norm() - L;

  // (14), divided by |d| as C is
  const bool squared = is(Fault::mixed_forms) || is(Fault::no_half);
  const Vector n = squared ? d : Vector(d / d.norm());
  const Vector l1 = is(Fault::sign_of_l1) ? n : Vector(-n);
  const double turn = is(Fault::lever_backwards) ? -1 : 1;
  const double a1 = -turn * cross(r1, n).value(), a2 = turn * cross(r2, n).value();

  const double JV = l1.dot(one.v) + a1 * one.spin + n.dot(two.v) + a2 * two.spin;  // (8)
  const auto counted = [&is](double inverse_mass) {
    return is(Fault::no_mass) && inverse_mass > 0 ? 1 : inverse_mass;
  };
  const double K = (counted(one.inverse_mass) + counted(two.inverse_mass)) * n.dot(n) +
                   one.inverse_inertia * a1 * a1 + two.inverse_inertia * a2 * a2;  // (19)
  double b = recipe.beta / h * C;                                                  // (22)
  if (is(Fault::sign_of_bias)) b = -b;
  if (is(Fault::no_frame_rate)) b *= h;

  double lambda = -(JV + b) / K;  // (17)
  if (is(Fault::sign_of_lambda)) lambda = -lambda;
  if (is(Fault::lambda_times_h)) lambda *= h;
  if (!is(Fault::second_body_only)) push(one, lambda, l1, a1);
  push(two, lambda, n, a2);
  if (is(Fault::gravity_last)) fall(rod, recipe);
  for (Body* body : {&one, &two}) move(*body, h);
}

}  // namespace byhand::baumgarte
