#include "lessons/01_jacobian/picture.hpp"

#include "renderer/labels.hpp"

namespace byhand::lesson01 {

course::Value vector(const Linear<PlaneBody>& v) { return course::say("(@, @)", v.x(), v.y()); }

void draw(Canvas& canvas, const Pair& pair, const Linear<PlaneBody>& sides, const PairLook& look) {
  const Point c1 = pair.pose1.position, c2 = pair.pose2.position, p1 = c1 + pair.r1(), p2 = c2 + pair.r2();
  canvas.box(c1, sides, angle(pair.pose1.rotation));
  canvas.box(c2, sides, angle(pair.pose2.rotation));
  canvas.rod(p1, p2, {renderer::fade(palette::constraint, look.pale_rod ? 0.35 : 1), {palette::ink, 0}});
  for (const auto& [centre, tip] : {std::pair{c1, p1}, std::pair{c2, p2}}) {
    const Point head = tip - 9 / canvas.camera().scale * (tip - centre).normalized();  // beside the hinge's disc
    canvas.arrow(centre, head, {palette::muted, 1.8, renderer::Dash::dashed});
    canvas.mark(centre, renderer::Mark::cross, palette::muted, 8);
    canvas.hinge(tip);
  }
  if (!look.ends_named) return;
  const renderer::TextStyle style{.size = 20, .halo = 3};
  renderer::Labels labels(canvas, canvas.camera().frame);
  const Point along = (p2 - p1).normalized(), aside = 16 / canvas.camera().scale * Point(along.y(), -along.x()),
              inset = 0.12 * (p2 - p1);
  const std::pair<Point, Point> d{p1 + aside + inset, p2 + aside - inset};  // beside the rod
  canvas.arrow(d.first, d.second, {palette::ink, 1.8});
  for (const auto& [from, to] : {std::pair{c1, p1}, std::pair{c2, p2}, std::pair{p1, p2}, d})
    labels.avoid_path(std::vector<Point>{from, to});
  if (look.arms_named) {
    labels.place((c1 + p1) / 2, "r_1", style);
    labels.place((c2 + p2) / 2, "r_2", style);
  }
  labels.place((d.first + d.second) / 2, "d", style);
  labels.place(p1, "P_1", style, 14);
  labels.place(p2, "P_2", style, 14);
}

void draw_bow(Canvas& canvas, const Point& centre, double radius, double from, double turn, const Stroke& stroke) {
  const auto at = [&](double angle) { return Point(centre + radius * Point(std::cos(angle), std::sin(angle))); };
  if (std::abs(turn) < 1e-9) return;
  // The head is a short arrow along the bow's last stretch.
  const double head = std::min(std::abs(turn), 4.5 * stroke.width / (radius * canvas.camera().scale));
  const double neck = from + turn - std::copysign(head, turn);
  std::vector<Point> bow;
  for (int i = 0; i <= 40; ++i) bow.push_back(at(from + (neck - from) * i / 40));
  canvas.path(bow, stroke);
  canvas.arrow(at(neck), at(from + turn), {stroke.colour, 1.7 * stroke.width});
}

void draw_row(Canvas& canvas, const Jacobian<PlaneBody, 1>& J, const Point& centre1, const Point& centre2,
              const RowArrows& arrows) {
  struct Side {
    Point centre, l;
    double a;
    const std::string &l_text, &a_text;
    Point aside;
  };
  const double a1 = J.a1()(0, 0), a2 = J.a2()(0, 0), largest = std::max({std::abs(a1), std::abs(a2), 1e-12});
  const renderer::TextStyle style{.size = 20, .colour = palette::constraint, .halo = 3};
  for (const Side& side : {Side{centre1, J.l1().transpose(), a1, arrows.l1, arrows.a1, arrows.a1_aside},
                           Side{centre2, J.l2().transpose(), a2, arrows.l2, arrows.a2, arrows.a2_aside}}) {
    const Point tip = side.centre + arrows.scale * side.l, ahead = side.l.normalized();
    canvas.arrow(side.centre, tip, {palette::constraint, 4});
    // Bows open on the side away from the arrow; the larger one over 230°.
    const double back = std::atan2(-ahead.y(), -ahead.x()), turn = 4 * side.a / largest;
    draw_bow(canvas, side.centre, arrows.radius, back - turn / 2, turn, {palette::constraint, 3.4});
    renderer::TextStyle beyond = style;
    beyond.offset = {32 * ahead.x(), 18 * ahead.y()};
    canvas.text(tip, side.l_text, beyond);
    canvas.text(side.centre + side.aside, side.a_text, style);
  }
}

}  // namespace byhand::lesson01
