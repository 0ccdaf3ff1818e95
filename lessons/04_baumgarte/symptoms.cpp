#include "lessons/04_baumgarte/symptoms.hpp"

#include "lessons/04_baumgarte/warm_chain.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::baumgarte {
namespace {

/// The scenes in which the mistakes are made.
constexpr struct {
  double h = 1.0 / 60, beta = 0.2, g = standard_gravity;  // [s], [1], [m/s²]
  double mass = 3, length = 2;                            // [kg], [m]
  double off = 0.5;                                       // of a rod that is too long [m]
  double blow = 1, speed = 6;                             // [m/s]
  double box_width = 0.6, box_height = 1, arm = 0.5;      // [m]
} trial;

/// A bob straight below the fixed point (0, 0), on a rod that is `error` [m] too long.
RodBetween hanging(double error = 0) {
  return {.two = {.x = {0, -trial.length - error}, .inverse_mass = 1 / trial.mass}, .length = trial.length};
}

/// A box below the fixed point; its arm [m] leads to the lower end of the rod.
RodBetween hanging_box(const Vector& to_rod, const PlaneRotation<double>& rotation = {1, 0}) {
  const double inertia =
      trial.mass * (trial.box_width * trial.box_width + trial.box_height * trial.box_height) / 12;
  Body box{.rotation = rotation, .inverse_mass = 1 / trial.mass, .inverse_inertia = 1 / inertia};
  box.x = Vector(0, -trial.length) - box.turned(to_rod);
  return {.two = box, .arm2 = to_rod, .length = trial.length};
}

/// Two bobs, the right one hit along the rod.
RodBetween pair_that_was_hit() {
  return {.one = {.x = {-trial.length / 2, 0}, .inverse_mass = 1 / trial.mass},
          .two = {.x = {trial.length / 2, 0}, .v = {trial.blow, 0}, .inverse_mass = 1 / trial.mass},
          .length = trial.length};
}

RodBetween after(RodBetween rod, const Recipe& recipe, int steps) {
  for (int i = 0; i < steps; ++i) advance(rod, recipe);
  return rod;
}

/// Runs a rod with the fault and without it, and reads a number off each.
Symptom run(Symptom symptom, const RodBetween& start, const Recipe& recipe, int steps, const Reading& read,
            const Recipe& right_recipe) {
  symptom.unit = read.unit;
  symptom.wrong = read.of(after(start, recipe, steps));
  symptom.right = without_rounding(read.of(after(start, right_recipe, steps)), 1);
  symptom.run = {start, recipe, right_recipe, steps, read};
  return symptom;
}
Symptom run(Symptom symptom, const RodBetween& start, const Recipe& recipe, int steps, const Reading& read) {
  Recipe right = recipe;
  right.fault = Fault::none;
  return run(std::move(symptom), start, recipe, steps, read, right);
}

const Reading downwards{"speed", "m/s", [](const RodBetween& rod) { return -rod.two.v.y(); }};
const Reading momentum_left{"momentum left", "%", [](const RodBetween& rod) {
                              return 100 * (rod.one.v.x() + rod.two.v.x()) / trial.blow;
                            }};
const Reading too_long{"stretch", "m", [](const RodBetween& rod) { return rod.too_long(); }};
const Reading error_left{"error left", "%",
                         [](const RodBetween& rod) { return 100 * rod.too_long() / trial.off; }};
const Reading spin{"ω", "rad/s", [](const RodBetween& rod) { return rod.two.spin; }};

SymptomGroup of_one_row() {
  return {
      "One rod, without correction",
      {run({.seen = "The bob sinks steadily",
            .quantity = "speed downwards after 1 s",
            .law = trial.g * trial.h,
            .source = "gh",
            .cause = "gravity is added after λ, so the bob moves by a gh that its row has not seen",
            .test = "halve h: the speed halves too, and the mass does not matter",
            .more = "`./lessons/run 2 --step 7b`, `./lessons/run practise 6`"},
           hanging(), {.fault = Fault::gravity_last}, 60, downwards),
       run({.seen = "The bob flies off at once",
            .quantity = "speed downwards after 10 steps",
            .law = trial.g * trial.h * 2046,
            .source = "gh(2¹¹ − 2)",
            .cause = "λ has the wrong sign, so each step doubles the speed that it should remove",
            .test = "print JV + b before and after (20): it must go to zero, and it doubles",
            .more = "`./lessons/run 2 --step 3`, `./lessons/run practise 4`"},
           hanging(), {.fault = Fault::sign_of_lambda}, 10, downwards),
       run({.seen = "Two bobs fly apart when one is hit",
            .quantity = "stretch after 1 s",
            .law = trial.blow,
            .source = "the whole speed of the blow, times 1 s",
            .cause = "l₁ lacks its minus sign, so the row pushes both bodies the same way",
            .test = "give both bodies the same velocity: JV must be 0, because nothing stretches",
            .more = "`./lessons/run 1 --step 5`, `./lessons/run practise 1`"},
           pair_that_was_hit(), {.gravity = 0, .fault = Fault::sign_of_l1}, 60, too_long),
       run({.seen = "Bodies lose their momentum",
            .quantity = "momentum left after 10 steps",
            .law = 100 / 1024.0,
            .source = "2⁻¹⁰ with equal masses",
            .cause = "(20) is applied to one body only",
            .test = "add up m·v of all bodies before and after (20): the sum must not change",
            .more = "`./lessons/run 2 --step 4`, `./lessons/run practise 5`"},
           pair_that_was_hit(), {.gravity = 0, .fault = Fault::second_body_only}, 10, momentum_left),
       run({.seen = "At first the bob falls almost freely",
            .quantity = "speed downwards after 0.1 s",
            .law = trial.g * (1 - trial.h) * (1 - std::pow(1 - trial.h, 6)),
            .source = "g(1 − h)(1 − (1 − h)⁶) · 1 s",
            .cause = "λ is multiplied by h, as if it were a force; the λ of (17) is an impulse",
            .test = "check the units: with C in m, λ is in N·s, and λ/m is a speed already",
            .more = "`./lessons/run 2 --step 5`, `./lessons/run practise 5`"},
           hanging(), {.fault = Fault::lambda_times_h}, 6, downwards),
       run({.seen = "It works only for 1 kg",
            .quantity = "speed downwards after 1 s",
            .law = (trial.mass - 1) * trial.g * trial.h,
            .source = "(m − 1)gh, m in kg",
            .cause = "m⁻¹ is missing in (19), so a step leaves 1 − 1/m of JV: a heavy bob sinks, and one below "
                     "½ kg flies off",
            .test = "try 1 kg: if the symptom vanishes, look for the masses in K",
            .more = "`./lessons/run 2 --step 2`, `./lessons/run practise 3`"},
           hanging(), {.fault = Fault::no_mass}, 60, downwards),
       run({.seen = "The rod of a moving bob grows slowly",
            .quantity = "stretch after 2 s at 6 m/s",
            .law = laws::drifted_radius(trial.length, trial.speed, trial.h, 2) - trial.length,
            .source = "L(1 + 2v²ht/L²)^¼ − L",
            .cause = "nothing in the step is wrong: JV = 0 follows the tangent, and b is missing",
            .test = "halve h: the growth nearly halves",
            .more = "`./lessons/run 4 --step 1`, `./lessons/run practise 8`",
            .tolerance = 1e-3},
           [] {
             RodBetween round = hanging();
             round.two.v = {trial.speed, 0};
             return round;
           }(),
           {.gravity = 0}, 120, too_long, {.beta = trial.beta, .gravity = 0})}};
}

SymptomGroup of_correction() {
  const auto correcting = [](Fault fault) { return Recipe{.beta = trial.beta, .gravity = 0, .fault = fault}; };
  const Recipe twice_the_step{.beta = trial.beta, .h = 2 * trial.h, .gravity = 0},
      sixty{.beta = trial.beta, .gravity = 0};
  Symptom frame_rate = run({.seen = "Joints are softer on a slow machine",
                            .quantity = "error left after 0.1 s at 30 steps a second",
                            .law = 100 * std::pow(1 - trial.beta, 3),
                            .source = "(1 − β)³; at 60 steps a second (1 − β)⁶",
                            .cause = "β is a share per step, and the number of steps in a second has changed",
                            .test = "keep h/β when you change h: the half-life stays about the same",
                            .more = "`./lessons/run 4 --step 5`"},
                           hanging(trial.off), twice_the_step, 3, error_left);
  frame_rate.right = error_left.of(after(hanging(trial.off), sixty, 6));
  frame_rate.run->right = sixty;
  return {"The correction",
          {run({.seen = "Small errors grow exponentially",
                .quantity = "error left after 5 steps",
                .law = 100 * std::pow(1 + trial.beta, 5),
                .source = "(1 + β)⁵",
                .cause = "b has the wrong sign: (22) says JV = −(β/h)C, so b = +(β/h)C in (17)",
                .test = "start 1 cm too long and at rest, without gravity: the first step must shorten the rod",
                .more = "`./lessons/run 4 --step 2`, `./lessons/run practise 8`"},
               hanging(trial.off), correcting(Fault::sign_of_bias), 5, error_left),
           run({.seen = "An error takes seconds to go away",
                .quantity = "error left after 1 s",
                .law = 100 * std::pow(1 - trial.beta * trial.h, 60),
                .source = "(1 − βh)⁶⁰",
                .cause = "b = βC lacks the 1/h, so β is a rate in 1/s and not a share per step",
                .test = "measure the half-life: ln 2/β seconds, whatever h is",
                .more = "`./lessons/run 4 --step 4`, `./lessons/run practise 8`"},
               hanging(trial.off), correcting(Fault::no_frame_rate), 60, error_left),
           frame_rate,
           run({.seen = "It works only for rods of 1 m",
                .quantity = "error left after 1 step",
                .law = 100 * (1 - trial.beta / (trial.length + trial.off)),
                .source = "1 − β/|d|, |d| in m",
                .cause = "C is |d| − L, but J belongs to ½(d² − L²)",
                .test = "differentiate C by small steps and compare with J",
                .more = "`./lessons/run 1 --step 7d`, `./lessons/run desk`"},
               hanging(trial.off), correcting(Fault::mixed_forms), 1, error_left),
           run({.seen = "Errors go away twice as fast as β says",
                .quantity = "error left after 1 step",
                .law = 100 * (1 - trial.beta * (2 * trial.length + trial.off) / (trial.length + trial.off)),
                .source = "1 − β(2L + C)/(L + C)",
                .cause = "the ½ is missing in C, but not in J",
                .test = "set β = 1: a small error must vanish in one step, and it changes sign instead",
                .more = "`./lessons/run 1 --step 3`, `./lessons/run practise 1`"},
               hanging(trial.off), correcting(Fault::no_half), 1, error_left),
           run({.seen = "The rod flickers, more and more",
                .quantity = "error left after 10 steps",
                .law = 100 * std::pow(1.1, 10),
                .source = "(1 − β)¹⁰ with β = 2.1",
                .cause = "β is above 2, so each step overshoots by more than the error",
                .test = "halve β: the flicker must die out",
                .more = "`./lessons/run 4 --step 3 --set beta=2.1`"},
               hanging(trial.off), {.beta = 2.1, .gravity = 0}, 10, error_left, sixty)}};
}

SymptomGroup of_turning_bodies() {
  const Vector corner(0.3, trial.arm), top(0, trial.arm);
  const RodBetween box = hanging_box(corner);
  // λ = mgh/(mK) with K = 1/m + a²/I, and the body turns by λa/I; a = r × n with n straight down is −r_x.
  const double a = -corner.x(), K = box.two.inverse_mass + box.two.inverse_inertia * a * a;
  const double right_spin = -trial.g * trial.h / K * a * box.two.inverse_inertia;
  const Recipe falling{.beta = trial.beta};
  const auto with = [](Fault fault) { return Recipe{.beta = trial.beta, .fault = fault}; };
  const RodBetween point{.two = {.inverse_mass = 1 / trial.mass}, .length = 0};
  const auto coordinates_left = [](const RodBetween& rod) {
    return static_cast<double>(std::isfinite(rod.two.x.x())) + static_cast<double>(std::isfinite(rod.two.x.y()));
  };
  Symptom not_a_number{.seen = "Everything is NaN after the first step",
                       .quantity = "coordinates of the bob that are still numbers",
                       .unit = "of 2",
                       .law = 0,
                       .source = "0/0",
                       .cause = "K is 0: both ends of the rod are at the same point, or neither body can move",
                       .test = "print K before dividing: it must be above 0",
                       .more = "`./lessons/run 2 --step 2`"};
  not_a_number.wrong = coordinates_left(after(point, falling, 1));
  not_a_number.right = coordinates_left(after(hanging(), falling, 1));
  return {"Bodies that turn",
          {run({.seen = "The box turns the wrong way",
                .quantity = "ω of a box that hangs by its corner, after 1 step",
                .law = -right_spin,
                .source = "λa/I with the sign of n × r",
                .cause = "the lever is n × r in place of r × n",
                .test = "push on the anchor and watch ω, or compare J with small steps",
                .more = "`./lessons/run 1 --step 4`, `./lessons/run practise 2`"},
               box, with(Fault::lever_backwards), 1, spin),
           run({.seen = "It works until the body has turned",
                .quantity = "stretch of a box that is upside down, after 2 s",
                .law = 2 * trial.arm,
                .source = "2|r|",
                .cause = "r is kept as it was at the start; it must turn with its body",
                .test = "turn the body by 180° and measure the rod from anchor to anchor",
                .more = "`./lessons/run 1 --step 3`, `./lessons/run practise 2`"},
               hanging_box(top, {-1, 0}), with(Fault::lever_left), 120, too_long),
           run({.seen = "It comes to rest at the wrong length",
                .quantity = "stretch after 2 s",
                .law = -trial.arm,
                .source = "−|r|",
                .cause = "C measures from centre to centre, J from anchor to anchor",
                .test = "draw P₁ and P₂ and measure between them",
                .more = "`./lessons/run 1 --step 3`, `./lessons/run practise 2`"},
               hanging_box(top), with(Fault::between_centres), 120, too_long),
           not_a_number}};
}

/// How fast the last bob of a hanging chain of equal bobs still falls after one sweep from the top, over gh.
double last_bob_after_a_sweep(int links) {
  std::vector<double> v(static_cast<std::size_t>(links), 1.0);
  v[0] = 0;  // the first bob hangs from a fixed point
  for (std::size_t i = 1; i < v.size(); ++i) v[i - 1] = v[i] = (v[i - 1] + v[i]) / 2;
  return v.back();
}

/// The velocity of a ball that meets the ground at −1 m/s in `rows` equal rows, each solved from the velocity
/// before all of them.
double solved_at_once(int rows) {
  double v = -1;
  const double JV = v;
  for (int i = 0; i < rows; ++i) v -= JV;
  return v;
}

/// The velocity of a ball that leaves the ground at `v`, after its row.
double leaving(double v, bool clamped) {
  const double lambda = -v;  // (17) for a unit mass
  return v + (clamped ? std::max(lambda, 0.0) : lambda);
}

SymptomGroup of_several_rows() {
  constexpr int links = 10;
  const Sweeping warm{.links = links, .sweeps = 1, .beta = trial.beta}, cold{links, 1, trial.beta, false};
  return {
      "Several rows, and contacts",
      {{.seen = "A chain is like rubber",
        .quantity = "speed left at the last of 10 bobs after a sweep",
        .unit = "% of gh",
        .law = 100 * (1 - std::pow(2, 1 - links)),
        .source = "1 − 2⁻⁹",
        .cause = "there are too few sweeps for news of the anchor to reach the end",
        .test = "double the sweeps: the stretch shrinks; that would not cure a wrong J",
        .more = "`./lessons/run 3 --step 6`, `./lessons/run practise 7`",
        .wrong = 100 * last_bob_after_a_sweep(links),
        .compared = "direct solve"},
       {.seen = "A chain rings, more and more",
        .quantity = "growth of an error in a step",
        .unit = "times",
        .law = growth_law(warm),
        .source = "largest root of the cubic of step 6b",
        .cause = "the warm start repeats last step's correction, and few sweeps cannot take it back",
        .test = "start cold: the ringing dies out",
        .more = "`./lessons/run 4 --step 6b`",
        .wrong = measured_growth(warm, trial.h, 2000),
        .right = measured_growth(cold, trial.h, 2000),
        .tolerance = 1e-3},
       {.seen = "A ball bounces when it should not",
        .quantity = "speed after two rows (1 m/s before)",
        .unit = "m/s",
        .law = 1,
        .source = "−u + 2u",
        .cause = "rows that share a body were all solved from the velocity before; each took the whole speed away",
        .test = "solve them one after the other: (20) must act on V before the next (17)",
        .more = "`./lessons/run 3 --step 1`, `./lessons/run practise 7`",
        .wrong = solved_at_once(2)},
       {.seen = "Bodies stick to the ground",
        .quantity = "speed, after its row, of a ball leaving at 2 m/s",
        .unit = "m/s",
        .law = 0,
        .source = "JV = 0",
        .cause = "the row of a contact may pull; λ must not become negative",
        .test = "lift the body: λ must be 0",
        .more = "`./lessons/run 5 --step 1`, `./lessons/run practise 9`",
        .wrong = leaving(2, false),
        .right = leaving(2, true)}}};
}

}  // namespace

std::vector<SymptomGroup> all_symptoms() {
  return {of_one_row(), of_correction(), of_turning_bodies(), of_several_rows()};
}

}  // namespace byhand::baumgarte
