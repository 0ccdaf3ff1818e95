// Step 6: every failure with every knob.

#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/column.hpp"
#include "lessons/laws/redundant.hpp"
#include "lessons/laws/transverse.hpp"
#include "lessons/laws/warm_start.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;

enum Knobs { none, more_sweeps, direct, less_beta, substeps, stiffness, softness, how_many };

struct Failure {
  std::string scene;
  /// How it ends with a knob turned; nothing where it was not run.
  std::function<std::optional<Outcome>(int knob)> with;
  std::vector<Knobs> cures;  // what the steps before say
};

constexpr int times = 10, parts = 4, higher = 4;  // sweeps, substeps, frequency of contacts
constexpr double hundredth = 0.01;                // of β

/// Turns the knobs that all scenes have: their sweeps, none of which means a direct solve.
void turn(int knob, int& count) {
  if (knob == more_sweeps) count *= times;
  if (knob == direct) count = 0;
}

std::optional<Outcome> stack(int knob) {
  laws::Column column{.boxes = 15, .sweeps = 4};
  turn(knob, column.sweeps);
  if (knob == substeps) column.substeps = parts;
  if (knob > substeps || knob == less_beta) return {};
  return laws::lean(column);
}

std::optional<Outcome> warm_chain(int knob) {
  laws::WarmChain chain{.links = 10, .sweeps = 4, .beta = 0.3};
  turn(knob, chain.sweeps);
  if (knob == less_beta) chain.beta *= hundredth;
  if (knob == substeps) chain.substeps = parts;
  if (knob > substeps) return {};
  return laws::run(chain);
}

std::optional<Outcome> taut_chain(int knob) {
  laws::TautChain chain{.end_mass = 600, .sweeps = 2000};
  turn(knob, chain.sweeps);
  if (knob == less_beta) chain.beta *= hundredth;
  if (knob == substeps) chain.substeps = parts;
  if (knob > substeps) return {};
  return laws::run(chain);
}

std::optional<Outcome> soft_stack(int knob) {
  laws::Column column{.boxes = 18, .sweeps = 40, .frequency = 30};
  turn(knob, column.sweeps);
  if (knob == substeps) column.substeps = parts;
  if (knob == stiffness) column.frequency *= higher;
  if (knob > stiffness || knob == less_beta) return {};
  return laws::buckle(column);
}

/// Breaks above 10⁴ N, 340 weights of the bob.
std::optional<Outcome> two_rods(int knob) {
  laws::ConflictingRods rods{.conflict = 0.1};
  turn(knob, rods.sweeps);
  if (knob == less_beta) rods.beta *= hundredth;
  if (knob == substeps) rods.step /= parts;
  if (knob == softness) rods.softness = 0.1 / 3;  // a tenth of each row's JM⁻¹Jᵀ
  if (knob == stiffness) return {};
  try {
    const double at_10 = laws::pull_apart(rods, 10), at_20 = laws::pull_apart(rods, 20);
    return at_20 > 1e4 ? Outcome::explodes : at_20 > 1.01 * at_10 ? Outcome::drifts : Outcome::settles;
  } catch (const SingularSystem&) {
    return Outcome::no_solution;
  }
}

const std::vector<Failure> failures{{"hard stack", stack, {more_sweeps, direct, substeps}},
                                    {"warm chain", warm_chain, {more_sweeps, direct, less_beta}},
                                    {"taut chain", taut_chain, {substeps}},
                                    {"soft stack", soft_stack, {stiffness}},
                                    {"two rods", two_rods, {softness}}};

}  // namespace

void which_knob(const Setting&, Page& page) {
  const int rows = static_cast<int>(failures.size());
  const std::vector<std::optional<Outcome>> outcomes =
      page.side_by_side(rows * how_many, [](int cell) { return failures[cell / how_many].with(cell % how_many); });
  const auto holds = [&](int row, int knob) { return outcomes[row * how_many + knob] == Outcome::settles; };

  page.text(
      R"(Here are five failures from the steps before, each beyond its limit: a hard stack that leans, a chain that
      rings from its warm start, a taut chain with a heavy end, a soft stack that buckles, and two rods that contradict
      each other. And here are six knobs, each turned far: @ times the sweeps, a direct solve, a hundredth of β, @
      substeps, contacts of @ times the frequency, and softness.)",
      times, parts, higher);
  page.choose(
      {.ask = say(
           R"(@ substeps, each with the full number of sweeps, cure the leaning stack and the taut chain. Do they cure the chain
                  that rings from its warm start?)",
           parts),
       .options = {{"yes", "They would if the limit of β grew as h shrinks."},
                   {"no", "(1 − q)/q contains no h: each substep adds as large a share of the error to λ."}},
       .answer = holds(1, substeps) ? 0 : 1,
       .hints = {"By what law does this chain ring?", "β < (1 − q)/q, q = cos²ᵏ(π/2N).",
                 "Which of β, k and N do substeps change?"}});
  renderer::Chart picture;
  const std::vector<std::string> knobs{"none",
                                       say("@ × sweeps", times),
                                       "direct",
                                       say("β / @", 1 / hundredth),
                                       say("@ substeps", parts),
                                       say("@ × frequency", higher),
                                       "softness"};
  std::vector<double> x, y;
  for (int i = 0; i < how_many; ++i) {
    x.push_back(i);
    picture.x.ticks.push_back({x.back(), knobs[static_cast<std::size_t>(i)]});
  }
  for (int i = 0; i < rows; ++i) {
    y.push_back(i);
    picture.y.ticks.push_back({y.back(), failures[static_cast<std::size_t>(i)].scene});
  }
  picture.x.label = "which knob is turned";
  picture.y.reversed = true;
  picture.heat_map =
      cells(x, y, outcomes, {"holds", "still leans or grows", "rings", "falls, tears or breaks", "no solution"});
  page.figure("which_knob", "Each cell is one run of 15 s or more. Empty cells were not run.", picture);

  int fail = 0, cured = 0, cures = 0, universal = 0;
  for (int row = 0; row < rows; ++row) {
    fail += !holds(row, none);
    for (const Knobs cure : failures[row].cures) ++cures, cured += holds(row, cure);
  }
  for (int knob = 1; knob < how_many; ++knob) {
    bool all = true;
    for (int row = 0; row < rows; ++row) all = all && holds(row, knob);
    universal += all;
  }
  page.text(
      R"(@ So look first, then turn.

      - Does it *give way slowly*, always in one direction? Then more sweeps, substeps, or a direct solve.
      - Does it *ring*, and does a smaller β calm it? Then that, or a correction that λ does not remember, or a direct
        solve. If not, try the other lines: near their limits stacks and taut chains ring too.
      - Do *more sweeps change nothing*? Then a shorter step, or stiffer contacts.
      - Is it *calm* while λ grows, or has a direct solve no solution? Then look at the rows.)",
      page.verdict(
          {{.when = Quantity("knobs that cure all five", universal) < 1,
            .say = "Each of the five can be cured, but no knob that was tried on all five cures them all."},
           {.when = Quantity("knobs that cure all five", universal) >= 1,
            .say = "Each of the five can be cured, and one knob cures all five."}}));
  page.claim("failures that fail while no knob is turned", static_cast<double>(fail), "1",
             is(static_cast<double>(rows),
                "laws of creep, warm starts, transverse instability, buckling and conflicting rows", absolute(0)));
  page.claim("cures named by the steps before that cure", static_cast<double>(cured), "1",
             is(static_cast<double>(cures), "the same", absolute(0)));
}

}  // namespace byhand::failures
