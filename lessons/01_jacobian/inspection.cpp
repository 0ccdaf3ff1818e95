#include "lessons/01_jacobian/picture.hpp"

// (14): J read off (13), and why there is only one.
namespace byhand::lesson01 {
namespace {

using Entries = Eigen::Matrix<double, 1, 6>;

constexpr int entries = 6;
const std::array<const char*, entries> names = {"l₁ x", "l₁ y", "a₁", "l₂ x", "l₂ y", "a₂"},
                                       moved = {"v₁ x", "v₁ y", "ω₁", "v₂ x", "v₂ y", "ω₂"};

/// The pair moving in one of its six ways alone, at 1 m/s or 1 rad/s.
Pair moving_in(Pair pair, int way) {
  Eigen::Matrix<double, entries, 1> V = Eigen::Matrix<double, entries, 1>::Unit(way);
  pair.V1 = V.head<3>();
  pair.V2 = V.tail<3>();
  return pair;
}

/// All six entries by six small movements, from C alone.
Entries probed(const Pair& pair, double step) {
  Entries row;
  for (int way = 0; way < entries; ++way) row[way] = difference(moving_in(pair, way), step);
  return row;
}

/// How far a probe may miss its entry.
double probe_tolerance(const Pair& pair, double step) {
  double largest = 0;
  for (int way = 0; way < entries; ++way)
    largest = std::max(largest, difference_tolerance(moving_in(pair, way), step));
  return largest;
}

/// The same rod with its two ends exchanged, bodies and arms.
Jacobian<PlaneBody, 1> swapped(const Pair& pair) {
  Distance<PlaneBody> rod = pair.rod;
  std::swap(rod.at.arms.first, rod.at.arms.second);
  return rod.jacobian(pair.pose2, pair.pose1);
}

/// The row's two blocks, exchanged.
Entries exchanged(const Entries& row) {
  Entries other;
  other << row.tail<3>(), row.head<3>();
  return other;
}

renderer::Chart bars(const Entries& row, int shown) {
  renderer::Bars all{.label = "", .colour = palette::constraint};
  renderer::Chart chart{.x = {.label = "component of V set to 1 m/s or 1 rad/s"},
                        .y = {.label = "entry of J (m, m²)"}};
  for (int i = 0; i < entries; ++i) {
    chart.bar_names.emplace_back(moved[static_cast<std::size_t>(i)]);
    all.values.push_back(i < shown ? row[i] : std::nan(""));
  }
  chart.bars = {all};
  const double largest = 1.15 * row.cwiseAbs().maxCoeff();
  chart.y.range = std::pair{-largest, largest};
  return chart;
}

void draw_probe(renderer::Canvas& canvas, const Pair& pair, const Entries& row, const Linear<PlaneBody>& sides,
                double length, double stretch, double time, double each) {
  const int way = std::min(static_cast<int>(time / each), entries - 1);
  const double phase = std::min(time / each - way, 1.0);
  const auto [left, right] = canvas.page().inset(16).panels(0.56);
  const renderer::Camera camera =
      renderer::fit({-0.55 * length, -0.85 * length, 2.5 * length + stretch, 1.7 * length}, left, 8);
  canvas.look(camera);
  const double size = way % 3 == 2 ? 0.5 : 0.22 * length;  // of the movement to be seen [rad or m]
  const Pair nudged = moving_in(pair, way).after(size * std::sin(2 * std::numbers::pi * phase));
  draw(canvas, nudged, sides);
  canvas.look_at_page();
  canvas.text({left.x + 16, left.top() - 24},
              course::say("only body @ @", way < 3 ? 1 : 2,
                          way % 3 == 0   ? "moves along x"
                          : way % 3 == 1 ? "moves along y"
                                         : "turns"),
              {.size = 22, .anchor = renderer::Anchor::left, .bold = true});
  canvas.text({left.x + 16, left.top() - 58},
              course::say("@ = @ @", names[static_cast<std::size_t>(way)], course::Value(row[way], 3),
                          way % 3 == 2 ? "m²" : "m"),
              {.size = 22, .colour = palette::constraint, .anchor = renderer::Anchor::left});
  renderer::draw(canvas, bars(row, way + 1), right);
}

/// Where J's arrow on the bob points, for bobs outside and inside the circle.
void draw_field(renderer::Canvas& canvas, double length) {
  // On a narrow page the key is above the field.
  const bool narrow = canvas.page().is_high();
  const renderer::Rectangle frame = narrow ? canvas.page(1.1).split_rows(0.38, 0).second : canvas.page();
  const renderer::Camera field =
      renderer::fit({-2.75 * length, -1.8 * length, 5.5 * length, 3.6 * length}, frame, 10);
  canvas.look(field);
  std::vector<Point> circle;
  for (int i = 0; i <= 120; ++i) {
    const double at = 2 * std::numbers::pi * i / 120;
    circle.push_back(length * Point(std::cos(at), std::sin(at)));
  }
  canvas.path(circle, {palette::theory, 2, renderer::Dash::dashed});
  const renderer::ArrowKind kind{palette::constraint, 0.3, "m"};
  const Distance<PlaneParticle> rod{{0, 1}, length};
  Pose<PlaneParticle> anchor, bob;
  for (const double radius : {0.55, 1.0, 1.3})
    for (int i = 0; i < 12; ++i) {
      const double at = 2 * std::numbers::pi * (i + (radius == 1.0 ? 0.5 : 0.0)) / 12;
      bob.position = radius * length * Point(std::cos(at), std::sin(at));
      const double C = rod.value<double>(anchor, bob)[0];
      canvas.vector(bob.position, rod.jacobian(anchor, bob).l2().transpose(), kind);
      const double sign = radius == 1.0 ? 0 : std::copysign(0.7, C);
      const renderer::Colour inside = palette::diverging(sign);  // the landscape's colours
      canvas.disc(bob.position, 7 / canvas.camera().scale, {inside, {palette::ink, 1.2}});
    }
  canvas.anchor({0, 0});
  canvas.hinge({0, 0});
  canvas.look_at_page();
  const renderer::TextStyle style{.size = 19, .anchor = renderer::Anchor::left};
  canvas.mark({40, 640}, renderer::Mark::disc, palette::diverging(0.7), 13);
  canvas.text({56, 640}, "too long, C > 0", style);
  canvas.disc({40, 604}, 6.5, {palette::diverging(0), {palette::ink, 1.2}});
  canvas.text({56, 604}, "on the circle, C = 0", style);
  canvas.mark({40, 568}, renderer::Mark::disc, palette::diverging(-0.7), 13);
  canvas.text({56, 568}, "too short, C < 0", style);
  canvas.look(field);
  canvas.arrow_key({40, 520}, kind, "l_2 = d,");
}

void say_swap(course::Page& page, const Pair& pair, const Entries& row) {
  const Entries other = swapped(pair).matrix;
  page.text(
      R"(*What if the bodies are numbered the other way round?* Then d becomes −d and l₁, which was @, becomes @.
      But the new l₁ belongs to the old body 2: the two halves of the row have changed places, and each body keeps its
      arrows. It has to, because (2) is the same from both ends.)",
      vector(row.segment<2>(0).transpose()), vector(other.segment<2>(0).transpose()));
  page.claim("row after the swap − row with its blocks exchanged, relative",
             (other - exchanged(row)).norm() / row.norm(), "1",
             is(1e-14, "C of (2) is the same from both ends", course::at_most()));
}

}  // namespace

