// Step 5: the rows are wrong.

#include <cmath>

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/laws/redundant.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "lessons/scenes/circle.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::ConflictingRods;
using laws::Outcome;

constexpr double mass = 3;                         // of the bob [kg]
constexpr double strength = 100 * mass * gravity;  // what a rod bears [N]
constexpr double seconds = 10;                     // of a run

/// Two rods that differ by `conflict` [m]; `share` of each row's own JM⁻¹Jᵀ is its softness.
ConflictingRods rods(double conflict, double share) { return {.conflict = conflict, .softness = share / mass}; }

/// What the rods pull against each other with [N].
double quarrel(const ConflictingRods& rods, double time) { return laws::pull_apart(rods, time) / 2; }

/// Explodes: harder than a rod bears; drifts: not yet, but harder and harder.
Outcome end_of_quarrel(double conflict, double share) {
  const ConflictingRods both = rods(conflict, share);
  const double last = quarrel(both, seconds);
  if (!(last < strength)) return Outcome::explodes;
  return last > 1.01 * quarrel(both, 2 * seconds / 3) ? Outcome::drifts : Outcome::settles;
}

/// The softness at which two rods settle on what they bear.
double softness_that_bounds(double conflict) {
  const ConflictingRods both = rods(conflict, 0);
  return both.beta * conflict / (both.step * both.step * 2 * strength) * mass;
}

renderer::Chart over_time(double conflict, const std::vector<double>& shares) {
  renderer::Chart chart{
      .x = {.label = "time (s)"},
      .y = {.label = "pull against each other (weights of the bob)", .scale = renderer::Scale::logarithmic}};
  for (const double share : shares) {
    renderer::Curve curve{.label = share > 0 ? say("softness @ A", Value(share, 2)) : "rigid"};
    for (int i = 1; i <= 40; ++i) {
      curve.x.push_back(seconds * i / 40);
      curve.y.push_back(quarrel(rods(conflict, share), curve.x.back()) / (mass * gravity));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = strength / (mass * gravity), .label = "what a rod bears"});
  return chart;
}

constexpr double circle_radius = 1, circle_speed = 5;  // of what goes round [m], [m/s]

/// Law 14: what a particle keeps of its speed on a soft rod that is relaxed with a stale J.
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
  renderer::Curve law{.label = "law 14", .style = renderer::CurveStyle::theory};
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
       .draw = [](renderer::Canvas& canvas,
                  const Scene<PlaneParticle>& scene) { pictures::draw(canvas, pictures::rods_and_bobs(scene)); }});
}

}  // namespace

