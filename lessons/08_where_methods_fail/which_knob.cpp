// Step 6: every failure with every knob.

#include <cmath>
#include <optional>

#include "lessons/08_where_methods_fail/laws/column.hpp"
#include "lessons/08_where_methods_fail/laws/redundant.hpp"
#include "lessons/08_where_methods_fail/laws/transverse.hpp"
#include "lessons/08_where_methods_fail/laws/warm_start.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::Outcome;

enum Knobs { none, more_sweeps, less_beta, substeps, stiffness, softness, how_many };

struct Failure {
  std::string name;
  /// How it ends with a knob turned; nothing where it has no such knob.
  std::function<std::optional<Outcome>(int knob)> with;
  Knobs cure;
};

constexpr int times = 10, parts = 4, stiffer = 4;  // sweeps, substeps, contacts
constexpr double hundredth = 0.01;                 // of β; of each row's JM⁻¹Jᵀ

std::optional<Outcome> stack(int knob) {
  laws::Column column{.boxes = 15, .sweeps = 4};
  if (knob == more_sweeps) column.sweeps *= times;
  if (knob == substeps) column.substeps = parts;
  if (knob > substeps || knob == less_beta) return {};
  return laws::lean(column);
}

std::optional<Outcome> warm_chain(int knob) {
  laws::WarmChain chain{.links = 10, .sweeps = 4, .beta = 0.3};
  if (knob == more_sweeps) chain.sweeps *= times;
  if (knob == less_beta) chain.beta *= hundredth;
  if (knob == substeps) chain.substeps = parts;
  if (knob > substeps) return {};
  return laws::run(chain);
}

std::optional<Outcome> taut_chain(int knob) {
  laws::TautChain chain{.end_mass = 600};
  if (knob == more_sweeps) chain.sweeps = 2000;
  if (knob == substeps) chain.substeps = parts;
  if (knob > substeps || knob == less_beta) return {};
  return laws::run(chain);
}

std::optional<Outcome> soft_stack(int knob) {
  laws::Column column{.boxes = 18, .sweeps = 40, .frequency = 30};
  if (knob == more_sweeps) column.sweeps *= times;
  if (knob == substeps) column.substeps = parts;
  if (knob == stiffness) column.frequency *= stiffer;
  if (knob > stiffness || knob == less_beta) return {};
  return laws::buckle(column);
}

/// Settles if the pulls end below a hundred weights.
std::optional<Outcome> two_rods(int knob) {
  laws::ConflictingRods rods{.conflict = 0.1};
  if (knob == more_sweeps) rods.sweeps *= times;
  if (knob == less_beta) rods.beta *= hundredth;
  if (knob == substeps) rods.step /= parts;
  if (knob == softness) rods.softness = 10 * hundredth / 3;
  if (knob == stiffness) return {};
  const double at_10 = laws::pull_apart(rods, 10), at_20 = laws::pull_apart(rods, 20);
  return at_20 > 1e4 ? Outcome::explodes : at_20 > 1.01 * at_10 ? Outcome::drifts : Outcome::settles;
}

const std::vector<Failure> failures{{"leans", stack, more_sweeps},
                                    {"rings", warm_chain, less_beta},
                                    {"explodes", taut_chain, substeps},
                                    {"buckles", soft_stack, stiffness},
                                    {"quarrels", two_rods, softness}};

}  // namespace

void which_knob(const Setting&, Page& page) {
  const int rows = static_cast<int>(failures.size());
  const std::vector<std::optional<Outcome>> outcomes =
      page.side_by_side(rows * how_many, [](int cell) { return failures[cell / how_many].with(cell % how_many); });

  page.text(
      R"(Five failures, one of each kind that you have seen, each a little beyond its boundary. And five knobs,
      each turned far: @ times the sweeps; a hundredth of the correction; @ substeps; contacts of @ times the
      frequency; softness.)",
      times, parts, stiffer);
  page.choose(
      {.ask = "A chain with a heavy end flies apart, solved exactly as with 2000 sweeps. What helps?",
       .options = {{"a smaller β", "It corrects less, but nothing was wrong with the correction."},
                   {"solving each step directly",
                    "It was; and what is exact for a frozen J is still a spring that is too stiff for its step."},
                   {"substeps", "If sweeps change nothing, the rows are solved: it is the step."},
                   {"softness", "A soft rod stretches; sideways the tension pulls as before."}},
       .answer = 2,
       .hints = {"Sweeps change nothing. Which family is that?"}});
  renderer::Chart picture;
  const std::vector<std::string> knobs{"none",
                                       say("@ × sweeps", times),
                                       say("β / @", 1 / hundredth),
                                       say("@ substeps", parts),
                                       say("@ × stiffer", stiffer),
                                       "softness"};
  std::vector<double> x, y;
  for (int i = 0; i < how_many; ++i) {
    x.push_back(i);
    picture.x.ticks.push_back({x.back(), knobs[static_cast<std::size_t>(i)]});
  }
  for (int i = 0; i < rows; ++i) {
    y.push_back(i);
    picture.y.ticks.push_back({y.back(), failures[static_cast<std::size_t>(i)].name});
  }
  picture.x.label = "which knob is turned";
  picture.y.reversed = true;
  picture.heat_map = cells(x, y, outcomes);
  page.figure("which_knob",
              say(R"(Each cell is a run. From above: a hard stack leans; a warm chain rings; a taut chain, solved
                  exactly (or with @ sweeps), explodes; a soft stack buckles; two rods quarrel. An empty cell: it
                  has no such knob.)",
                  2000),
              picture);

  int fail = 0, cured = 0;
  for (int i = 0; i < rows; ++i) {
    fail += outcomes[i * how_many] != Outcome::settles;
    cured += outcomes[i * how_many + failures[i].cure] == Outcome::settles;
  }
  page.text(
      R"(Read it by rows: each failure has its own cure. Read it by columns: no knob cures all. So look first, then
      turn: does it *creep*, always one way? Sweeps, structure. Does it *ring*? Less correction, or one that λ does
      not remember. Do *sweeps change nothing*? The step, or stiffness. Is it *calm* and λ grows? The rows.)");
  page.claim({.quantity = "failures that fail while no knob is turned",
              .unit = "1",
              .expected = static_cast<double>(rows),
              .source = "laws B6, B7, B8, B17, B18",
              .measured = static_cast<double>(fail),
              .tolerance = absolute(0)});
  page.claim({.quantity = "failures that their own knob cures",
              .unit = "1",
              .expected = static_cast<double>(rows),
              .source = "the same",
              .measured = static_cast<double>(cured),
              .tolerance = absolute(0)});
}

}  // namespace byhand::failures
