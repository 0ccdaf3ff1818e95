#include "solver/constraints/contact.hpp"

#include "lessons/01_jacobian/picture.hpp"

// (15): the same recipe along a normal, and the term that it drops.
namespace byhand::lesson01 {
namespace {

/// A tilted plank (body 1) and a box (body 2) whose corner touches it; the normal is the plank's.
struct Touch {
  Contact<PlaneBody> contact;
  Pose<PlaneBody> plank, box;
  Velocity<PlaneBody> V1, V2;
  Linear<PlaneBody> plank_sides, box_sides;

  Linear<PlaneBody> normal_of_plank() const { return rotate(plank.rotation, Linear<PlaneBody>(0, 1)); }
  Linear<PlaneBody> along_plank() const { return rotate(plank.rotation, Linear<PlaneBody>(1, 0)); }
  Jacobian<PlaneBody, 1> row() const { return contact.jacobian(plank, box); }
  double value() const { return contact.value<double>(plank, box)[0]; }

  /// The same after `time` [s]; the normal turns with the plank, as a surface's normal does.
  Touch after(double time) const {
    Touch later = *this;
    later.plank = moved<PlaneBody, double>(plank, V1, time);
    later.box = moved<PlaneBody, double>(box, V2, time);
    later.contact.normal = later.normal_of_plank();
    return later;
  }
};

/// `gap` and `aside` [m]: where P₂ lies from P₁, along n and along the surface.
Touch touch(const Settings& set, double gap, double aside) {
  const double length = set.length, speed = set.speed, spin = set.spin;
  Touch at;
  at.plank_sides = length * Linear<PlaneBody>(1.5, 0.15);
  at.box_sides = length * Linear<PlaneBody>(0.55, 0.4);
  at.plank.rotation = plane_rotation(0.25);
  at.box.rotation = plane_rotation(0.6);
  const Linear<PlaneBody> r1(0.15 * length, 0.075 * length), r2 = -0.5 * at.box_sides;
  at.contact.at = {0, 1, {r1, r2}};
  at.contact.normal = at.normal_of_plank();
  at.box.position = rotate(at.plank.rotation, r1) + gap * at.contact.normal + aside * at.along_plank() -
                    rotate(at.box.rotation, r2);
  at.V1 = {0.05 * speed, 0.1 * speed, 0.5 * spin};
  at.V2 = {-0.2 * speed, 0.3 * speed, -spin};
  return at;
}

double difference(const Touch& at, double step) {
  return (at.after(step).value() - at.after(-step).value()) / (2 * step);
}

struct Dropped {
  double slope = 0;           // of Ċ − JV over the sideways offset [1/s]
  double straight_above = 0;  // the largest |Ċ − JV| with no sideways offset [m/s]
};

Dropped dropped_term(const Settings& set, double step) {
  const auto missing = [&](double gap, double aside) {
    const Touch at = touch(set, gap, aside);
    return difference(at, step) - dot(at.row(), at.V1, at.V2)[0];
  };
  const double reach = set.length / 20;
  Dropped dropped;
  dropped.slope = (missing(0, reach) - missing(0, -reach)) / (2 * reach);
  for (int i = -10; i <= 10; ++i)
    dropped.straight_above = std::max(dropped.straight_above, std::abs(missing(reach * i / 10, 0)));
  return dropped;
}

void draw_touch(renderer::Canvas& canvas, const Settings& set) {
  const double length = set.length;
  const Touch at = touch(set, -0.02 * length, 0);
  const Point n = at.contact.normal, p1 = at.plank.position + rotate(at.plank.rotation, at.contact.at.arms.first);
  const Point p2 = at.box.position + rotate(at.box.rotation, at.contact.at.arms.second);
  const bool narrow = canvas.page().is_high();
  canvas.look(
      renderer::fit({-0.95 * length, -0.7 * length, 1.9 * length, 1.55 * length}, canvas.page(0.95).inset(10), 8));
  canvas.box(at.plank.position, at.plank_sides, angle(at.plank.rotation), renderer::fixed_look);
  canvas.box(at.box.position, at.box_sides, angle(at.box.rotation));
  canvas.line(at.plank.position, p1, {palette::muted, 1.8, renderer::Dash::dashed});
  canvas.line(at.box.position, p2, {palette::muted, 1.8, renderer::Dash::dashed});
  const Jacobian<PlaneBody, 1> J = at.row();
  draw_row(canvas, J, at.plank.position, at.box.position,
           {.scale = 0.36 * length,
            .radius = 0.11 * length,
            .l1 = "l_1 = −n",
            .a1 = course::say("a_1 = −r_1 × n = @ m", course::Value(J.a1()(0, 0), 3)),
            .l2 = "l_2 = n",
            .a2 = course::say("a_2 = r_2 × n = @ m", course::Value(J.a2()(0, 0), 3)),
            .a1_aside = {-0.38 * length, -0.3 * length},
            .a2_aside = length * (narrow ? Point(0.4, 0.3) : Point(0.68, -0.02))});
  canvas.arrow(p1, p1 + 0.25 * length * n, {palette::ink, 3});
  renderer::TextStyle style{.size = 20, .anchor = renderer::Anchor::right, .halo = 3, .offset = {-10, 6}};
  canvas.text(p1 + 0.25 * length * n, "n", style);
  for (const Point& p : {p1, p2}) canvas.mark(p, renderer::Mark::disc, palette::error, 8);
  const renderer::TextStyle name{.size = 20, .colour = palette::muted, .halo = 3};
  canvas.text(at.plank.position - 0.6 * length * at.along_plank(), "body 1", name);
  canvas.text(at.box.position + length * Linear<PlaneBody>(0.13, 0.18), "body 2", name);
  const Point along = at.along_plank();
  canvas.text(at.plank.position + length * (0.056 * along - 0.035 * n), "r_1", name);
  canvas.text(0.5 * (at.box.position + p2) - 0.05 * length * along, "r_2", name);
  const renderer::TextStyle point{.size = 20, .colour = palette::error, .halo = 3};
  canvas.text(p1 + length * (0.04 * n - 0.07 * along), "P_1", point);
  canvas.text(p2 + length * (0.07 * along - 0.03 * n), "P_2", point);
}

}  // namespace

void contact(course::Page& page, const Settings& set) {
  const double length = set.length, step = 1e-4 * length / (length * std::abs(set.spin()) + set.speed);
  const Touch at = touch(set, -0.02 * length, 0);
  const Jacobian<PlaneBody, 1> J = at.row();

  page.text(
      R"(The same steps, another constraint. Two bodies meet at P₁ and P₂; n is the unit normal there. C = (P₂ − P₁)·n is
      the signed gap along n, and must not be negative. Differentiate, isolate the velocities, read off the
      coefficients: n takes the place of d in (14). In the figure body 1 is a tilted plank and body 2 a box whose corner
      has sunk @ cm into it. Their row is:)",
      course::Value(-100 * at.value(), 3));
  page.equation(15, "J = [ @  @  @  @ ]", R"(J = \begin{bmatrix} @ & @ & @ & @ \end{bmatrix})",
                vector(J.l1().transpose()), J.a1()(0, 0), vector(J.l2().transpose()), J.a2()(0, 0));
  page.excerpt("solver/constraints/contact.hpp", "jacobian");
  page.figure("contact", "The contact's row on its two bodies.",
              [=](renderer::Canvas& canvas) { draw_touch(canvas, set); });

