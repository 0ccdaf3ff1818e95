#include <random>

#include "lessons/01_jacobian/picture.hpp"
#include "lessons/pictures/acts.hpp"

// (11) to (13): how ω leaves the cross product.
namespace byhand::lesson01 {
namespace {

/// A body at the origin with its arm along x, and a rod whose other end is placed so that P₂ − P₁ is `d`.
Pair arm_and_rod(const Point& r, const Point& d) {
  Pair pair{{{0, 1, {Point(0, 0), r}}, d.norm()}, {}, {}, {0, 0, 0}, {0, 0, 0}};
  pair.pose1.position = r - d;
  return pair;
}

/// The largest |d·(ω × r) − ω·(r × d)| over random vectors in space, relative to |d| |ω| |r|.
double largest_mismatch(int draws) {
  std::mt19937_64 random(2013);
  const auto draw = [&] {
    Eigen::Vector3d v;
    for (double& x : v) x = static_cast<double>(random()) / 0x1p63 - 1;
    return v;
  };
  double largest = 0;
  for (int i = 0; i < draws; ++i) {
    const Eigen::Vector3d d = draw(), w = draw(), r = draw();
    largest =
        std::max(largest, std::abs(d.dot(w.cross(r)) - w.dot(r.cross(d))) / (d.norm() * w.norm() * r.norm()));
  }
  return largest;
}

struct Turning {
  renderer::Chart chart;
  double largest_difference = 0;
};

/// The entry a₂ while d turns once round: by (14), by turning the body a little, and by its lever arm.
Turning entry_over_direction(double arm, double size) {
  renderer::Curve entry{.label = "a₂ of (14)", .colour = palette::constraint};
  renderer::Curve probed{
      .label = "Ċ at ω₂ = 1 rad/s", .style = renderer::CurveStyle::markers, .colour = palette::error};
  Turning turning;
  for (int degrees = 0; degrees <= 360; degrees += 3) {
    const double at = degrees * std::numbers::pi / 180;
    Pair pair = arm_and_rod({arm, 0}, size * Point(std::cos(at), std::sin(at)));
    const double a2 = pair.row().a2()(0, 0), by_hand = arm * size * std::sin(at);
    turning.largest_difference = std::max(turning.largest_difference, std::abs(a2 - by_hand));
    entry.x.push_back(degrees);
    entry.y.push_back(a2);
    if (degrees % 15 != 0) continue;
    pair.V2[2] = 1;
    probed.x.push_back(degrees);
    probed.y.push_back(difference(pair, 1e-4));
  }
  turning.chart = {.x = {.label = "direction of d, from r₂ (°)",
                         .range = std::pair{0.0, 360.0},
                         .ticks = {{0, "0"}, {90, "90"}, {180, "180"}, {270, "270"}, {360, "360"}}},
                   .y = {.label = "a₂ (m²)"},
                   .curves = {probed, entry},
                   .references = {{renderer::Reference::Across::y, 0, ""}}};
  return turning;
}

void draw_lever(renderer::Canvas& canvas, const renderer::Rectangle& frame, const Pair& pair) {
  const Point r = pair.r2(), d = pair.d(), ahead = d.normalized();
  const double arm = r.norm(), size = d.norm();
  const Point foot = r - ahead * r.dot(ahead);  // where the line of d passes closest to the centre
  canvas.look(renderer::fit({-2.1 * arm, -1.15 * size, 4.6 * arm, 1.75 * size}, frame, 8));
  canvas.box({0, 0}, {2.6 * arm, 2 * arm}, 0);
  canvas.line(foot - 0.4 * arm * ahead, r + 1.2 * size * ahead, {palette::muted, 1.5, renderer::Dash::dashed});
  canvas.arrow({0, 0}, r, {palette::ink, 3});
  canvas.arrow(r, r + d, {palette::constraint, 4});
  pictures::draw_right_angle(canvas, foot, -foot, -ahead, 18);
  canvas.line({0, 0}, foot, {palette::error, 5});
  canvas.mark({0, 0}, renderer::Mark::disc, palette::ink, 10);
  const double bow = pair.row().a2()(0, 0) < 0 ? -2.7 : 2.7;
  draw_bow(canvas, {0, 0}, 0.55 * arm, std::numbers::pi - bow / 2, bow, {palette::constraint, 4});
  const renderer::TextStyle style{.size = 20, .halo = 3};
  renderer::TextStyle of_rod = style, of_lever = style, of_arm = style, of_turn = style;
  of_rod.colour = of_turn.colour = palette::constraint;
  of_lever.colour = palette::error;
  of_rod.anchor = renderer::Anchor::left;
  of_rod.offset = {12, 0};
  of_lever.anchor = renderer::Anchor::bottom_right;
  of_lever.offset = {-8, 4};
  of_arm.offset = {0, -20};
  of_turn.anchor = renderer::Anchor::bottom;
  of_turn.offset = {0, 8};
  canvas.text(r + 0.6 * d, "d", of_rod);
  canvas.text(foot / 2, "lever arm", of_lever);
  canvas.text(r / 2, "r_2", of_arm);
  canvas.text({0, 1.02 * arm}, bow < 0 ? "a_2 < 0: a clockwise arrow" : "a_2 > 0: an anticlockwise arrow",
              of_turn);
}

}  // namespace

void triple_product(course::Page& page, const Settings& set) {
  const double arm = set.length / 4, size = set.length / 2, area = arm * size;
  const Pair pair = arm_and_rod({arm, 0}, {0, -size});
  const double a2 = pair.row().a2()(0, 0);

  page.text("Name the vector between the anchor points, and multiply out (10).");
  page.equation(11);
  page.equation(12);
  page.text(
      R"(The entries of J are the coefficients of the velocities. v₁ and v₂ already have theirs, −d and d. The two ω are still inside a
      cross product. The scalar triple product takes them out: a·(b × c) is the signed volume that a, b and c span,
      and it is unchanged by a cyclic permutation of the three.)");
  page.formula("d·(ω × r) = ω·(r × d)", R"(d \cdot (\omega \times r) = \omega \cdot (r \times d))");
  page.equation(13);
  page.text(
      R"(The order matters: r × d = −d × r. Writing d × r is a common mistake in Jacobians derived by hand.)");
  page.predict(
      {.ask = course::say(
           R"(Body 2 has the arm r₂ = (@, 0) m, and d = (0, @) m. It turns anticlockwise at 1 rad/s; nothing else
                         moves. How fast does C change, with its sign? (That is a₂ of (13).))",
           arm, -size),
       .answer = a2,
       .unit = "m²/s",
       .tolerance = 0.05 * area,
       .wrong = {{-a2, "P₂ rises and d points down. This sign comes from d × r; (13) has r × d."},
                 {0, "The line of d does not pass through the centre, so P₂ moves along it."}},
       .hints = {"Which way does P₂ move, along d or against it?",
                 "a₂ = r₂ × d, in the plane the number r_x d_y − r_y d_x.",
                 course::say("@ · (@) − 0 · 0 = …", arm, -size)},
       .right = "P₂ rises, against d: the rod gets shorter, so a₂ is negative."});
  page.text(
      R"(In the plane r × d is one number, r_x d_y − r_y d_x: |d| times the lever arm, the distance at which the line of
      d passes the centre.)");
  const Turning turning = entry_over_direction(arm, size);
  page.figure("lever", "a₂ is |d| times the lever arm, with a sign.",
              [oblique = arm_and_rod({arm, 0}, size * Point(0.5, -std::sqrt(0.75)))](renderer::Canvas& canvas) {
                draw_lever(canvas, canvas.page(0.7).inset(20), oblique);
              });
  page.text(
      R"(Turn d once round the tip of the arm. At 0° and 180° its line passes through the centre: turning the body does
      not change C, and a₂ is zero. At right angles to the arm |a₂| is largest, @ m²: positive at 90°, negative at
      270°. The dots are measured: turn the body a little and see how much C changes.)",
      area);
  page.figure("entry", "a₂ while d turns round the tip of the arm.", turning.chart);
  constexpr int draws = 1000;
  const double mismatch = largest_mismatch(draws);
  page.text(
      R"(In space all three are vectors and the identity is the same: for @ random triples both sides agree to
      rounding.)",
      draws);

  page.claim("a₂ of the question", a2, "m²", is(-area, "r_x d_y − r_y d_x", course::relative(1e-14)));
  page.claim("a₂ while d turns round: largest difference", turning.largest_difference, "m²",
             is(1e-14 * area, "|r| |d| sin of the angle between them", course::at_most()));
  page.claim(
      "d·(ω × r) − ω·(r × d) in space, relative", mismatch, "1",
      is(0, "the same parallelepiped's volume", course::absolute(8 * std::numeric_limits<double>::epsilon())));
}

}  // namespace byhand::lesson01
