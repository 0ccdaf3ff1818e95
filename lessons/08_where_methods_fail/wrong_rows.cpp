// Step 5: the rows are wrong.

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/redundant.hpp"
#include "lessons/scenes/circle.hpp"

namespace byhand::failures {
namespace {

using laws::ConflictingRods;
using laws::Outcome;

constexpr double mass = 3;                         // of the bob [kg]
constexpr double strength = 100 * mass * gravity;  // what a rod bears [N]
constexpr double seconds = 10;                     // of a run

/// Two rods that differ by `conflict` [m]; `share` of each row's own JM⁻¹Jᵀ is its softness.
ConflictingRods rods(double conflict, double share) { return {.conflict = conflict, .softness = share / mass}; }

/// What the rods pull against each other with [N].
double tug(const ConflictingRods& rods, double time) { return laws::pull_apart(rods, time) / 2; }

/// Explodes: harder than a rod bears; drifts: not yet, but harder and harder.
Outcome end_of_conflict(double conflict, double share) {
  const ConflictingRods both = rods(conflict, share);
  const double last = tug(both, seconds);
  if (!(last < strength)) return Outcome::explodes;
  return last > 1.01 * tug(both, 2 * seconds / 3) ? Outcome::drifts : Outcome::settles;
}

/// The softness at which two rods settle on what they bear.
double softness_that_bounds(double conflict) {
  const ConflictingRods both = rods(conflict, 0);
  return both.beta * conflict / (both.step * both.step * 2 * strength) * mass;
}

renderer::Chart over_time(double conflict, const std::vector<double>& shares) {
  const double h = rods(conflict, 0).step;
  renderer::Chart chart{
      .x = {.label = "time (s)", .scale = renderer::Scale::logarithmic},
      .y = {.label = "pull against each other (weights of the bob)", .scale = renderer::Scale::logarithmic}};
  for (const double share : shares) {
    renderer::Curve curve{.label = share > 0 ? say("softness @ A", Value(share, 2)) : "rigid"};
    for (int i = 1; i <= 40; ++i) {
      curve.x.push_back(h * std::round(seconds * std::pow(200, i / 40.0 - 1) / h));
      curve.y.push_back(tug(rods(conflict, share), curve.x.back()) / (mass * gravity));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = strength / (mass * gravity), .label = "what a rod bears"});
  return chart;
}

constexpr double circle_radius = 1, circle_speed = 5;  // of what goes round [m], [m/s]

/// The law of stale Jacobians: what a particle keeps of its speed on a soft rod that is relaxed with a stale J.
double speed_by_law(double time) {
  return circle_speed / std::sqrt(1 + circle_speed * circle_speed * step * time / (circle_radius * circle_radius));
}

Film<PlaneParticle> rounds() {
  const auto relaxed = [](std::string name, bool refresh) {
    return Take<PlaneParticle>{
        std::move(name),
        {particle_on_a_circle<PlaneParticle>(circle_radius, circle_speed, 1),
         VelocityStepping{.solver = Direct{},
                          .drift = SoftConstraints{.frequency = 2 / step, .refresh = refresh}}}};
  };
  renderer::Curve law{.label = "law of the stale J", .style = renderer::CurveStyle::theory};
  constexpr double filmed = 3.5;
  for (int i = 0; i <= 50; ++i) {
    law.x.push_back(filmed * i / 50);
    law.y.push_back(speed_by_law(law.x.back()));
  }
  return Film<PlaneParticle>(
      {.takes = {relaxed("stale J", false), relaxed("fresh J", true)},
       .view = {-1.2 * circle_radius, -1.2 * circle_radius, 2.4 * circle_radius, 2.4 * circle_radius},
       .seconds = filmed,
       .gauge = {.label = "speed (m/s)", .range = {{0, 1.2 * circle_speed}}},
       .read = [](const Scene<PlaneParticle>& scene) { return scene.bodies().velocity[1].norm(); },
       .laws = {law},
       .failed = [](const Scene<PlaneParticle>&) { return false; },
       .failure = "stops",
       .success = "goes round",
       .draw =
           [](renderer::Canvas& canvas, const Scene<PlaneParticle>& scene, const renderer::Look& look) {
             pictures::draw(canvas, pictures::rods_and_bobs(scene), {.bodies = look});
           }});
}

}  // namespace

void wrong_rows(const Setting& setting, Page& page) {
  const double conflict = setting.conflict, bound = softness_that_bounds(conflict);
  const double borne = strength / (mass * gravity);
  const ConflictingRods rigid = rods(conflict, 0);
  const double half = tug(rigid, seconds / 2) / (mass * gravity), whole = tug(rigid, seconds) / (mass * gravity),
               rate = (whole - half) / (seconds / 2), moved = laws::bob_moves(rigid, seconds);

  page.text(
      R"(**Symptom of the fifth family:** *the picture is calm*, and a number that nobody looks at is wrong. λ grows
      without bound, a direct solve finds no solution, friction does not hold, something that goes round slows down.
      The rows are solved well, in short steps, but they are the wrong rows. They are redundant, contradict each
      other, come in the wrong order, or belong to where the bodies were a moment ago.)");
  page.text(
      R"(Two rods hold one bob of @ kg between the same two points, and one is Δ = @ m longer than the other. This
      scene takes k = @ warm sweeps a step and β = @, whatever the parameters. No λ satisfies both. In each step each rod asks for β/h of its own error and so undoes the other's correction; the
      warm start adds all this up. The picture stays calm: in @ s the bob moves by @ m at most.)",
      mass, setting.conflict, rigid.sweeps, rigid.beta, seconds, Value(moved, 2));
  page.predict(
      {.ask =
           say(R"(By how many weights of the bob does the pull of the rods against each other grow in a second, at
                @ steps a second?)",
               std::lround(1 / rigid.step)),
       .answer = rate,
       .unit = "weights a second",
       .tolerance = 0.05 * rate,
       .wrong =
           {{0,
             R"(The bob is calm, but λ is not: each rod corrects the other's correction, and the warm start adds
                           it all up.)"},
            {rate / rigid.sweeps, "That is what one sweep of each step adds."},
            {2 * rate, "That is how fast the difference of the two pulls grows; each rod pulls with half of it."}},
       .hints = {"The bob stays where it is. What does a sweep add to each λ?",
                 "A sweep adds mβΔ/h to one λ and takes it from the other; there are k sweeps a step.",
                 "The pull is λ/h and the weight mg, with 1/h steps a second: kβΔ/(gh³)"},
       .hinted = rigid.sweeps * rigid.beta * conflict / (gravity * rigid.step * rigid.step * rigid.step),
       .right = say("kβΔ/(gh³), without end: after @ s, @ times the bob's weight.", seconds, Value(whole, 3))});
  page.figure(
      "two_rods",
      say(R"(The pull against each other of two rods that differ by @ m: rigid, and soft, with γ as a fraction of
                  each row's own A = JM⁻¹Jᵀ. On logarithmic axes, growth in proportion to time is a line of slope 1.)",
          setting.conflict),
      over_time(conflict, {0, bound / 10, bound, 10 * bound}));
  page.text(
      R"(A softness γ lets each row give way a little: JV + b + γλ = 0. The pulls stop growing once γ(λ₁ − λ₂) makes up
      for the difference of the two biases. If a rod can bear a force F, say @ times the bob's weight, it takes)",
      borne);
  page.formula("γ > β Δ/(2 h² F) = @ A", R"(\gamma > \frac{\beta\,\Delta}{2 h^2 F} = @\,A)", Value(bound, 3));
  page.derivation(
      "Why γ > βΔ/2h²F",
      {{"the biases of the two rows differ", "b₁ − b₂ = βΔ/h", R"(b_1 - b_2 = \beta\Delta/h)"},
       {"A = 1/m: each row, once solved, leaves the other short by that, and the other makes up for it",
        "Δλ = ∓ mβΔ/h for each row and sweep",
        R"(\Delta\lambda = \mp\,m\beta\Delta/h \text{ for each row and sweep})"},
       {"k sweeps a step, 1/h steps a second, over h for a force", "d|λ₁ − λ₂|/(h dt) = 2kmβΔ/h³",
        R"(\frac{d|\lambda_1 - \lambda_2|}{h\,dt} = \frac{2km\beta\Delta}{h^3})"},
       {"with softness both rows hold: JV + b₁ + γλ₁ = 0 and JV + b₂ + γλ₂ = 0", "γ|λ₁ − λ₂| = βΔ/h",
        R"(\gamma\,|\lambda_1 - \lambda_2| = \beta\Delta/h)"},
       {"each rod pulls with half of the difference", "F = |λ₁ − λ₂|/(2h) = βΔ/(2h²γ)",
        R"(F = \frac{|\lambda_1 - \lambda_2|}{2h} = \frac{\beta\Delta}{2h^2\gamma})"}});

  const Map map = map_of(page, knob("difference of the lengths Δ (m)", 1e-4, 0.5, setting.resolution),
                         knob("softness γ / A", 1e-5, 1, setting.resolution), end_of_conflict);
  page.figure("conflict_and_softness",
              say(R"(Each cell is one run of @ s. A rod breaks if it is pulled with more than @ weights of the bob.
                  Dashed: the law.)",
                  seconds, borne),
              chart(map, "γ = βΔ/2h²F", softness_that_bounds,
                    {"holds", "holds, but λ still grows", "rings", "breaks", "no solution"}));
  const std::size_t columns = map.x.values.size();
  int right = 0, runs = 0;
  for (std::size_t i = 0; i < map.outcomes.size(); ++i) {
    if (map.outcomes[i] == Outcome::drifts) continue;
    ++runs;
    right += (map.outcomes[i] == Outcome::settles) ==
             (map.y.values[i / columns] > softness_that_bounds(map.x.values[i % columns]));
  }
  if (runs > 0)
    page.text(right == runs
                  ? say("The law predicts all @ runs in which λ has stopped growing or a rod has broken.", runs)
                  : say("The law predicts @ of the @ runs in which λ has stopped growing or a rod has broken.",
                        right, runs));

  const Film<PlaneParticle> circles = rounds();
  page.text(
      R"(Rows can also be out of date. A particle goes round on a soft rod that is solved exactly. After each step its
      row is *relaxed*: solved once more, rigid and without bias, so that the velocity of the correction does not stay
      in V (lesson 6). But the correction u along the rod is just what turns V into the new tangent. If the relax pass
      still has the J of the start of the step, it removes u, and the particle slows down:)");
  page.formula("v = v₀ / √(1 + v₀² h t/R²)", R"(v = v_0 \left(1 + \frac{v_0^2\,h\,t}{R^2}\right)^{-1/2})");
  page.derivation(
      "Why a stale J slows it down",
      {{"a step along the tangent leaves the circle by", "v²h²/(2R)", R"(\frac{v^2h^2}{2R})"},
       {"the soft row brings it back by a speed u along the rod", "uh = v²h²/(2R)   ⟹   u = v²h/(2R)",
        R"(u = \frac{v^2h}{2R})"},
       {"at the new pose the tangent has turned by", "δ = vh/R", R"(\delta = \frac{vh}{R})"},
       {"fresh J: what V has along the new tangent stays", "v cosδ + u sinδ ≈ v − v³h²/2R² + v³h²/2R² = v",
        R"(v\cos\delta + u\sin\delta \approx v)"},
       {"stale J: u is removed first", "v cosδ ≈ v − v³h²/2R²", R"(v\cos\delta \approx v - \frac{v^3h^2}{2R^2})"},
       {"a step is h long", "dv/dt = −h v³/(2R²)", R"(\frac{dv}{dt} = -\frac{h\,v^3}{2R^2})"},
       {"integrated", "1/v² = 1/v₀² + ht/R²", R"(\frac1{v^2} = \frac1{v_0^2} + \frac{h\,t}{R^2})"}});
  page.sequence(
      "stale_rows",
      say(R"(A particle that starts at @ m/s on a soft rod, without gravity or friction. After @ s its speed is @ m/s
                    with a stale J and @ m/s with a fresh one, which loses @ m/s until the soft rod has reached its steady
                    stretch.)",
          circle_speed, circles.seconds(), Value(circles.last(0), 3), Value(circles.last(1), 3),
          Value(circle_speed - circles.last(1), 1)),
      Seconds{circles.seconds()}, circles.drawing());
  page.text(
      R"(**Which knob?** Neither sweeps nor the step. *Regularise*: give the rows a softness, or, in a direct solve,
      add a share of the diagonal. *Reorder*: solve normals before the friction that they bound. *Refresh*: recompute
      J if bodies have moved between two solves. And where you can, remove a row that repeats another.)");
  page.text("From the casebook: a joint that works with a stale J, `./lessons/run case 11`.");

  page.claim("share of ended runs that end as the law says", runs > 0 ? static_cast<double>(right) / runs : 0, "1",
             is_at_least(0.95, "law of conflicting rows"), Quantity("resolution", setting.resolution) >= 10);
  page.claim("pull after twice the time, over the first", whole / half, "1",
             is(2, "law of conflicting rows: it grows in proportion to time", relative(0.02)));
  page.claim("the bob moves by at most", moved, "m",
             is_at_most(conflict * (1 + 1e-6), "it hangs between the two lengths"));
  page.claim("speed at the end, stale J", circles.last(0), "m/s",
             is(speed_by_law(circles.seconds()), "law of stale Jacobians", relative(0.02)));
  page.claim("speed at the end, fresh J", circles.last(1), "m/s",
             is(circle_speed, "nothing does work on it", relative(0.02)));
}

}  // namespace byhand::failures