  Touch turned = at, exchanged = at;
  turned.contact.normal = -at.contact.normal;
  std::swap(exchanged.contact.at.arms.first, exchanged.contact.at.arms.second);
  const auto row_of_exchanged = [&](const Linear<PlaneBody>& normal) {
    exchanged.contact.normal = normal;
    const Jacobian<PlaneBody, 1> other = exchanged.contact.jacobian(at.box, at.plank);
    Jacobian<PlaneBody, 1> by_body;  // the plank's part first again
    by_body.matrix << other.side2(), other.side1();
    return by_body;
  };
  const double kept = (row_of_exchanged(at.contact.normal).matrix + J.matrix).norm() / J.matrix.norm();
  const double flipped = (row_of_exchanged(-at.contact.normal).matrix - J.matrix).norm() / J.matrix.norm();
  page.text(
      R"(*Which way does the normal point?* From body 1 to body 2. Then JV > 0 means that they separate, C < 0 that
      they overlap, and the push that keeps them apart has λ ≥ 0. Number the bodies the other way round and reverse
      n as well, and every arrow stays on its body. Forget to reverse n and the whole row changes sign: the solver then
      takes an overlap for a gap and holds the bodies together when they separate. A rod does not need this care; a contact does.)");

  const Dropped dropped = dropped_term(set, step);
  const double w1 = at.V1[2];
  page.text(
      R"(*What is left out?* C is a product of two factors that change, so Ċ has two terms: (Ṗ₂ − Ṗ₁)·n, which is (15),
      and (P₂ − P₁)·ṅ, which is dropped. When is that allowed? ṅ is perpendicular to n, so a gap or an overlap along n
      adds nothing. The turning of the normal matters only if P₂ is offset sideways from P₁: it adds −ω₁ times
      the offset, counted to the right along n. Contact points are chosen opposite each other, and there the dropped term is zero.)");
  if (std::abs(w1) > 1e-6 * set.speed / length)
    page.text("Here the plank turns at @ rad/s: each millimetre of offset changes the true Ċ by @ mm/s.",
              course::Value(w1, 3), course::Value(dropped.slope, 3));
  else
    page.text("Here the plank does not turn, so (15) leaves out nothing wherever P₂ lies.");
  page.text("`./lessons/run desk --task 5` derives (15) with a fixed normal, `--task 6` with a turning axis.");

  const double C = -0.02 * length;
  page.claim("C of the box and the plank", at.value(), "m",
             is(C, "the overlap, negative", course::absolute(1e-14 * length)));
  page.claim("exchange the bodies and reverse n: change of the row, relative", flipped, "1",
             is(0, "C is the same", course::absolute(1e-14)));
  // Central differences: speeds times (turn in a step)²/6, a few times over, and rounding of C over the step.
  page.claim("exchange the bodies, keep n: row + old row, relative", kept, "1",
             is(0, "C changes its sign", course::absolute(1e-14)));
  const double turn = (2 * std::abs(set.spin()) + set.speed / length) * step;
  const double speeds = set.speed + length * std::abs(set.spin());
  const double tolerance = 4 * speeds * turn * turn + 1e-14 * length / step;
  page.claim("what (15) drops, no sideways offset", dropped.straight_above, "m/s",
             is(tolerance, "ṅ is perpendicular to n; the differences' own error", course::at_most()));
  page.claim("what (15) drops, per metre of sideways offset", dropped.slope, "(m/s)/m",
             is(-w1, "(P₂ − P₁)·ṅ with ṅ = ω₁ × n", course::absolute(20 * tolerance / length)));
}

}  // namespace byhand::lesson01
