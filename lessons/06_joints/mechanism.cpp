#include "lessons/06_joints/mechanism.hpp"

#include "lessons/06_joints/setting.hpp"

namespace byhand::joints {

namespace {

Point direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

Bar bar_of(const Pose<PlaneBody>& pose, double length) {
  const Point half = length / 2 * Point(pose.rotation.cos, pose.rotation.sin);
  return {pose.position - half, pose.position + half};
}

void draw_bar(Canvas& canvas, const Bar& bar, double thickness, const Look& look) {
  canvas.rod(bar.from, bar.to, look, thickness);
}

void draw_weld(Canvas& canvas, const Point& at) {
  const double side = 26 / canvas.camera().scale;
  canvas.box(at, {side, side}, 0, {palette::constraint, {palette::ink, 1.8}});
}

void draw_sleeve(Canvas& canvas, const Point& at, double angle) {
  const double scale = canvas.camera().scale;
  canvas.box(at, {44 / scale, 26 / scale}, angle, {palette::constraint, {palette::ink, 1.8}});
}

void draw_rail(Canvas& canvas, const Point& at, double angle, double reach) {
  canvas.line(at - reach * direction(angle), at + reach * direction(angle), {palette::muted, 4});
}

void draw_stop(Canvas& canvas, const Point& hinge, double angle, double length) {
  const Point along = length * direction(angle), aside = 9 / canvas.camera().scale * direction(angle - pi / 2);
  canvas.ground(hinge + aside + 0.25 * along, hinge + aside + along);
}

void draw_turn(Canvas& canvas, const Point& hinge, double from, double to, double radius, const Stroke& stroke) {
  constexpr int pieces = 40;
  std::vector<Point> arc;
  const double head = 16 / (canvas.camera().scale * radius);  // what the arrow's head takes of the way [rad]
  const double shaft = std::copysign(std::max(0.0, std::abs(to - from) - head), to - from);
  for (int i = 0; i <= pieces; ++i) arc.push_back(hinge + radius * direction(from + shaft * i / pieces));
  canvas.path(arc, stroke);
  canvas.arrow(arc.back(), hinge + radius * direction(to), stroke);
}

}  // namespace byhand::joints
