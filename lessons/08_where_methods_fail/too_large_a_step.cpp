// Step 3: the step is too large.

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/transverse.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::failures {
namespace {

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
       .failure = "breaks",
       .success = "holds",
       .draw =
           [end_mass](renderer::Canvas& canvas, const Scene<PlaneParticle>& scene, const renderer::Look& look) {
             pictures::draw(canvas, pictures::rods_and_bobs(scene),
                            {.bob = std::min(6.0, 34 / std::cbrt(end_mass)), .rod = 3, .bodies = look});
           }});
}

/// What the three runs of the film show.
std::string seen(Page& page, const Film<PlaneParticle>& chains, double end_mass, double limit,
                 double limit_of_substeps) {
  const std::string fate = page.verdict(
      {{.when = where(chains.fails(0), chains.fails(1)),
        .say = say("With @ kg the chain breaks, however well its rows are solved.", Value(end_mass, 6))},
       {.when = where(chains.holds(0), chains.holds(1), chains.holds(2)),
        .say = say("With @ kg at its end it holds in all three runs. Choose a heavier end to see it fly apart.",
                   Value(end_mass, 6))},
       {.when = either(chains.fails(0), either(chains.fails(1), chains.fails(2))),
        .say = say("With @ kg, on a chain that swings, the runs differ: so @ the limit, small differences decide.",
                   Value(end_mass, 6), end_mass > 3 * limit ? "far beyond" : "near to")}});
  if (!chains.failed(0) || !chains.failed(1)) return fate;
  return say("@ @", fate,
             page.verdict({{.when = chains.holds(2),
                            .say = say("4 substeps hold it: their limit is @ kg.", Value(limit_of_substeps, 3))},
                           {.when = chains.fails(2),
                            .say = say("With 4 substeps it breaks too: their limit is @ kg.",
                                       Value(limit_of_substeps, 3))}}));
}

}  // namespace

