#include "lessons/01_jacobian/picture.hpp"
#include "lessons/scenes/pendulum.hpp"

// (1) and (2): C is one number that says how wrong things are.
namespace byhand::lesson01 {
namespace {

constexpr double three_four_five = 0.6435011087932844;  // the angle whose sine is 0.6 and cosine 0.8

Scene<PlaneParticle> bob_at(const Point& place, double length, double mass) {
  Scene<PlaneParticle> scene = pendulum<PlaneParticle>(0, length, mass);
  scene.set_position(1, place);
  return scene;
}

/// C of (2) with the bob at `place` and the other end at the origin [m²].
double value_at(const Point& place, double length, double mass) {
  const auto scene = bob_at(place, length, mass);
  return scene.all<Distance>()[0].value<double>(scene.bodies().pose[0], scene.bodies().pose[1])[0];
}

/// Where a hand holds the bob `time` seconds into the sequence: out, back, along the circle, in.
Point nudged(double time, double length) {
  const auto swing = [&](double from, double to) {
    const double u = std::clamp((time - from) / (to - from), 0.0, 1.0);
    return (1 - std::cos(std::numbers::pi * u)) / 2;
  };
  const double out = swing(0.6, 1.6) - swing(1.6, 2.2), in = swing(3.2, 4);
  const double angle = three_four_five - 1.4 * swing(2.2, 3.2), radius = length * (1 + 0.3 * (out - in));
  return radius * from_straight_down<PlaneParticle>(angle);
}

constexpr double duration = 4;  // of the sequence [s]

renderer::Chart value_over_time(double length, double mass) {
  renderer::Curve curve{.label = "", .colour = renderer::palette::error};
  for (int i = 0; i <= 200; ++i) {
    curve.x.push_back(duration * i / 200);
    curve.y.push_back(value_at(nudged(curve.x.back(), length), length, mass));
  }
  return {.x = {.label = "time (s)", .range = std::pair{0.0, duration}},
          .y = {.label = "C (m²)"},
          .curves = {curve},
          .references = {{renderer::Reference::Across::y, 0, "C = 0"}}};
}

renderer::Chart landscape(double length, double mass) {
  constexpr int half = 50, cells = 2 * half + 1;  // along an axis
  renderer::HeatMap map{
      .label = "C (m²)", .diverging = true, .range = std::pair{-length * length, length * length}, .square = true};
  for (int i = 0; i < cells; ++i) map.x.push_back(1.3 * length / half * (i - half));
  map.y = map.x;
  for (const double y : map.y)
    for (const double x : map.x) map.values.push_back(value_at({x, y}, length, mass));
  renderer::Curve circle{
      .label = "C = 0", .style = renderer::CurveStyle::theory, .colour = renderer::palette::ink};
  for (int i = 0; i <= 120; ++i) {
    const Point at = length * from_straight_down<PlaneParticle>(2 * std::numbers::pi * i / 120);
    circle.x.push_back(at.x());
    circle.y.push_back(at.y());
  }
  // The slope under a bob on the circle is d, drawn shorter: a line with a head.
  const Point bob = length * from_straight_down<PlaneParticle>(three_four_five), ahead = 0.5 * bob,
              aside = 0.12 * Point(-ahead.y(), ahead.x()), tip = bob + ahead, neck = bob + 0.78 * ahead;
  renderer::Curve slope{.label = "gradient of C", .colour = renderer::palette::constraint};
  for (const Point& p : {bob, tip, Point(neck + aside), tip, Point(neck - aside)}) {
    slope.x.push_back(p.x());
    slope.y.push_back(p.y());
  }
  return {.x = {.label = "x of the bob (m)"},
          .y = {.label = "y of the bob (m)"},
          .curves = {circle, slope},
          .heat_map = map,
          .annotations = {{0, 0, "fixed point"}, {bob.x(), bob.y(), "bob"}}};
}

/// C along the rod's line, and its slope at the rod's length.
renderer::Chart cut(double length, double mass) {
  renderer::Curve bowl{.label = "C", .colour = renderer::palette::error},
      slope{.label = "slope L", .colour = renderer::palette::constraint};
  for (int i = 0; i <= 90; ++i) {
    const double far = 1.5 * length * i / 90;
    bowl.x.push_back(far);
    bowl.y.push_back(value_at(far * from_straight_down<PlaneParticle>(three_four_five), length, mass));
  }
  for (const double far : {0.6 * length, 1.4 * length}) {
    slope.x.push_back(far);
    slope.y.push_back(length * (far - length));
  }
  return {.x = {.label = "distance from the fixed point (m)"},
          .y = {.label = "C (m²)"},
          .curves = {bowl, slope},
          .annotations = {{length, 0, "bob"}},
          .references = {{renderer::Reference::Across::y, 0, "C = 0"}}};
}

}  // namespace

void what_c_says(course::Page& page, const Settings& set) {
  const double length = set.length, mass = set.mass, stretch = set.stretch, far = length + stretch;
  const double C = course::without_rounding(
      value_at(far * from_straight_down<PlaneParticle>(three_four_five), length, mass), length * length);

  page.text(
      R"(This course follows one article: R. Gaul, *Modelling and Solving Physical Constraints* (2013). Its equations
      keep their numbers here, (1) to (23). Each is derived, computed by the course's solver and checked; this lesson
      covers (1) to (16) and (23). The article's running example is a rod between two bodies:)");
  page.figure("rod", "P₁ and P₂ are the rod's ends; r₁ and r₂ lead there from the centres of mass.",
              [pair = pair_of(set), sides = box_sides(set), length, stretch](renderer::Canvas& canvas) {
                canvas.look(renderer::fit({-0.5 * length, -0.5 * length, 2.8 * length + stretch, 1.3 * length},
                                          canvas.page(0.6).inset(12), 8));
                draw(canvas, pair, sides);
              });
  page.table({"symbol", "meaning", "unit"},
             {{"P₁, P₂", "anchor points: where the constraint holds body 1 and body 2", "m"},
              {"d", "P₂ − P₁, the vector from P₁ to P₂", "m"},
              {"r₁, r₂", "arms, from a body's centre of mass to its anchor point", "m"},
              {"L", "length that the rod should have", "m"},
              {"v, ω", "velocity of a centre of mass, angular velocity of a body", "m/s, rad/s"},
              {"C", "value of the constraint; Ċ is its rate of change", "m² for this rod"},
              {"V", "all velocities in one column: v₁, ω₁, v₂, ω₂", ""},
              {"J", "Jacobian, the row of numbers with Ċ = JV", ""},
              {"λ", "multiplier of Jᵀ: the bodies receive λJᵀ, a force in (5), an impulse from lesson 2 on", ""},
              {"h", "time step", "s"}});
  page.text(
      R"(A constraint is written as one number, C. It is zero when the constraint is satisfied; otherwise it measures
      the violation. It depends on where the two bodies are (l, for linear) and how they are turned (a, for
      angular):)");
  page.equation(1);
  page.text(R"(For the rod the article compares squared lengths, so that there is no root to differentiate:)");
  page.equation(2);
  page.text("In the solver (`at.separation` is P₂ − P₁):");
  page.excerpt("solver/constraints/distance.hpp", "value");

  const double first_order = length * stretch;
  page.predict(
      {.ask =
           course::say(R"(Take the simplest case: body 1 is fixed, body 2 is a small bob. The rod is @ m long and
                         the bob is @ m from the fixed point. How large is C of (2)?)",
                       length, far),
       .answer = C,
       .unit = "m²",
       .tolerance = 0.02 * length * std::max(std::abs(stretch), 1e-3),
       .wrong = {{stretch,
                  "That is the stretch in metres; (2) is half a difference of squares, in square metres."},
                 {2 * C, "That is d² − L², without the ½ of (2)."},
                 {-C, "d² comes first: a rod that is too long has C > 0, one that is too short C < 0."}},
       .hints = {"Two lengths matter: the rod's present length and the length it should have.",
                 "(2): C = ½(d² − L²).", course::say("½(@² − @²) = …", far, length)},
       .right =
           stretch == 0
               ? "The rod has the right length, so C is zero."
               : course::say(R"(With a stretch s it is L·s + ½s², here @ m² + @ m². C is not the stretch itself,
                                 and its unit is not the metre.)",
                             first_order, 0.5 * stretch * stretch)});
  page.text(
      R"(In the film a hand moves the bob: out and back, along the circle, and in. Watch C. It changes along the rod, and its
      sign tells too long from too short. It does not change along the circle, where the rod leaves the bob free.)");
  page.sequence("nudge", "C is positive outside the circle, negative inside, zero on it.",
                course::Seconds{duration}, [=](renderer::Canvas& canvas, double time) {
                  const auto [left, right] = canvas.page().inset(16).panels(0.5);
                  const renderer::Chart whole = value_over_time(length, mass);
                  canvas.look(renderer::fit({-0.95 * length, -1.4 * length, 2.05 * length, 1.6 * length}, left));
                  std::vector<Point> circle;
                  for (int i = 0; i <= 60; ++i)
                    circle.push_back(length * from_straight_down<PlaneParticle>(-0.9 + 2.6 * i / 60));
                  canvas.path(circle, {renderer::palette::theory, 1.6, renderer::Dash::dashed});
                  const Point at = nudged(time, length);
                  pictures::draw(canvas, pictures::rods_and_bobs(bob_at(at, length, mass)));
                  const double now = value_at(at, length, mass);
                  canvas.look_at_page();
                  canvas.text(
                      {left.x + 8, left.top() - 8},
                      course::say("C = @ m²", course::Value(std::abs(now) < 1e-9 ? 0 : now, 2)),
                      {.size = 26, .colour = renderer::palette::error, .anchor = renderer::Anchor::top_left});
                  renderer::draw(canvas, pictures::grown_to(whole, time), right);
                });
  page.text(
      R"(Put the bob anywhere and colour the place by its C. The landscape is a bowl whose bottom, at the fixed point, is at C = −½L²;
      the rod keeps the bob on one contour of it, C = 0. This lesson is about the slope of the bowl under the bob.)");
  page.figure(
      "landscape",
      R"(C as a function of the bob's position. Red is too long, blue too short; on the dashed contour C = 0. Arrow: the
              gradient of C under a bob. Right: C along that line.)",
      [map = landscape(length, mass), along = cut(length, mass)](renderer::Canvas& canvas) {
        const auto [left, right] = canvas.page().inset(12).panels(0.6, 20);
        renderer::draw(canvas, map, left);
        renderer::draw(canvas, along, right.lowered(80));
      });

  double along = 0;
  for (int i = 0; i < 60; ++i)
    along = std::max(along, std::abs(value_at(length * from_straight_down<PlaneParticle>(0.1 * i), length, mass)));
  const double exact = 1e-14 * length * length;
  page.claim("C of the stretched rod", C, "m²",
             is(stretch * (length + stretch / 2), "L s + ½ s² for a stretch s", course::absolute(exact)));
  page.claim("C at the fixed point", value_at({0, 0}, length, mass), "m²",
             is(-length * length / 2, "−½ L²", course::absolute(exact)));
  page.claim("largest |C| along the circle", along, "m²", is(exact, "rounding of L²", course::at_most()));
}

}  // namespace byhand::lesson01
