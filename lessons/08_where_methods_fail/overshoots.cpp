// Step 2: the correction overshoots.

#include <algorithm>
#include <cmath>

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/laws/warm_start.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::Outcome;

double limit_of_beta(int links, double sweeps) {
  return laws::largest_beta(std::pow(laws::left_by_a_sweep(links), sweeps));
}

/// The smallest β with which errors do not die out, by bisection.
double beta_that_rings(int links, int sweeps) {
  const double law = limit_of_beta(links, sweeps);
  const int steps = static_cast<int>(4500 * std::max(1.0, 0.025 / law));  // the nearer q is to 1, the slower
  return laws::bisect(
      [=](double beta) {
        return laws::run(laws::WarmChain{.links = links, .sweeps = sweeps, .beta = beta, .steps = steps}) ==
               Outcome::settles;
      },
      0.5 * law, std::min(1.6 * law, 2.3), 0.002);
}

Film<PlaneParticle> film(int links, int sweeps, double beta) {
  const auto hanging = [&](std::string name, const VelocityStepping& method) {
    return Take<PlaneParticle>{std::move(name),
                               {rod_chain<PlaneParticle, NormalisedDistance>({.links = links}), method}};
  };
  const double length = links;
  return Film<PlaneParticle>(
      {.takes = {hanging("warm", {GaussSeidel{sweeps}, Baumgarte{beta}}),
                 hanging("cold", {GaussSeidel{.sweeps = sweeps, .warm_start = false}, Baumgarte{beta}}),
                 hanging("split impulse", {GaussSeidel{sweeps}, SplitImpulse{beta}})},
       .view = {-0.14 * length, -1.12 * length, 0.28 * length, 1.17 * length},
       .gauge = {.label = "largest |C| (m)", .scale = renderer::Scale::logarithmic, .range = {{1e-4, 2}}},
       .read = [](const Scene<PlaneParticle>& chain) { return position_error(chain).max; },
       .failed = [](const Scene<PlaneParticle>& chain) { return !(position_error(chain).max < 0.5); },
       .failure = "torn apart",
       .draw =
           [](renderer::Canvas& canvas, const Scene<PlaneParticle>& chain) {
             pictures::draw(canvas, pictures::rods_and_bobs(chain), {.bob = 7, .rod = 4});
           }});
}

}  // namespace

void overshoots(const Setting& setting, Page& page) {
  const int links = setting.links, sweeps = setting.sweeps;
  const double beta = setting.beta, q = std::pow(laws::left_by_a_sweep(links), sweeps),
               limit = limit_of_beta(links, sweeps);

  page.text(
      R"(**Symptom:** what is wrong changes sign, over and over, a little more each time. *It rings.* The second
      family has done its sums well enough; it pays too much back.)");
  page.text(
      R"(One row solved exactly takes any β below 2 (law 1). A chain of @ links that is warm-started and swept @
      times a step is another matter. A step begins with all of last step's λ, and last step's λ held a correction.
      The sweeps should take that out again, but of the slowest wave they leave q = cos²ᵏ(π/2N) = @. So the
      correction is paid twice, three times, on and on.)",
      links, sweeps, Value(q, 3));
  const double here = beta_that_rings(links, sweeps), twice = beta_that_rings(2 * links, sweeps);
  page.predict({.ask = say(R"(@ links, @ warm sweeps: errors ring up from β = @ on. From where with twice as many
                           links and as many sweeps?)",
                           links, sweeps, Value(here, 3)),
                .answer = twice,
                .unit = "1",
                .tolerance = 0.15 * twice,
                .wrong = {{here / 2, "News walks like a drunkard: twice as far takes four times as long."},
                          {here,
                           R"(The limit is (1 − q)/q, and q is what the sweeps leave of the slowest wave: longer
                           waves, more left.)"}},
                .hints = {"How many sweeps does a wave take that is twice as long?"},
                .right = "1 − q is what the sweeps take of the slowest wave, and it falls with N²."});

  const Film<PlaneParticle> chains = film(links, sweeps, beta);
  page.sequence(
      "ringing_chain",
      say(R"(Three chains of @ links let go at rest, β = @ and @ sweeps a step. Warm: @. Started cold, it ends @ m
          off. By split impulse, which moves positions and leaves no correction in λ, @ m.)",
          links, setting.beta, sweeps, chains.fate(0), Value(chains.last(1), 2), Value(chains.last(2), 2)),
      Seconds{chains.seconds()}, chains.drawing());
  page.text(
      R"(Write C for the slowest wave's error and v for its rate. What one warm step does to them is linear, and
      multiplies them by a root z of)");
  page.formula(
      "z³ − [1 + 2q − (1 − q)β] z² + 3q z − q = 0,   |z| < 1 only for β < (1 − q)/q = @",
      R"(z^3 - [1 + 2q - (1-q)\beta]\,z^2 + 3q\,z - q = 0, \qquad |z| < 1 \iff \beta < \frac{1-q}{q} = @)",
      Value(limit, 3));

  const Map map = map_of(
      page, counting_knob("warm sweeps a step (1)", 1, 64, setting.resolution),
      knob("β (1)", 0.01, 2.5, setting.resolution), [links](double k, double b) {
        return laws::run(laws::WarmChain{.links = links, .sweeps = static_cast<int>(k), .beta = b, .steps = 1500});
      });
  page.figure("beta_and_sweeps",
              say("Each cell is a run of a chain of @ links. Dashed: β = (1 − q)/q, and 2.", links),
              chart(map, "β = (1 − q)/q, and 2", [links](double k) { return limit_of_beta(links, k); }));
  const double foreseen = share_foreseen(map, [links](double k, double b) { return b < limit_of_beta(links, k); });
  page.text(
      R"(Of @ runs the law foresees @ %. "Usually between 0.1 and 0.3" is a horizontal band in this map: it takes
      about @ sweeps to be safe at 0.2 with @ links.)",
      map.outcomes.size(), Value(100 * foreseen, 3),
      std::ceil(std::log(1 / 1.2) / std::log(laws::left_by_a_sweep(links))), links);
  page.text(
      R"(**Which knob?** Less β, at once. More sweeps, slowly. A cold start takes the memory away, and with it what
      a warm start is for: it sags. Better to keep corrections out of λ: positions put right by themselves (split
      impulse, projection), or soft constraints with a relax pass. And solved directly, q = 0: the limit is 2
      again.)");

  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.93,
              .source = "law B6",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = links <= 12 && setting.resolution >= 10,
              .range = "at most 12 links, 10 cells a side or more"});
  const bool in_reach = limit >= 0.02 && limit <= 1.9 && links <= 20;
  page.claim({.quantity = say("β from which @ links ring, by bisection", links),
              .unit = "1",
              .expected = limit,
              .source = "law B6: (1 − q)/q",
              .measured = here,
              .tolerance = relative(0.02),
              .claimed = in_reach,
              .range = "0.02 ≤ (1 − q)/q ≤ 1.9, at most 20 links"});
  page.claim({.quantity = "largest error at the end, by split impulse",
              .unit = "m",
              .expected = 1e-3,
              .source = "law B6: no correction in λ",
              .measured = chains.last(2),
              .tolerance = at_most(),
              .claimed = beta >= 0.1 && links <= 12 && sweeps >= 4,
              .range = "β ≥ 0.1, at most 12 links, 4 sweeps or more"});
}

}  // namespace byhand::failures