void too_large_a_step(const Setting& setting, Page& page) {
  const double end_mass = setting.end_mass, rate = 60;
  const TautChain chain{.end_mass = end_mass};
  const double limit = heaviest_measured(rate), halved = heaviest_measured(2 * rate),
               one_link =
                   chain.mass * chain.length / (chain.step * chain.step * gravity);  // T h²/(m l) = 1, T = Mg

  page.text(
      R"(**Symptom of the third family:** the scene flies apart suddenly, and *more sweeps change nothing*. The rows
      are solved well, perhaps exactly; but the time step is too long.)");
  page.text(
      R"(A light chain of @ links, 1 kg and 1 m each, carries @ kg at its end. Each step is solved directly, so its
      rows hold to rounding. But J keeps the directions that the links had when the step began. A bob off to one side
      is pulled back by the tension T of its two links, with the force that belongs to where it *was*. So sideways a
      taut chain is an explicit spring.)",
      chain.links, setting.end_mass);
  page.predict(
      {.ask = say(
           R"(Even when every step is solved exactly, the chain flies apart once its end mass exceeds @ kg. What
                  is this limit if h is halved?)",
           Value(limit, 3)),
       .answer = halved,
       .unit = "kg",
       .tolerance = 0.1 * halved,
       .wrong = {{limit, "The rows are solved exactly in both, but the spring sees a step half as long."},
                 {2 * limit, "ω grows with the square root of the tension, so ωh < 2 allows four times as much."}},
       .hints = {"Sideways the chain is an explicit spring. What is its ω?",
                 "ω² grows with T/(ml), and symplectic Euler needs ωh < 2.",
                 "With h/2, ω may be twice as large, so ω² and T may be four times as large."},
       .hinted = 4 * limit,
       .right = say(
           R"(What counts is T h²: half the step allows four times the tension. That would be @ kg; the rest is the
                       links' own weight, which is part of T.)",
           Value(4 * limit, 4))});
  page.formula(
      "ω_max h < 2, for a long light chain T h²/(m l) < 1:   @ kg at @ Hz",
      R"(\omega_{\max} h < 2, \quad \text{for a long light chain } \frac{T h^2}{m\,l} < 1: \quad @\ \mathrm{kg\ at\ } @\ \mathrm{Hz})",
      Value(heaviest_at(rate), 4), rate);
  page.derivation(
      "Why T h²/(m l) < 1",
      {{"one bob moves sideways by x between two links at rest: each link pulls it back", "m ẍ = −2 T x/l",
        R"(m\ddot x = -2T\,x/l)"},
       {"its neighbours move by x the other way, so that each link leans twice as much", "m ẍ = −4 T x/l",
        R"(m\ddot x = -4T\,x/l)"},
       {"that is the fastest wave of a long chain", "ω²_max = 4T/(m l)", R"(\omega_{\max}^2 = \frac{4T}{m\,l})"},
       {"symplectic Euler multiplies an oscillation by z", "z² − (2 − ω²h²) z + 1 = 0,   |z| = 1 while ωh ≤ 2",
        R"(z^2 - (2 - \omega^2h^2)\,z + 1 = 0, \quad |z| = 1 \text{ while } \omega h \le 2)"},
       {"both together", "4T h²/(m l) < 4", R"(\frac{4T h^2}{m\,l} < 4)"},
       {"with T = Mg of the end mass alone", say("M < m l/(g h²) = @ kg", Value(one_link, 3)),
        say(R"(M < \frac{m\,l}{g h^2} = @\ \mathrm{kg})", latex_number(one_link, 3))},
       {say("the eigenvalue of all @ links, the lowest of which ends at the heavy bob", chain.links),
        say("M < @ kg", Value(heaviest_at(rate), 4)),
        say(R"(M < @\ \mathrm{kg})", latex_number(heaviest_at(rate), 4))}});

  const int many = 1000;
  const Film<PlaneParticle> chains = film(end_mass, many);
  page.sequence(
      "exploding_chain",
      say(R"(The chain with @ kg at its end, @ steps a second. Solved exactly, it @; with @ sweeps a step,
                    it @; solved exactly in 4 substeps, it @.)",
          setting.end_mass, rate, chains.fate(0), many, chains.fate(1), chains.fate(2)),
      Seconds{chains.seconds()}, chains.drawing());
  page.text("The limit of a chain at rest is @ kg. @", Value(limit, 3),
            seen(page, chains, end_mass, limit, heaviest_at(4 * rate)));

  const Map map = map_of(page, knob("steps a second (Hz)", 30, 480, setting.resolution),
                         knob("end mass / mass of a link", 10, 1e5, setting.resolution),
                         [](double hz, double r) { return laws::run(TautChain{.end_mass = r, .step = 1 / hz}); });
  page.figure("mass_and_step",
              say("Each cell is one run of an exactly solved chain of @ links. Dashed: ω_max h = 2.", chain.links),
              chart(map, "ω_{max} h = 2", heaviest_at));
  const Agreement agreed = agreement(map, heaviest_at, Settles::below);
  page.text(agreed.sentence());
  page.text(
      R"(**Which knob?** A shorter step, most cheaply by substeps. Heavier or longer links help too. More sweeps, a
      smaller β or another solver of the same rows do not.)");
  page.text(
      R"(From the casebook, faults of steps that are solved exactly: a pendulum that loses energy,
      `./lessons/run case 7`; corrections of positions that lose spin, `./lessons/run case 10`.)");

  claim_agreement(page, agreed, 0.15, "law of transverse instability", setting.resolution);
  for (const double hz : {rate, 2 * rate})
    page.claim(say("heaviest end at @ Hz, by bisection", hz), hz == rate ? limit : halved, "kg",
               is(heaviest_at(hz), "law of transverse instability: ω_max h = 2", relative(0.02)));
  page.claim("chain in the film, exactly and by sweeps: runs that fail",
             1.0 * chains.failed(0) + 1.0 * chains.failed(1), "1",
             is(end_mass < limit ? 0.0 : 2.0, "law of transverse instability", absolute(0)),
             either(Quantity("end mass/limit", end_mass / limit) < 0.7,
                    within(1.3, Quantity("end mass/limit", end_mass / limit), 10)));
}

}  // namespace byhand::failures