void inspection(course::Page& page, const Settings& set) {
  const double length = set.length, stretch = set.stretch, step = 1e-3;
  const Pair pair = pair_of(set);
  const Jacobian<PlaneBody, 1> J = pair.row();
  const Entries row = J.matrix, by_probe = probed(pair, step);
  const Linear<PlaneBody> sides = box_sides(set);

  page.text(
      R"(The last step is inspection. In (13) every velocity has a coefficient of its own. The coefficients, in the order
      of V, are the four parts of J. For the two boxes:)");
  page.equation(14, "J = [ @  @  @  @ ]", R"(J = \begin{bmatrix} @ & @ & @ & @ \end{bmatrix})",
                vector(J.l1().transpose()), J.a1()(0, 0), vector(J.l2().transpose()), J.a2()(0, 0));
  page.derivation(
      "From (2) to (14), line by line",
      {{"(2), with d = P₂ − P₁ (11)", "C = ½(d·d − L²)", R"(C = \tfrac{1}{2}(d \cdot d - L^2))"},
       {"product rule; L is constant (9)", "Ċ = d·(Ṗ₂ − Ṗ₁)", R"(\dot C = d \cdot (\dot P_2 - \dot P_1))"},
       {"each anchor point moves with its centre and turns about it (10)",
        "Ċ = d·((v₂ + ω₂ × r₂) − (v₁ + ω₁ × r₁))",
        R"(\dot C = d \cdot ((v_2 + \omega_2 \times r_2) - (v_1 + \omega_1 \times r_1)))"},
       {"d·(ω × r) = ω·(r × d) (13)", "Ċ = −d·v₁ − (r₁ × d)·ω₁ + d·v₂ + (r₂ × d)·ω₂",
        R"(\dot C = -d \cdot v_1 - (r_1 \times d) \cdot \omega_1 + d \cdot v_2 + (r_2 \times d) \cdot \omega_2)"},
       {"compare with (8)", "l₁ = −d, a₁ = −r₁ × d, l₂ = d, a₂ = r₂ × d",
        R"(l_1 = -d,\; a_1 = -r_1 \times d,\; l_2 = d,\; a_2 = r_2 \times d)"}});
  // J's arrow on a bob of a rod that is too short, and the way out from the anchor.
  const Distance<PlaneParticle> rod{{0, 1}, length};
  Pose<PlaneParticle> anchor, bob;
  bob.position = 0.95 * length * Linear<PlaneParticle>(0.6, -0.8);
  const double C = rod.value<double>(anchor, bob)[0], out = rod.jacobian(anchor, bob).l2().dot(bob.position);
  const char
      *towards =
          "J is the gradient of C, so it points in the direction of increasing C; towards the fixed point C "
          "decreases.",
      *away = R"(J is the gradient of C. Farther from the fixed point C is larger, whether the rod is too long or
                     too short; λ decides whether to push or pull.)";
  page.choose(
      {.ask = course::say(
           R"(A rod from a fixed point to a bob is too *short*: C = @ m². Draw l₂ as an arrow at the bob. Which way
                                 does it point?)",
           C),
       .options = {{"towards the fixed point", towards},
                   {"away from the fixed point", away},
                   {"that depends on the sign of C", "(14) contains neither C nor L, only d."}},
       .answer = out < 0 ? 0 : 1,
       .hints = {"Which way must the bob move for C to grow?", "(14): l₂ = d = P₂ − P₁.",
                 "P₁ is the fixed point and P₂ the bob: d leads from P₁ to P₂."}});
  four_parts(page, set);
  page.text("The solver writes this row, and later the rows of contacts and friction, with u in place of d:");
  page.excerpt("solver/jacobian.hpp", "along");
  page.text(
      R"("By inspection" is not guessing. Ċ = JV holds for *every* V, and only one J does that: set one component of V
      to 1 and the others to 0, and JV is one entry of J.)");
  constexpr double each = 1.4;
  page.sequence("probes", "Six movements give six numbers: each time Ċ is measured from C, without (14).",
                course::Seconds{entries * each}, [=](renderer::Canvas& canvas, double time) {
                  draw_probe(canvas, pair, by_probe, sides, length, stretch, time, each);
                });

  page.text(
      R"(A row can be drawn on its bodies: l is an arrow at the body's centre, a is a curved arrow around it.
      The two straight arrows are equal and opposite; the curved ones need not be.)");
  page.figure(
      "row", "The four parts of J, drawn on the bodies that they belong to.", [=](renderer::Canvas& canvas) {
        canvas.look(renderer::fit({-0.75 * length, -0.65 * length, 3.3 * length + 1.6 * stretch, 1.5 * length},
                                  canvas.page(0.75), 10));
        draw(canvas, pair, sides, {.ends_named = false, .pale_rod = true});
        draw_row(canvas, J, pair.pose1.position, pair.pose2.position,
                 {.scale = 0.5 * length / J.l2().norm(),
                  .radius = 0.14 * length,
                  .l1 = "l_1 = −d",
                  .a1 = course::say("a_1 = −r_1 × d = @ m²", course::Value(J.a1()(0, 0), 3)),
                  .l2 = "l_2 = d",
                  .a2 = course::say("a_2 = r_2 × d = @ m²", course::Value(J.a2()(0, 0), 3)),
                  .a1_aside = {0, -0.46 * length},
                  .a2_aside = {0, -0.5 * length}});
        canvas.arrow_key({40, canvas.page().y + 40}, {palette::constraint, 0.5 * length / J.l2().norm(), "m"},
                         "l:");
      });

  page.figure("field",
              "J's arrow on the bob points the way C increases: outwards, even where the rod is too short.",
              [=](renderer::Canvas& canvas) { draw_field(canvas, length); });
  page.text(
      R"(Move both bodies by a small ε along their l, without turning them, and C grows by 2|d|ε. J does not say whether C has to grow or to shrink:
      the sign of λ decides that (lesson 2).

      *The article says that J "always points towards the target". That is true only where C is negative.*)");

  say_swap(page, pair, row);
  page.text(
      R"(Now derive it yourself: `./lessons/run desk --task 2` begins with this C, checks each of your lines against
      the one before, and says which is wrong and why. `./lessons/run desk --tasks` lists eleven more, from a pin to
      a screw.)");

  Pair along = pair;  // both bodies moving along their l at 1 m/s
  along.V1 << J.l1().transpose().normalized(), 0;
  along.V2 << J.l2().transpose().normalized(), 0;
  page.claim("six probes against (14), largest difference over |J|",
             (by_probe - row).cwiseAbs().maxCoeff() / row.norm(), "1",
             is(probe_tolerance(pair, step) / row.norm(), "step²/6 · bound on the third derivative, and rounding",
                course::at_most()));
  page.claim(
      "Ċ when both bodies move along their l at 1 m/s", difference(along, step), "m²/s",
      is(2 * pair.d().norm(), "2|d| > 0: C grows there", course::absolute(difference_tolerance(along, step))));
}

}  // namespace byhand::lesson01
