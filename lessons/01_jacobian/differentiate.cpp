#include "lessons/01_jacobian/picture.hpp"

// (9) and (10): the rate of C, from the velocities of the two ends.
namespace byhand::lesson01 {
namespace {

/// Ċ of (9) for a bob that moves at `v` while the other end stays fixed, from (8) [m²/s].
double rate_of_bob(const Linear<PlaneParticle>& d, const Linear<PlaneParticle>& v, double length) {
  const Distance<PlaneParticle> rod{{0, 1}, length};
  Pose<PlaneParticle> anchor, bob;
  bob.position = d;
  return dot(rod.jacobian(anchor, bob), Velocity<PlaneParticle>(0, 0), Velocity<PlaneParticle>(v))[0];
}

struct Rates {
  renderer::Chart value, rate;  // over time: C, and Ċ by both ways
  double largest_difference = 0, tolerance = 0;
};

Rates rates(const Pair& start, double time, double step) {
  renderer::Curve value{.label = "", .colour = palette::error};
  renderer::Curve formula{.label = "by (10)", .colour = palette::constraint};
  renderer::Curve differences{
      .label = "differences of C", .style = renderer::CurveStyle::markers, .colour = palette::error};
  Rates rates;
  for (int i = 0; i <= 120; ++i) {
    const double t = time * i / 120;
    const Pair pair = start.after(t);
    const double measured = difference(pair, step);
    rates.largest_difference = std::max(rates.largest_difference, std::abs(measured - pair.rate()));
    value.x.push_back(t);
    value.y.push_back(pair.value());
    formula.x.push_back(t);
    formula.y.push_back(pair.rate());
    if (i % 8 != 0) continue;
    differences.x.push_back(t);
    differences.y.push_back(measured);
  }
  rates.tolerance = step * step / 6 * start.third_rate_bound(time + step) + rounding(start, time + step) / step;
  rates.value = {.x = {.label = "time (s)", .range = std::pair{0.0, time}},
                 .y = {.label = "C (m²)"},
                 .curves = {value},
                 .references = {{renderer::Reference::Across::y, 0, ""}}};
  rates.rate = {.x = {.label = "time (s)", .range = std::pair{0.0, time}},
                .y = {.label = "Ċ (m²/s)"},
                .curves = {differences, formula},
                .references = {{renderer::Reference::Across::y, 0, ""}}};
  return rates;
}

}  // namespace

void differentiate(course::Page& page, const Settings& set) {
  const double length = set.length, speed = set.speed, time = watched(set), step = set.h / 100;
  const Pair pair = pair_of(set);
  const Linear<PlaneBody> d = pair.d(), v1 = pair.V1.head<2>(), v2 = pair.V2.head<2>();

  page.text(
      R"(To find J, differentiate C and look for the velocities. The product rule on ½(P₂ − P₁)² cancels the half;
      L is constant and drops out.)");
  page.equation(9);
  page.text(R"(The product is a dot product. First a bob, which does not turn.)");
  const Linear<PlaneParticle> place = length * Linear<PlaneParticle>(0.6, -0.8), moving(speed, 0);
  const double bob = rate_of_bob(place, moving, length);
  page.predict(
      {.ask = course::say(
           R"(The bob is @ m from the fixed point and moves at @ m/s; the cosine of the angle
                         between its velocity and P₂ − P₁ is 0.6. How large is Ċ of (9)?)",
           length, speed),
       .answer = bob,
       .unit = "m²/s",
       .tolerance = 0.02 * length * speed,
       .wrong = {{speed,
                  "That is the speed. Only its part along P₂ − P₁ counts, and (9) multiplies it by |P₂ − P₁|."},
                 {bob / length, "That is how fast the distance grows, in m/s; (9) has it times |P₂ − P₁|."},
                 {length * speed, "That takes all of v₂; the part across P₂ − P₁ only turns the rod."}},
       .hints = {"Which part of the bob's velocity makes the rod longer?",
                 "(9) with Ṗ₁ = 0: a dot product is both lengths times the cosine of the angle between them.",
                 course::say("@ · @ · 0.6 = …", length, speed)},
       .right = "Only the component along P₂ − P₁ counts. And P₂ − P₁ is the l₂ that step 2 measured."});
  page.text(
      R"(An anchor point on a turning body moves for two reasons: the centre of its body moves, and the arm r from
      the centre to the point turns. In the plane ω × r is ω(−r_y, r_x).)");
  page.equation(10, "Ċ = @·((@ + @) − (@ + @)) = @ m²/s",
                R"(\dot C = @ \cdot ((@ + @) - (@ + @)) = @\,\mathrm{m^2/s})", vector(d), vector(v2),
                vector(pair.V2[2] * Linear<PlaneBody>(-pair.r2().y(), pair.r2().x())), vector(v1),
                vector(pair.V1[2] * Linear<PlaneBody>(-pair.r1().y(), pair.r1().x())), pair.rate());
  page.text(
      R"(Check every derivative. Here two boxes move freely for @ s; the rod only measures the distance. The
      curve is (10) at each moment. The dots do not use (10): they are C a little later minus C a little earlier,
      divided by the @ s between.)",
      course::Value(time, 3), course::Value(2 * step, 3));
  const Rates all = rates(pair, time, step);
  constexpr double seconds = 4;
  const Linear<PlaneBody> sides = box_sides(set);
  const double per_speed = 0.3 * length / fastest(set), stretch = set.stretch;
  page.sequence("motion",
                course::say("Two boxes in @ s of flight, @.", course::Value(time, 3),
                            time < seconds ? "slowed down" : "sped up"),
                course::Seconds{seconds}, [=](renderer::Canvas& canvas, double at) {
                  const auto [left, right] = canvas.page().inset(16).panels(0.56, 24, 0.36);
                  const auto [upper, lower] = right.split_rows(0.5, 16);
                  const double now = time * at / seconds;
                  const Pair then = pair.after(now);
                  canvas.look(renderer::fit({-0.5 * length, -0.95 * length, 3.35 * length + stretch, 1.9 * length},
                                            left, 0));
                  draw(canvas, then, sides);
                  const renderer::ArrowKind kind{palette::velocity, per_speed, "m/s"};
                  const Point p1 = then.pose1.position + then.r1(), p2 = then.pose2.position + then.r2();
                  canvas.vector(p1, then.V1.head<2>() + then.V1[2] * Point(-then.r1().y(), then.r1().x()), kind);
                  canvas.vector(p2, then.V2.head<2>() + then.V2[2] * Point(-then.r2().y(), then.r2().x()), kind);
                  canvas.arrow_key({left.x + 12, left.y + 16}, kind, "Ṗ");
                  renderer::draw(canvas, pictures::grown_to(all.value, now), upper);
                  renderer::draw(canvas, pictures::grown_to(all.rate, now), lower);
                });

  page.text(
      R"(Curve and dots differ by @@ m²/s; a centred difference with this step may be wrong by up to @ m²/s.)",
      all.largest_difference < 1e-11 ? "" : "at most ", course::small_error(all.largest_difference),
      course::Value(std::max(all.tolerance, 1e-11), 2));

  page.claim("Ċ of the bob", bob, "m²/s", is(0.6 * length * speed, "d·v by hand", course::relative(1e-14)));
  page.claim("largest difference between (10) and differences of C", all.largest_difference, "m²/s",
             is(all.tolerance, "step²/6 · bound on the third derivative, and rounding", course::at_most()));
}

}  // namespace byhand::lesson01
