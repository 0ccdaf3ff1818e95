#include "solver/constraints/friction.hpp"

#include "lessons/01_jacobian/picture.hpp"
#include "renderer/labels.hpp"
#include "renderer/space.hpp"

// (16): the same row along a tangent; one axis in the plane, two in space.
namespace byhand::lesson01 {
namespace {

using Point3 = Eigen::Vector3d;

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

Point3 shown(const Eigen::RowVector3d& part) { return course::without_rounding(Point3(part)); }

/// The edges of a box alone, so that its middle is seen.
void add_wire_box(renderer::Space& space, const Pose<SpaceBody>& pose, const Point3& sides, double thickness) {
  const auto corner = [&](int i) {
    const Point3 sign(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    return Point3(pose.position + rotate(pose.rotation, Point3(sign.cwiseProduct(sides))));
  };
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if (!(i & bit)) space.rod(corner(i), corner(i | bit), thickness, palette::fixed);
}

void draw_sliding(renderer::Canvas& canvas, const Settings& set) {
  const double length = set.length, shaft = 0.012 * length;
  const Sliding at = sliding(set, 0);
  renderer::Space space(renderer::fit(at.box.position, 0.62 * length, {-0.55, 1, -0.5}, canvas.page(1)));
  space.ground({0, 0, 0}, 2 * length, length / 4);
  add_wire_box(space, at.box, length * Point3(0.5, 0.4, 0.3), 0.5 * shaft);
  const Rows<2> slip = dot(at.rows(), at.still, at.V);
  const Point3 velocity = at.friction.tangents * slip, tip = 0.3 * length * velocity.normalized();
  struct Named {
    Point3 from, by;
    const char* name;
    renderer::Colour colour;
  };
  // n and the tangents at the corner, l₂ and a₂ at the centre; a₂ is a length, drawn at the scale of r₂.
  const Point3 corner(0, 0, shaft), centre = at.box.position;
  const auto a2 = [&](int row) { return Point3(at.rows().a2().row(row)); };
  std::vector<Named> arrows = {
      {centre, 0.3 * length * at.friction.tangents.col(0), "l_2 = t_1", palette::constraint},
      {centre, 0.3 * length * at.friction.tangents.col(1), "l_2 = t_2", palette::constraint},
      {corner, 0.3 * length * at.friction.tangents.col(0), "t_1", palette::ink},
      {corner, 0.3 * length * at.friction.tangents.col(1), "t_2", palette::ink},
      {corner, 0.3 * length * normal, "n", palette::ink},
      {centre, a2(0), "a_2 = r_2 × t_1", palette::constraint},
      {centre, a2(1), "a_2 = r_2 × t_2", palette::constraint}};
  if (velocity.norm() > 0) arrows.push_back({corner, tip, "slip", palette::velocity});
  space.rod(centre, corner, 0.6 * shaft, palette::muted);
  space.sphere(centre, 1.4 * shaft, palette::ink);
  for (const Named& arrow : arrows) space.arrow(arrow.from, arrow.from + arrow.by, shaft, arrow.colour);
  space.sphere(corner, 1.6 * shaft, palette::error);
  canvas.draw(space);
  renderer::Labels labels(canvas, canvas.page());
  for (const Named& arrow : arrows)
    labels.avoid_path(
        std::array<renderer::Point, 2>{space.project(arrow.from), space.project(arrow.from + arrow.by)});
  const std::array<renderer::Point, 2> arm{space.project(centre), space.project(corner)};
  labels.avoid_path(arm);
  for (const Named& arrow : arrows)
    labels.place(space.project(arrow.from + arrow.by), arrow.name, {.size = 22, .colour = arrow.colour, .halo = 3},
                 12);
  labels.place(0.5 * (arm[0] + arm[1]), "r_2", {.size = 22, .colour = palette::muted, .halo = 3}, 10);
}

}  // namespace

void friction(course::Page& page, const Settings& set) {
  const Sliding at = sliding(set, 0);
  const Jacobian<SpaceBody, 2> J = at.rows();
  page.text(
      R"(Friction has no C. It has a *rate* that should be zero: the speed at which P₂ slides past P₁ along the surface.
      Replace n in (15) by a tangent t.)");
  page.equation(16);
  page.text(
      R"(In the plane there is one tangent direction; in space a surface has a whole plane of them. Pick any two at right
      angles, t₁ and t₂: two rows. Here a box slides@ on a floor
      and touches it with one corner. Its l₂ are the tangents, its a₂ their moments about the centre:)",
      set.spin() != 0 ? " and spins" : "");
  page.formula("t₁: l₂ = @, a₂ = @", R"(t_1:\; l_2 = @,\; a_2 = @)", shown(J.l2().row(0)), shown(J.a2().row(0)));
  page.formula("t₂: l₂ = @, a₂ = @", R"(t_2:\; l_2 = @,\; a_2 = @)", shown(J.l2().row(1)), shown(J.a2().row(1)));
  page.figure("friction",
              R"(t₁ and t₂ span the floor. As in step 5, l₂ is drawn at
              the centre and a₂ about it.)",
              [=](renderer::Canvas& canvas) { draw_sliding(canvas, set); });
  const Rows<2> slip = dot(J, at.still, at.V);
  const double step = 1e-4 / (1 + std::abs(set.spin()));
  const Rows<2> measured = (at.slip(step) - at.slip(-step)) / (2 * step);
  page.text(
      R"(The slip along t₁ and t₂ is JV = @ m/s. Turn the tangents about n and both
      numbers change, but not the length of the pair. If each axis has a bound of its own, friction depends on that
      choice; lesson 7 shows what that does to a slide.)",
      course::without_rounding(slip));

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
  page.claim("rows of (16) in the plane", double(Friction<PlaneBody>::rows), "1",
             is(1, "a surface's dimension", course::absolute(0)));
  page.claim("rows of (16) in space", double(J.matrix.rows()), "1",
             is(2, "a surface's dimension", course::absolute(0)));
  page.claim("slip by (16) against differences of position", (measured - slip).cwiseAbs().maxCoeff(), "m/s",
             is(tolerance, "step²/6 · |ω|³|r|, and rounding", course::at_most()));
  page.claim("change of |slip| while the tangents turn", longest - shortest, "m/s",
             is(0, "a length does not depend on the axes", course::absolute(1e-14 * (longest + 1e-3))));
}

}  // namespace byhand::lesson01
