// Deeper: an orientation by unit quaternion, and how it is turned on.

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"

namespace byhand::space {
namespace {

using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

/// The angle of the turn from one orientation to another [rad].
double angle_between(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn = a.conjugate() * b;
  return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

Quaternion quarter(const Vector& axis) { return space_rotation(Vector(pi / 2 * axis)); }

/// The first terms of the exponential's series alone: q += ½ωq h.
Quaternion first_order(const Quaternion& q, const Vector& turn) {
  const Quaternion rate = Quaternion(0, turn.x(), turn.y(), turn.z()) * q;
  return Quaternion(q.coeffs() + 0.5 * rate.coeffs());
}

/// What a second of turning at `rate` [rad/s] gives.
struct Turned {
  double lag, stretched;  // too little [rad], and by what factor |q| is too long
};
Turned by_first_order(double rate, double h) {
  const Vector axis(0.36, 0.48, 0.8);
  Quaternion q = Quaternion::Identity();
  double goal = 0, got = 0;
  for (int i = 0; i < std::lround(1 / h); ++i) {
    const Quaternion next = first_order(q, rate * h * axis);
    got += angle_between(q.normalized(), next.normalized());
    goal += rate * h;
    q = next;
  }
  return {goal - got, q.norm()};
}
double by_exponential(double rate, double h) {
  const Vector axis(0.36, 0.48, 0.8);
  Quaternion q = Quaternion::Identity();
  const long steps = std::lround(1 / h);
  for (long i = 0; i < steps; ++i) q = rotated_by(q, Vector(rate * h * axis));
  return angle_between(q, space_rotation(Vector(static_cast<double>(steps) * rate * h * axis)));
}

Chart lag_over_rate(double h) {
  Chart chart{.x = {.label = "angle of one step ωh (rad)", .scale = Scale::logarithmic},
              .y = {.label = "error after 1 s (rad)", .scale = Scale::logarithmic}};
  Curve first{.label = "q + ½ωqh, normalised", .style = CurveStyle::markers},

      law{.label = "(ωh)³/12h · 1 s", .style = CurveStyle::theory};
  for (double turn = 0.01; turn < 2; turn *= 1.6) {
    first.x.push_back(turn);
    // Beyond half a turn it is an error of counting.
    const double lag = by_first_order(turn / h, h).lag;
    first.y.push_back(lag < pi ? lag : NAN);

    law.x.push_back(turn);
    law.y.push_back(lag < pi ? std::pow(turn, 3) / 12 * static_cast<double>(std::lround(1 / h)) : NAN);
  }
  chart.curves = {first, law};
  return chart;
}

void draw_orders(Canvas& canvas) {
  const auto cells = canvas.page().inset(16).grid(2, 3, 10);
  const Quaternion x = quarter(Vector::UnitX()), y = quarter(Vector::UnitY());
  const std::array<Quaternion, 6> stages{Quaternion::Identity(), x, y * x, Quaternion::Identity(), y, x * y};
  const std::array<const char*, 6> names{"the book", "first about x", "then about y",
                                         "the book", "first about y", "then about x"};
  for (std::size_t i = 0; i < 6; ++i) {
    // An order of turns is a row, on a narrow page a column.
    const Rectangle& cell = cells[canvas.page().is_high() ? i % 3 * 2 + i / 3 : i];
    const Rectangle frame{cell.x, cell.y, cell.width, cell.height - 32};
    Space space(pictures::from_aside({0, 0, 0}, 0.95, frame, 0.5, 0.4));
    space.ground({0, -0.75, 0}, 1.9, 0.4);
    Pose<SpaceBody> pose;
    pose.rotation = stages[i];
    pictures::add_book(space, pose, book_sides());
    const std::array<std::pair<const char*, Point3>, 2> axes{{{"x", {1.05, 0, 0}}, {"y", {0, 0.85, 0}}}};
    for (const auto& [name, tip] : axes) space.arrow({0, 0, 0}, tip, 0.015, palette::theory);
    canvas.draw(space);
    for (const auto& [name, tip] : axes)
      canvas.text(space.project(tip), name,
                  {.size = 18, .anchor = renderer::Anchor::left, .halo = 3, .offset = {8, 0}});
    canvas.text({cell.centre().x(), cell.top() - 14}, names[i], {.size = 20, .bold = true});
  }
}

}  // namespace

void orientation(const Setting& setting, Page& page) {
  const double h = setting.h, rate = setting.spin, turn = rate * h;
  const Quaternion x = quarter(Vector::UnitX()), y = quarter(Vector::UnitY());
  const double apart = angle_between(y * x, x * y);
  const Turned first = by_first_order(rate, h);
  const auto steps = static_cast<double>(std::lround(1 / h));

  page.text("In the plane an orientation is an angle, and turns add up in any order. In space they do not.");
  page.predict(
      {.ask =
           R"(Turn a book by 90° about x, then by 90° about y; turn another book first about y, then about x. By what
              angle do you have to turn the one book to make it lie like the other?)",
       .answer = degrees(apart),
       .unit = "deg",
       .tolerance = 2,
       .wrong = {{0, "Then the order would not matter. Try it with a book."},
                 {180, "That is the sum of both turns; about an oblique axis a smaller turn is enough."},
                 {90, "A quarter turn about an edge of the book does not do it; the axis is oblique."}},
       .hints =
           {"Follow where each axis of the book goes in either order.",
            "The turn that takes the second book to the first takes x to −y, −y to z and z to x: its axis is a "
            "diagonal of a cube.",
            "Three such turns are a full one: 360°/3 = …"},
       .right = "A third of a full turn about a diagonal of a cube takes each axis to the next."});
  page.figure("order_of_turns", R"(The same two quarter turns in either order (the yellow end is the book's +y).)",
              [](Canvas& canvas) { draw_orders(canvas); });
  page.text(
      R"(So adding up three angles is not enough. The solver keeps four numbers, a *unit quaternion*, q =
      (cos ½θ, sin ½θ·n) for a turn by θ about n. The product of two quaternions is one turn after the other, and one
      step at a steady ω is)");
  page.formula(
      "q ← exp(½ωh) q,   exp(½ωh) = (cos ½|ω|h, sin ½|ω|h · ω/|ω|)",
      R"(q \leftarrow \exp(\tfrac12\omega h)\,q, \qquad )"
      R"(\exp(\tfrac12\omega h) = \bigl(\cos\tfrac12|\omega|h,\ \sin\tfrac12|\omega|h\ \tfrac{\omega}{|\omega|}\bigr))");
  page.text(
      R"(Many programs use q + ½ωqh instead, with ω as (0, ω): the first two terms of the series, scaled to unit
      length afterwards. This follows a tangent of the unit sphere, as lesson 2's bob did of its circle, and turns by
      2·atan(½ωh) instead of ωh. At @ rad/s, @ rad a step, it is @° behind after a second; without scaling, |q| grows
      to @.)",
      setting.spin, Value(turn, 3), Value(degrees(first.lag), 3), Value(first.stretched, 6));
  page.figure(
      "lag",
      R"(How far q + ½ωqh, normalised, is behind after a second, against the angle of one step (below half a turn).
      Dashed: the leading term of ωh − 2·atan(½ωh), times the steps.)",
      lag_over_rate(h));

  joints_in_space(setting, page);

  page.claim("angle between the two orders", apart, "rad",
             is(2 * pi / 3, "about a cube's diagonal", absolute(1e-12)));
  page.claim("exponential: error after 1 s", by_exponential(rate, h), "rad",
             is(0, "exact for steady ω", absolute(1e-12)));
  page.claim("first order: behind after 1 s", first.lag, "rad",
             is(steps * (turn - 2 * std::atan(turn / 2)), "ωh − 2·atan(½ωh) a step", absolute(1e-6)));
  page.claim("first order, not normalised: |q| after 1 s", first.stretched, "1",
             is(std::pow(1 + turn * turn / 4, steps / 2), "√(1 + ¼(ωh)²) a step", relative(1e-10)));
}

}  // namespace byhand::space
