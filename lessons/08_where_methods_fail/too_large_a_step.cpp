// Step 3: the step is too large.

#include <algorithm>
#include <cmath>

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/laws/transverse.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::Outcome;
using laws::TautChain;

double heaviest_at(double rate) { return laws::heaviest_end({.step = 1 / rate}); }

/// The heaviest end that settles, by experiment.
double heaviest_measured(double rate) {
  const double law = heaviest_at(rate);
  return laws::bisect(
      [=](double end_mass) {
        return laws::run(TautChain{.end_mass = end_mass, .step = 1 / rate}) == Outcome::settles;
      },
      0.5 * law, 2 * law, 0.002);
}

Film<PlaneParticle> film(double end_mass, int sweeps) {
  const TautChain chain;
  const double length = chain.links * chain.length;
  const auto swinging = [&](std::string name, const RowSolver& solver, int substeps) {
    return Take<PlaneParticle>{
        std::move(name),
        {rod_chain<PlaneParticle, NormalisedDistance>({.links = chain.links,
                                                       .length = chain.length,
                                                       .mass = chain.mass,
                                                       .end_mass = end_mass,
                                                       .angle = 0.25}),
         VelocityStepping{.solver = solver, .drift = Baumgarte{0.2}, .substeps = substeps}}};
  };
  return Film<PlaneParticle>(
      {.takes = {swinging("exact", Direct{}, 1), swinging(say("@ sweeps", sweeps), GaussSeidel{sweeps}, 1),
                 swinging("exact, 4 substeps", Direct{}, 4)},
       .view = {-0.4 * length, -1.2 * length, 0.8 * length, 1.25 * length},
       .seconds = 3,
       .gauge = {.label = "largest |C| (m)", .scale = renderer::Scale::logarithmic, .range = {{1e-6, 2}}},
       .read = [](const Scene<PlaneParticle>& scene) { return position_error(scene).max; },
       .failed = [](const Scene<PlaneParticle>& scene) { return !(position_error(scene).max < 0.5); },
       .failure = "torn apart",
       .draw =
           [end_mass](renderer::Canvas& canvas, const Scene<PlaneParticle>& scene) {
             pictures::draw(canvas, pictures::rods_and_bobs(scene),
                            {.bob = std::min(6.0, 34 / std::cbrt(end_mass)), .rod = 3});
           }});
}

}  // namespace

void too_large_a_step(const Setting& setting, Page& page) {
  const double ratio = setting.end_mass, rate = 60;
  const TautChain chain{.end_mass = ratio};
  const double limit = heaviest_measured(rate), halved = heaviest_measured(2 * rate);

  page.text(
      R"(**Symptom:** it flies apart, from one moment to the next and for no reason; *and more sweeps change
      nothing*. The third family is solved well, even exactly. What is wrong is the step.)");
  page.text(
      R"(A light chain of @ links of 1 kg and 1 m carries @ kg at its end. Solve each step directly: JV = 0 to the
      last bit, in every step. But J is held still while the step moves. Sideways, a bob that is off by x is pulled
      back by T x/l from where it *was*: a taut chain is an explicit spring, and that holds only while ωh < 2.)",
      chain.links, ratio);
  page.predict(
      {.ask = say(R"(Each step is solved exactly, and the chain explodes from an end mass of @ kg on. h is halved.
                  From which mass now?)",
                  Value(limit, 3)),
       .answer = halved,
       .unit = "kg",
       .tolerance = 0.1 * halved,
       .wrong = {{limit,
                  "It is exact for a frozen J: sideways the tension is an explicit spring, and T·h² counts."},
                 {2 * limit, "ω grows with the root of the tension, so ωh < 2 allows four times as much."}},
       .hints = {"ω² = T/(ml), and ωh has to stay below 2."},
       .right = "T h² counts: half the step, four times the load."});
  page.formula(
      "ω_max h < 2,   about T h²/(m l) < 1:   @ kg at @ Hz",
      R"(\omega_{\max} h < 2, \quad \text{about } \frac{T h^2}{m\,l} < 1: \quad @\ \mathrm{kg\ at\ } @\ \mathrm{Hz})",
      Value(heaviest_at(rate), 4), rate);

  const int many = 1000;
  const Film<PlaneParticle> chains = film(ratio, many);
  page.sequence("exploding_chain",
                say(R"(The same chain with @ kg at its end at @ Hz. Solved exactly: @. With @ sweeps a step: @.
                    Exactly in 4 substeps: @.)",
                    ratio, rate, chains.fate(0), many, chains.fate(1), chains.fate(2)),
                Seconds{chains.seconds()}, chains.drawing());

  const Map map = map_of(page, knob("steps a second (Hz)", 30, 480, setting.resolution),
                         knob("end mass / mass of a link (1)", 10, 1e5, setting.resolution),
                         [](double hz, double r) { return laws::run(TautChain{.end_mass = r, .step = 1 / hz}); });
  page.figure("mass_and_step",
              say("Each cell is a run of an exactly solved chain of @ links. Dashed: ω_max h = 2.", chain.links),
              chart(map, "ω_{max} h = 2", heaviest_at));
  const double foreseen = share_foreseen(map, [](double hz, double r) { return r < heaviest_at(hz); });
  page.text("Of @ runs the law foresees @ %.", map.outcomes.size(), Value(100 * foreseen, 3));
  page.text(
      R"(**Which knob?** Only h: substeps (4 of them bear about @ kg), which divide the step where it counts. Or
      links that are heavier or fewer. Not sweeps, not β, not another way to solve the same rows.)",
      Value(heaviest_at(4 * rate), 3));

  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.95,
              .source = "law B7",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  for (const double hz : {rate, 2 * rate})
    page.claim({.quantity = say("heaviest end at @ Hz, by bisection", hz),
                .unit = "kg",
                .expected = heaviest_at(hz),
                .source = "law B7: ω_max h = 2",
                .measured = hz == rate ? limit : halved,
                .tolerance = relative(0.02)});
}

}  // namespace byhand::failures
