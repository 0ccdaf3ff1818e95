// Step 2: the correction overshoots.

#include "lessons/08_where_methods_fail/film.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/warm_start.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;

double limit_of_beta(int links, double sweeps) { return laws::largest_beta(laws::left_by_sweeps(links, sweeps)); }

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
       .failure = "breaks",
       .success = "holds",
       .draw =
           [](renderer::Canvas& canvas, const Scene<PlaneParticle>& chain, const renderer::Look& look) {
             pictures::draw(canvas, pictures::rods_and_bobs(chain), {.bob = 7, .rod = 4, .bodies = look});
           }});
}

/// How a run of the film ends: "breaks after 1.2 s", or "is 0.013 m off at the end".
std::string end_of(const Film<PlaneParticle>& chains, int take) {
  if (chains.failed(take)) return chains.fate(take);
  const double off = chains.last(take);
  return off < 1e-11 ? "is off by rounding alone" : say("is @ m off at the end", Value(off, 2));
}

}  // namespace

void overshoots(const Setting& setting, Page& page) {
  const int links = setting.links, sweeps = setting.sweeps;
  const double beta = setting.beta, slowest = laws::left_by_a_sweep(links), q = std::pow(slowest, sweeps),
               limit = limit_of_beta(links, sweeps);

  page.text(
      R"(**Symptom of the second family:** an error changes sign again and again, each swing larger than the last. *It
      rings.* The rows are solved as well as before, but the correction is too strong for rows solved only that well.)");
  page.text(
      R"(One row solved exactly is stable for every β below 2 (lesson 4). A chain of @ links, solved by @ a step from a
      warm start, is another matter. Each step begins with all of the last step's λ, which contains the last step's
      correction. The sweeps should remove it again, but they leave a share q = cos²ᵏ(π/2N) = @ of the slowest wave, and
      that share is applied again.)",
      links, several(sweeps, "sweep"), Value(q, 3));
  const double here = beta_that_rings(links, sweeps), twice = beta_that_rings(2 * links, sweeps);
  if (limit_of_beta(2 * links, sweeps) < 1.9)
    page.predict(
        {.ask = say(
             R"(With @ links and @ a step from a warm start, errors ring once β exceeds @. What is this limit with
             @ links and the same number of sweeps?)",
             links, several(sweeps, "sweep"), Value(here, 3), 2 * links),
         .answer = twice,
         .unit = "1",
         .tolerance = 0.15 * twice,
         .wrong =
             {{here / 2,
               R"(An error spreads like a random walk: twice the distance takes four times as long, not twice.)"},
              {here, "The number of sweeps is the same, but they leave more of a wave twice as long."}},
         .hints = {"How much of a wave twice as long do the same sweeps leave?",
                   "The limit is (1 − q)/q, with q = cos²ᵏ(π/2N).", say("q = cos(π/@)^@", 4 * links, 2 * sweeps)},
         .hinted = limit_of_beta(2 * links, sweeps),
         .right = say("(1 − q)/q is @ for @ links and @ for @; for long chains it falls as 1/N².",
                      Value((1 - q) / q, 3), links, Value(limit_of_beta(2 * links, sweeps), 3), 2 * links)});

  const Film<PlaneParticle> chains = film(links, sweeps, beta);
  page.sequence(
      "ringing_chain",
      say(R"(Three chains of @ links released at rest, β = @, @ a step. With a warm start the chain @; with a cold
                    start it @; with split impulse, which corrects positions and leaves nothing in λ, it @.)",
          links, setting.beta, several(sweeps, "sweep"), end_of(chains, 0), end_of(chains, 1), end_of(chains, 2)),
      Seconds{chains.seconds()}, chains.drawing());
  const Quantity chosen("β", beta), largest("limit of the warm chain", limit);
  int digits = 3;
  while (digits < 12 && course::number(limit, digits) == course::number(beta, digits)) ++digits;
  const Value told(limit, digits);
  page.text(page.verdict(
      {{.when = chosen > largest,
        .say = say("β = @ is above the warm chain's limit of @, so its error grows.", setting.beta, told)},
       {.when = both(chosen <= largest, largest < 1),
        .say = say(
            "β = @ is below the warm chain's limit of @, so its error dies out. Choose a larger β to see it ring.",
            setting.beta, told)},
       {.when = both(chosen <= largest, largest >= 1),
        .say = say("β = @ is below the warm chain's limit of @, so its error dies out. Choose fewer sweeps to see "
                   "it ring.",
                   setting.beta, told)}}));
  page.text(
      R"(Write C for the error of the slowest wave and v for its rate. One warm step acts on them linearly: it
      multiplies them by a root z of)");
  page.formula(
      "z³ − [1 + 2q − (1 − q)β] z² + 3q z − q = 0:   the chain settles for β < min(2, (1 − q)/q) = @",
      R"(z^3 - [1 + 2q - (1-q)\beta]\,z^2 + 3q\,z - q = 0: \qquad \beta < \min\left(2, \frac{1-q}{q}\right) = @)",
      Value(limit, 3));
  page.derivation(
      "Why β < min(2, (1 − q)/q)",
      {{"the exact λ* would give the slow wave the rate that Baumgarte asks for", "vₙ₋₁ + αλ* = −βCₙ/h",
        R"(v_{n-1} + \alpha\lambda^* = -\beta C_n/h)"},
       {"from the last λ, k sweeps leave the share q of what is missing", "λₙ = λ* + q(λₙ₋₁ − λ*)",
        R"(\lambda_n = \lambda^* + q(\lambda_{n-1} - \lambda^*))"},
       {"this step changes v by αλₙ, the last one changed it by αλₙ₋₁",
        "vₙ = 2q vₙ₋₁ − q vₙ₋₂ − (1 − q) β Cₙ/h,   Cₙ₊₁ = Cₙ + h vₙ",
        R"(v_n = 2q\,v_{n-1} - q\,v_{n-2} - (1-q)\,\beta\,C_n/h, \quad C_{n+1} = C_n + h\,v_n)"},
       {"insert zⁿ for both", "(z² − 2qz + q)(z − 1) + (1 − q)β z² = 0",
        R"((z^2 - 2qz + q)(z - 1) + (1-q)\beta\,z^2 = 0)"},
       {"multiplied out", "z³ − [1 + 2q − (1 − q)β] z² + 3q z − q = 0",
        R"(z^3 - [1 + 2q - (1-q)\beta]\,z^2 + 3q\,z - q = 0)"},
       {"at β = (1 − q)/q one root is q; the product of all three is q, so the other two have the product 1",
        "|z| = 1 for q > 1/5, where these two are complex", R"(|z| = 1 \text{ for } q > 1/5)"},
       {"the fast waves have q = 0", "z = 1 − β   ⟹   β < 2, the smaller limit for q < 1/3",
        R"(z = 1 - \beta \;\Rightarrow\; \beta < 2, \text{ the smaller limit for } q < 1/3)"}});

  const Map map = map_of(
      page, counting_knob("warm sweeps a step", 1, 64, setting.resolution),
      knob("β", 0.01, 2.5, setting.resolution), [links](double k, double b) {
        return laws::run(laws::WarmChain{.links = links, .sweeps = static_cast<int>(k), .beta = b, .steps = 1500});
      });
  page.figure("beta_and_sweeps",
              say("Each cell is one run of a chain of @ links. Dashed: β = (1 − q)/q, and 2.", links),
              chart(map, "β = (1 − q)/q, and 2", [links](double k) { return limit_of_beta(links, k); }));
  const Agreement agreed = agreement(
      map, [links](double k) { return limit_of_beta(links, k); }, Settles::below);
  const double needed = std::log(1 / 1.2) / std::log(slowest);  // sweeps at which the limit is 0.2
  page.text(
      R"(@ The article takes β from 0.1 to 0.3: with @ links, β = 0.2 needs at
      least @ a step.)",
      agreed.sentence(), links, several(std::lround(std::ceil(needed)), "sweep"));
  page.text(
      R"(**Which knob?** A smaller β helps at once, more sweeps help slowly. A cold start removes the memory, and with
      it the point of a warm start. It is better to keep corrections out of λ: correct positions separately (split
      impulse, projection) or relax soft constraints (lesson 6). For a direct solve q = 0, so its limit is 2.)");
  page.text(
      R"(From the casebook: a warm start that goes unstable, `./lessons/run case 8`; a correction that feeds energy,
      `./lessons/run case 9`.)");

  claim_agreement(page, agreed, 0.15, "law of warm starts with Baumgarte", setting.resolution);
  page.claim(say("β from which @ links ring, by bisection", links), here, "1",
             is(limit, "law of warm starts: (1 − q)/q", relative(0.02)),
             where(within(0.02, Quantity("(1 − q)/q", limit), 1.9), Quantity("links", links) <= 20));
  for (const double share : {0.85, 1.15}) {
    const int tried = static_cast<int>(share < 1 ? share * needed : std::ceil(share * needed));
    page.claim(
        say("β = 0.2 with @ a step: whether it settles", several(tried, "sweep")),
        tried > 0 && laws::run(laws::WarmChain{.links = links, .sweeps = tried}) == Outcome::settles ? 1.0 : 0.0,
        "1", is(share < 1 ? 0.0 : 1.0, "law of warm starts", absolute(0)), Quantity("sweeps", tried) >= 1);
  }
  page.claim("largest error at the end, by split impulse", chains.last(2), "m",
             is_at_most(1e-3, "law of warm starts: no correction in λ"),
             where(Quantity("β", beta) >= 0.1, Quantity("links", links) <= 12, Quantity("sweeps", sweeps) >= 4));
}

}  // namespace byhand::failures