void wrong_rows(const Setting& setting, Page& page) {
  const double conflict = setting.conflict, bound = softness_that_bounds(conflict);
  const double borne = strength / (mass * gravity);

  page.text(
      R"(**Symptom:** there is none, or a small one: *the picture is calm*, and something that you do not look at
      is wrong. λ grows without end; a direct solve refuses; friction holds nothing; what goes round slows down.
      The fourth family solves the wrong rows, well enough and in small enough steps: they repeat each other,
      contradict each other, stand in the wrong order, or belong to where the bodies were a moment ago.)");
  page.text(
      R"(Two rods hold one bob of @ kg between the same two points, and one is @ m longer than the other. No λ can
      satisfy both. In each step each rod asks for β/h of its own error, the other undoes it, and a warm start
      keeps the sum.)",
      mass, setting.conflict);
  const ConflictingRods rigid = rods(conflict, 0);
  const double half = quarrel(rigid, seconds / 2) / (mass * gravity),
               whole = quarrel(rigid, seconds) / (mass * gravity);
  page.predict({.ask = say("After @ s the rods pull against each other with @ weights of the bob. After @ s?",
                           seconds / 2, Value(half, 3), seconds),
                .answer = whole,
                .unit = "weights",
                .tolerance = 0.1 * whole,
                .wrong = {{half,
                           R"(Each step corrects the other's correction, and warm start keeps the sum; look at λ,
                           not at the picture.)"},
                          {4 * half, "Nothing feeds on itself here: each step adds the same."}},
                .hints = {"How much does each step add?"},
                .right = "It grows by the same in every step, for ever."});
  page.figure("quarrel",
              say(R"(What two rods that differ by @ m pull against each other with: rigid, and with softness, in
                  shares of each row's own A = JM⁻¹Jᵀ.)",
                  setting.conflict),
              over_time(conflict, {0, bound / 10, bound, 10 * bound}));
  page.text(
      R"(A softness γ lets each row give way a little, JV + b + γλ = 0, and the quarrel ends where γλ makes up for
      half of the difference between what the two ask for. If a rod bears F, say @ weights, γ has to be large
      enough:)",
      borne);
  page.formula("γ > β δ/(2 h² F) = @ A", R"(\gamma > \frac{\beta\,\delta}{2 h^2 F} = @\,A)", Value(bound, 3));

  const Map map = map_of(page, knob("conflict δ (m)", 1e-4, 0.5, setting.resolution),
                         knob("softness γ / A (1)", 1e-5, 1, setting.resolution), end_of_quarrel);
  page.figure("conflict_and_softness",
              say(R"(Each cell is a run of @ s. "Explodes" is: pulls with more than @ weights. "Drifts" is: not
                  yet, but harder and harder. Dashed: the law.)",
                  seconds, borne),
              chart(map, "γ = βδ/2h²F", softness_that_bounds));
  const std::size_t columns = map.x.values.size();
  double ended = 0, right = 0;
  for (std::size_t i = 0; i < map.outcomes.size(); ++i) {
    if (map.outcomes[i] == Outcome::drifts) continue;
    ++ended;
    right += (map.outcomes[i] == Outcome::settles) ==
             (map.y.values[i / columns] > softness_that_bounds(map.x.values[i % columns]));
  }
  page.text("Of the @ runs that had come to an end the law foresees @ %.", static_cast<int>(ended),
            Value(100 * right / ended, 3));
  const Film<PlaneParticle> circles = rounds();
  page.text(
      R"(And then rows that were right a moment ago. A particle goes round on a soft rod, solved exactly; after
      each step its row is relaxed, hard and without bias (that keeps corrections out of V). Its correction u along
      the rod is just what turns V onto the new tangent. Relax with the J of the step's start, and u is thrown away
      instead:)");
  page.formula("v = v₀ / √(1 + v₀² h t/R²)", R"(v = v_0 \left(1 + \frac{v_0^2\,h\,t}{R^2}\right)^{-1/2})");
  page.sequence("stale_rows",
                say(R"(A particle that goes round at @ m/s on a soft rod, without gravity or friction. With a stale
                    J it has @ m/s after @ s, with a fresh one @ m/s.)",
                    circle_speed, Value(circles.last(0), 3), circles.seconds(), Value(circles.last(1), 3)),
                Seconds{circles.seconds()}, circles.drawing());
  page.text(
      R"(**Which knob?** Not sweeps, not the step. *Regularise*: a softness, or a share of the diagonal in a direct
      solve. *Reorder*: normals before the friction that leans on them. *Refresh*: write J anew where bodies have
      moved between two solves. And if you can, take away the row that says what others say.)");

  page.claim({.quantity = "share of ended runs that end as the law says",
              .unit = "1",
              .expected = 0.95,
              .source = "law B8",
              .measured = right / ended,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  page.claim({.quantity = "pull after twice the time",
              .unit = "of the first",
              .expected = 2,
              .source = "law B8: it grows linearly",
              .measured = whole / half,
              .tolerance = relative(0.02)});
  page.claim({.quantity = "speed at the end, stale J",
              .unit = "m/s",
              .expected = speed_by_law(circles.seconds()),
              .source = "law B14",
              .measured = circles.last(0),
              .tolerance = relative(0.02)});
  page.claim({.quantity = "speed at the end, fresh J",
              .unit = "m/s",
              .expected = circle_speed,
              .source = "nothing works on it",
              .measured = circles.last(1),
              .tolerance = relative(0.02)});
}

}  // namespace byhand::failures
