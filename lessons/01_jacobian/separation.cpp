#include "lessons/01_jacobian/picture.hpp"
#include "solver/constraints/contact.hpp"

// (23), read so that it can be computed.
namespace byhand::lesson01 {
namespace {

/// Two discs that overlap, each turned somehow; arms are kept in the discs' own frames.
struct Discs {
  double radius1, radius2;
  Pose<PlaneBody> first, second;
  Contact<PlaneBody> contact;

  double value() const { return contact.value<double>(first, second)[0]; }
};

Discs discs(double length, double distance) {
  Discs at{0.35 * length, 0.22 * length, {}, {}, {}};
  const Point n = Point(0.8, 0.6);
  at.first.rotation = plane_rotation(1.1);
  at.second.rotation = plane_rotation(-0.7);
  at.second.position = distance * n;
  at.contact.normal = n;
  at.contact.at = {0,
                   1,
                   {arm_to<PlaneBody>(at.first, at.radius1 * n),
                    arm_to<PlaneBody>(at.second, at.second.position - at.radius2 * n)}};
  return at;
}

void draw_discs(renderer::Canvas& canvas, const Discs& at, double length) {
  canvas.look(renderer::fit({-0.45 * length, -0.42 * length, 1.35 * length, 1.05 * length},
                            canvas.page(0.85).inset(10), 8));
  const Point x1 = at.first.position, x2 = at.second.position, n = at.contact.normal;
  const Point p1 = x1 + at.radius1 * n, p2 = x2 - at.radius2 * n;
  canvas.disc(x1, at.radius1, {renderer::fade(palette::body, 0.8), {palette::ink, 1.8}});
  canvas.disc(x2, at.radius2, {renderer::fade(palette::body, 0.8), {palette::ink, 1.8}});
  const Point aside(-n.y(), n.x());
  // C beside the arms' tips, whose arrow heads it would cover.
  const Point shift = 0.05 * length * -aside;
  for (const Point& tip : {p1, p2}) canvas.line(tip, tip + 1.3 * shift, {palette::muted, 1.3});
  const Point beside = 0.015 * length * aside;  // both arms lie on one line
  canvas.arrow(x1, p1, {palette::ink, 3});
  canvas.arrow(x2 + beside, p2 + beside, {palette::ink, 3});
  canvas.line(p1 + shift, p2 + shift, {palette::error, 6});
  const renderer::TextStyle style{.size = 20, .halo = 3};
  renderer::TextStyle red = style;
  red.colour = palette::error;
  red.anchor = renderer::Anchor::left;
  canvas.mark(x1, renderer::Mark::disc, palette::ink, 9);
  canvas.mark(x2, renderer::Mark::disc, palette::ink, 9);
  canvas.text(x1 - 0.05 * length * n, "x_1", style);
  canvas.text(x2 + 0.05 * length * n, "x_2", style);
  canvas.text(x1 + 0.5 * at.radius1 * n + 0.05 * length * aside, "r_1", style);
  canvas.text(x2 - 0.55 * at.radius2 * n + 0.05 * length * aside, "r_2", style);
  canvas.arrow(x2 + at.radius2 * n, x2 + (at.radius2 + 0.16 * length) * n, {palette::ink, 3});

  canvas.text(x2 + (at.radius2 + 0.2 * length) * n, "n", style);
  canvas.text((p1 + p2) / 2 - 0.09 * length * aside, course::say("C = @ m", course::Value(at.value(), 3)), red);
}

}  // namespace

void separation(course::Page& page, const Settings& set) {
  const double length = set.length, distance = 0.5 * length;
  const Discs at = discs(length, distance);
  page.text("For contacts the article also prints C itself, with x the centres of mass:");
  page.equation(23);
  page.text(
      R"(Read the brackets as a sum, and each r as the arm *in the world*, from the centre x to the contact
      point:)");
  page.formula("C = ((x₂ + r₂) − (x₁ + r₁))·n = @ m", R"(C = ((x_2 + r_2) - (x_1 + r_1)) \cdot n = @\,\mathrm{m})",
               at.value());
  page.text(
      R"(That is P₂ − P₁ along n: a length in metres, negative where the bodies overlap; the article's
      "inter-penetration depth" is −C. With n held still its rate is JV of (15). Two discs check it: their gap is the
      distance between the centres minus both radii.)");
  page.figure(
      "discs",
      course::say(R"(Two discs overlap: along n the tip of r₂ lies @ m short of that of r₁, so C < 0. (r₂ is
                          drawn a little aside.))",
                  -at.value()),
      [=](renderer::Canvas& canvas) { draw_discs(canvas, at, length); });
  const auto& arms = at.contact.at.arms;
  const double literal =
      (at.second.position + arms.second - at.first.position - arms.first).dot(at.contact.normal);
  page.text(
      R"(The arms have to be in the world's frame. These discs have turned; with arms as they are stored, in the bodies'
      own frames, (23) would give @ m.)",
      literal);
  page.claim(
      "C of (23) for two overlapping discs", at.value(), "m",
      is(distance - at.radius1 - at.radius2, "distance minus both radii", course::absolute(4e-15 * length)));
  const double apart = 0.8 * length;
  const Discs gap = discs(length, apart);
  page.claim("C of two discs that are apart", gap.value(), "m",
             is(apart - gap.radius1 - gap.radius2, "distance minus both radii", course::absolute(4e-15 * length)));
}

}  // namespace byhand::lesson01
