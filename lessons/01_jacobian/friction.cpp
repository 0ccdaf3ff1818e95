#include "solver/constraints/friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lessons/01_jacobian/picture.hpp"
#include "lessons/tutor/rounding.hpp"
#include "renderer/space.hpp"

// (16): the same row along a tangent; one axis in the plane, two in space.
namespace byhand::lesson01 {
namespace {

using Point3 = Eigen::Vector3d;
namespace palette = renderer::palette;

/// A box that slides and spins on a floor, held against it at one corner.
struct Sliding {
  Friction<SpaceBody> friction;
  Pose<SpaceBody> floor, box;
  Velocity<SpaceBody> still, V;

  Rows<2> slip(double time) const { return friction.value<double>(floor, moved<SpaceBody, double>(box, V, time)); }
  Jacobian<SpaceBody, 2> rows() const { return friction.jacobian(floor, box); }
};

const Point3 normal(0, 0, 1);

/// The tangents turned about n by `turn` [rad]: any two at right angles will do.
Sliding sliding(const Settings& set, double turn) {
  const double length = set.length;
  const Eigen::Matrix<double, 3, 2> base = tangents_of<SpaceBody>(normal);
  Sliding at;
  const double c = std::cos(turn), s = std::sin(turn);
  at.friction.tangents << c * base.col(0) + s * base.col(1), c * base.col(1) - s * base.col(0);
  const Point3 r2 = length * Point3(0.25, -0.2, -0.15);
  at.friction.at = {0, 1, {Point3(0, 0, 0), r2}};
  at.box.rotation = space_rotation<double>(Point3(0, 0, 0.4));
  at.box.position = -rotate(at.box.rotation, r2);
  at.still.setZero();
  at.V << set.speed * Point3(0.8, 0.3, 0), set.spin * Point3(0, 0, 1);
  return at;
}

Point3 shown(const Eigen::RowVector3d& part) { return tutor::without_rounding(Point3(part)); }

void draw_sliding(renderer::Canvas& canvas, const Settings& set) {
  const double length = set.length, shaft = 0.012 * length;
  const Sliding at = sliding(set, 0);
  renderer::Space space(renderer::fit(at.box.position, 0.62 * length, {-0.55, 1, -0.5}, canvas.page()));
  space.ground({0, 0, 0}, 2 * length, length / 4);
  space.box(at.box.position, length * Point3(0.5, 0.4, 0.3), at.box.rotation, palette::body);
  const Rows<2> slip = dot(at.rows(), at.still, at.V);
  const Point3 velocity = at.friction.tangents * slip, tip = 0.3 * length * velocity.normalized();
  struct Named {
    Point3 tip;
    const char* name;
    renderer::Colour colour;
  };
  std::vector<Named> arrows = {{0.4 * length * at.friction.tangents.col(0), "t_1", palette::constraint},
                               {0.4 * length * at.friction.tangents.col(1), "t_2", palette::constraint},
                               {0.4 * length * normal, "n", palette::ink}};
  if (velocity.norm() > 0) arrows.push_back({tip, "slip", palette::velocity});
  for (const Named& arrow : arrows) space.arrow({0, 0, shaft}, arrow.tip + shaft * normal, shaft, arrow.colour);
  space.sphere({0, 0, shaft}, 1.6 * shaft, palette::error);
  canvas.draw(space);
  for (const Named& arrow : arrows) {
    const renderer::Point end = space.project(arrow.tip), way = end - space.project({0, 0, 0});
    canvas.text(end + 26 * way.normalized(), arrow.name, {.size = 22, .colour = arrow.colour, .halo = 3});
  }
}

}  // namespace

void friction(tutor::Page& page, const Settings& set) {
  const Sliding at = sliding(set, 0);
  const Jacobian<SpaceBody, 2> J = at.rows();
  page.text(
      R"(Friction has no C. It has a *rate* that should be zero: how fast P₂ slides past P₁ along the surface.
      Replace n in (15) by a tangent t.)");
  page.equation(16);
  page.text(
      R"(In the plane there is one tangent, in space there are two, and so two rows. Here a box slides@ on a floor
      and touches it with one corner. Its l₂ are the tangents, its a₂ their moments about the centre:)",
      set.spin() != 0 ? " and spins" : "");
  page.formula("t₁: l₂ = @, a₂ = @", R"(t_1:\; l_2 = @,\; a_2 = @)", shown(J.l2().row(0)), shown(J.a2().row(0)));
  page.formula("t₂: l₂ = @, a₂ = @", R"(t_2:\; l_2 = @,\; a_2 = @)", shown(J.l2().row(1)), shown(J.a2().row(1)));
  page.figure("friction",
              "A corner that slides: two tangents span the floor, and the slip is measured along both.",
              [=](renderer::Canvas& canvas) { draw_sliding(canvas, set); });
  const Rows<2> slip = dot(J, at.still, at.V);
  const double step = 1e-4 / (1 + std::abs(set.spin()));
  const Rows<2> measured = (at.slip(step) - at.slip(-step)) / (2 * step);
  page.text(
      R"(The slip along t₁ and t₂ is @ m/s: JV, with the spin of the box in it. Any two perpendicular tangents will
      do. Turn them about n and both numbers change, but not the length of the pair. A bound on each axis by itself
      makes friction depend on that choice; lesson 7 shows what that does to a slide.)",
      tutor::without_rounding(slip));

  double shortest = slip.norm(), longest = slip.norm();
  for (int i = 1; i < 24; ++i) {
    const Sliding turned = sliding(set, 2 * std::numbers::pi * i / 24);
    const double length = dot(turned.rows(), turned.still, turned.V).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  // Only the corner's turning has a third derivative: |ω|³|r|, times step²/6; then the rounding of the slip.
  const double spin = std::abs(set.spin()), arm = set.length;
  const double tolerance = step * step / 6 * spin * spin * spin * arm + 4e-15 * set.length / step;
  page.claim({.quantity = "rows of (16) in the plane",
              .unit = "1",
              .expected = 1,
              .source = "a surface's dimension",
              .measured = double(Friction<PlaneBody>::rows),
              .tolerance = tutor::absolute(0)});
  page.claim({.quantity = "rows of (16) in space",
              .unit = "1",
              .expected = 2,
              .source = "a surface's dimension",
              .measured = double(J.matrix.rows()),
              .tolerance = tutor::absolute(0)});
  page.claim({.quantity = "slip by (16) against differences of position",
              .unit = "m/s",
              .expected = tolerance,
              .source = "step²/6 · |ω|³|r|, and rounding",
              .measured = (measured - slip).cwiseAbs().maxCoeff(),
              .tolerance = tutor::at_most()});
  page.claim({.quantity = "change of |slip| while the tangents turn",
              .unit = "m/s",
              .expected = 0,
              .source = "a length does not depend on the axes",
              .measured = longest - shortest,
              .tolerance = tutor::absolute(1e-14 * (longest + 1e-3))});
}

}  // namespace byhand::lesson01
