// Deeper: the limit that is not 2.

#include <optional>

#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/04_baumgarte/warm_chain.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::baumgarte {
namespace {

constexpr double chain_seconds = 4, least_shown = 1e-5;  // [s], of |C|/L [1]

/// Decades that errors grow by in a hundred steps.
double decades(double growth) { return 100 * std::log10(std::max(growth, 1e-30)); }

HeatMap growth_map(int links, double h) {
  constexpr double far = 4;  // decades: what is farther has the colour of the end
  HeatMap grows{.label = "growth in 100 steps (decades)", .diverging = true, .range = {{-far, far}}};
  grows.x = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
  for (int i = 0; i < 24; ++i) grows.y.push_back(0.01 * std::pow(250, i / 23.0));
  for (const double beta : grows.y)
    for (const double sweeps : grows.x) {
      const double growth = measured_growth({links, static_cast<int>(sweeps), beta}, h, 300);
      grows.values.push_back(std::clamp(decades(growth), -far, far));
    }
  return grows;
}

/// The last such map, as long as it is the same: while a reader moves β or the number of sweeps, nobody waits for
/// it.
const HeatMap& remembered_map(int links, double h) {
  struct Map {
    int links;
    double h;
    HeatMap grows;
  };
  static std::optional<Map> last;
  if (!last || last->links != links || last->h != h) last = Map{links, h, growth_map(links, h)};
  return last->grows;
}

Chart map(const Setting& setting, int links) {
  const HeatMap& grows = remembered_map(links, setting.h);
  Curve law{.label = "β = (1 − q)/q, and 2", .style = CurveStyle::theory};
  for (int i = 0; i <= 60; ++i) {
    const double sweeps = std::pow(64, i / 60.0);
    const double limit = laws::largest_beta(laws::left_by_sweeps(links, sweeps));
    if (limit < grows.y.front()) continue;
    law.x.push_back(sweeps);
    law.y.push_back(limit);
  }
  std::vector<Tick> ticks;
  for (const double sweeps : {1, 2, 4, 8, 16, 32, 64}) ticks.push_back({sweeps, say("@", sweeps)});
  Chart chart{.x = {.label = "warm sweeps a step", .scale = Scale::logarithmic, .ticks = ticks},
              .y = {.label = "β", .scale = Scale::logarithmic},
              .heat_map = grows};
  if (!law.x.empty()) chart.curves.push_back(law);
  return chart;
}

/// Where measured growth crosses 1.
double measured_limit(const Setting& setting, double law) {
  double settles = 0.5 * law, grows = 1.5 * law;
  for (int i = 0; i < 9; ++i) {
    const double middle = (settles + grows) / 2;
    (measured_growth({setting.links, setting.sweeps, middle}, setting.h, 2000) < 1 ? settles : grows) = middle;
  }
  return (settles + grows) / 2;
}

std::string largest_error_of(const HangingChain& chain, double length) {
  const double error = chain.largest_error() / length;
  if (chain.broken_up()) return "broken up";
  return error < least_shown ? "|C| below 10⁻⁵ L" : say("|C| up to @ L", Value(error, 2));
}

/// A cold chain and a warm one, in the colours of lesson 3, step 6.
struct ChainsFilm {
  HangingChain cold, warm;
  double length, view;  // [m]
  Chart beside;
  int bobs;

  void draw(Canvas& canvas, double time, double h) {
    while (warm.time() < time - 0.5 * h) {
      warm.step();
      cold.step();
    }
    const auto [left, right] = canvas.page().inset(16).panels(0.36, 16);
    const auto frames = left.cells(1, 2, 8);
    const std::pair<const HangingChain*, const char*> both[] = {{&cold, "cold"}, {&warm, "warm"}};
    for (int i = 0; i < 2; ++i) {
      const auto& [chain, name] = both[i];
      const Rectangle below{frames[i].x, frames[i].y + 30, frames[i].width, frames[i].height - 70};
      canvas.text({frames[i].centre().x(), frames[i].top() - 16}, name,
                  {.size = 24, .colour = palette::series(i), .bold = true});
      canvas.look(fit({-0.1 * view, -view, 0.2 * view, 1.06 * view}, below, 6));
      const double spacing = length * canvas.camera().scale;
      if (chain->largest_error() < length) {
        canvas.clip(below);
        pictures::draw(canvas, chain->linkage(),
                       {.bob = std::min(13.0, 0.3 * spacing),
                        .rod = std::min(5.0, 0.15 * spacing),
                        .bodies = pictures::look_of_run(i)});
        canvas.clip({});
        canvas.look_at_page();
      } else {
        canvas.look_at_page();
        canvas.text(below.centre(), "beyond\nthe picture", {.size = 20});
      }

      canvas.text({frames[i].centre().x(), frames[i].y + 12}, largest_error_of(*chain, length),
                  {.size = 18, .colour = palette::error});
    }
    renderer::draw(canvas, pictures::grown_to(beside, time), right.lowered(40));
  }
};

ChainsFilm film_of(const Setting& setting, double beta) {
  const double h = setting.h(), length = setting.length;
  const auto hanging = [&](bool warm) {
    return HangingChain({setting.links, setting.sweeps, beta, warm}, length, setting.mass, h);
  };
  ChainsFilm film{hanging(false), hanging(true), length, 0, {}, setting.links};
  double watched = 0;  // until the last chain has broken up [s]
  film.beside = {.x = {.label = "time (s)"}, .y = {.label = "largest |C|/L", .scale = Scale::logarithmic}};
  double depth = setting.links * length, most = 0.1, least = 1e-3;
  for (const auto& [start, name] : {std::pair{&film.cold, "cold"}, std::pair{&film.warm, "warm"}}) {
    HangingChain chain = *start;
    Curve curve{.label = name, .x = {0}, .y = {HangingChain::start_error}};
    while (chain.time() < chain_seconds) {
      chain.step();
      if (chain.broken_up()) break;
      curve.x.push_back(chain.time());
      const double error = chain.largest_error() / length;
      curve.y.push_back(error > least_shown ? error : NAN);
      most = std::max(most, error);
      if (error > least_shown) least = std::min(least, error);
    }
    watched = std::max(watched, std::min(chain.time() + 0.1, chain_seconds));
    const double lowest = -chain.linkage().bobs.back().at.y();
    if (start == &film.cold && lowest < 2 * depth) depth = std::max(depth, lowest);
    film.beside.curves.push_back(curve);
  }
  film.beside.x.range = {{0, watched}};
  film.beside.y.range = {0.5 * least, 2 * most};
  film.view = 1.08 * depth;
  return film;
}

/// Growth in a step of the slowest wave, of which a step's sweeps leave the share q, as a plain loop: error e, its
/// rate V and the remembered λ, in units in which A = 1 and h = 1.
double wave_growth_by_hand(double q, double beta, int steps) {
  double e = 1e-3, V = 0, lambda = 0, log_size = 0;
  for (int i = 0; i < 2 * steps; ++i) {
    //! [plain_wave]
    const double warm = V + lambda;  // the warm start applies last step's λ
    // The sweeps leave the share q of V + βe.
    const double V_new = q * warm - (1 - q) * beta * e;
    lambda += V_new - warm;  // the sum is remembered
    V = V_new;
    e += V;
    //! [plain_wave]
    const double size = std::sqrt(e * e + V * V + lambda * lambda);
    if (i >= steps) log_size += std::log(size);
    e /= size, V /= size, lambda /= size;
  }
  return std::exp(log_size / steps);
}

/// What becomes of an error, and a space.
std::string fate_of_error(double growth) {
  if (growth == 0) return "The error is gone after a few steps. ";
  return say("Each step multiplies the error by @. ", Value(growth, 4));
}

/// The first number of sweeps whose limit exceeds β, as an item of a list.
std::string more_sweeps(int links, int sweeps, double beta) {
  const auto limit = [&](int count) { return laws::largest_beta(laws::left_by_sweeps(links, count)); };
  if (limit(sweeps) > beta) return "";
  int enough = sweeps;
  while (limit(enough) <= beta) ++enough;
  return say("\n- more sweeps: from @ on the limit is above this β;", enough);
}

}  // namespace

void the_trap(const Setting& setting, Page& page) {
  const int links = setting.links, sweeps = setting.sweeps;
  const double beta = setting.beta(), q = laws::left_by_sweeps(links, sweeps), limit = laws::largest_beta(q);
  const double growth = measured_growth({links, sweeps, beta}, setting.h, 2000),
               cold = measured_growth({links, sweeps, beta, false}, setting.h, 2000);
  const bool dies_out = growth < 1;
  const std::string shown_q = q < 1e-6 ? "less than 10⁻⁶" : say("@", Value(q, 4));

  page.text(
      R"(One row, solved exactly, settles for every β below 2. Now the chain of lesson 3: @, and @ of Gauss–Seidel in each
      step, as in an engine. β = @.)",
      several(links, "link"), several(sweeps, "warm sweep"), setting.beta);
  const std::string reason =
      dies_out   ? say("β is below the limit, @.", limit)
      : beta > 2 ? "Beyond 2 even one row overshoots by more than its error."
      : beta == 2
          ? R"(At β = 2 even one exactly solved row never settles; with the warm start the error is corrected twice and
            grows.)"
          : R"(λ starts from last step's value, which holds last step's correction as well; the error is corrected
            twice.)";
  const std::string fate = fate_of_error(growth),
                    few = beta < 2 ? say(" for @ over @", several(sweeps, "sweep"), several(links, "link")) : "";
  page.choose({.ask = say("β = @, @, @ a step. Does an error in the rods' lengths die out?", setting.beta,
                          several(links, "link"), several(sweeps, "warm sweep")),
               .options = {{"yes", dies_out ? fate + reason : say("This β is too large@.", few)},
                           {"no", dies_out ? "The sweeps are enough for this β." : fate + reason}},
               .answer = dies_out ? 0 : 1,
               .hints = {"λ starts from last step's value. What did that value contain besides the weight?",
                         "k sweeps leave q = cos²ᵏ(π/2N) of the slowest wave (lesson 3).",
                         say("Here q is @: compare β with (1 − q)/q, and with 2.", shown_q)}});
  ChainsFilm film = film_of(setting, beta);
  struct End {
    bool grows, breaks_up;
    std::string words;
  };
  const auto end_of = [&](const Curve& curve, double a_step) {
    const bool breaks_up = curve.x.empty() || curve.x.back() < chain_seconds - 1.5 * setting.h();
    if (breaks_up) return End{true, true, "grow until it breaks up"};
    if (a_step >= 1) return End{true, false, "grow"};
    const double last = curve.y.back();
    if (std::isnan(last)) return End{false, false, "fall below 10⁻⁵ L"};
    const bool settled = std::abs(last / curve.y[3 * curve.y.size() / 4] - 1) < 0.2;
    return End{false, false,
               say(last <= HangingChain::start_error ? "come down to @ L"
                   : settled                         ? "end at @ L, the sag"
                                                     : "are at @ L in the end",
                   Value(last, 2))};
  };
  const End of_cold = end_of(film.beside.curves[0], cold), of_warm = end_of(film.beside.curves[1], growth);
  const auto outcome = [&]() -> std::string {
    if (of_cold.grows && of_warm.grows)
      return std::string("the errors of both chains grow") +
             (of_cold.breaks_up && of_warm.breaks_up ? ", and both break up"
              : of_cold.breaks_up                    ? ", and the cold chain breaks up"
              : of_warm.breaks_up                    ? ", and the warm chain breaks up"
                                                     : "");
    if (of_cold.words == of_warm.words) return "the errors of both chains " + of_warm.words;
    return say("the warm chain's errors @; those of the cold chain @", of_warm.words, of_cold.words);
  };
  page.sequence(
      "warm_and_cold",
      say(R"(The same chain of @ m with β = @ and @ a step, with warm and with cold start; its lowest rod begins
          @ % too long. Within @ s @.)",
          links * setting.length, setting.beta, several(sweeps, "sweep"), 100 * HangingChain::start_error,
          chain_seconds, outcome()),
      Seconds{film.beside.x.range->second},
      [film, h = setting.h()](Canvas& canvas, double time) mutable { film.draw(canvas, time, h); });
  page.text(
      R"(Follow the slowest wave along the chain. k sweeps leave the share q = cos²ᵏ(π/2N) of it, here @. A warm step begins
      with all of last step's λ, including last step's correction; the sweeps remove only the share 1 − q of that
      surplus. As a program, with e for the wave of C, V for its rate, and h and A = JM⁻¹Jᵀ (lesson 3) as units:)",
      shown_q);
  page.excerpt("lessons/04_baumgarte/the_trap.cpp", "plain_wave");
  page.text("A step multiplies the wave by a root z of the cubic");
  page.formula("z³ − [1 + 2q − (1 − q)β] z² + 3q z − q = 0",
               R"(z^3 - [1 + 2q - (1-q)\beta]\,z^2 + 3q\,z - q = 0)");
  page.derivation(
      "Where the cubic and its limit come from",
      {{"the sweeps leave q of the residual JV + (β/h)e, counted after the warm start",
        "V′ + (β/h)e = q (V + λ + (β/h)e)", R"(V' + \tfrac{\beta}{h}e = q\,(V + \lambda + \tfrac{\beta}{h}e))"},
       {"λ is what the last step changed, V₋ the rate before it (gravity and the λ that carries it cancel)",
        "λ = V − V₋", R"(\lambda = V - V_-)"},
       {"positions move with the new rate", "e′ = e + hV′", R"(e' = e + hV')"},
       {"growth by z in a step: V′ = zV, V₋ = V/z; from the line before, e = hzV/(z − 1)",
        "z = q(2 − 1/z) − (1 − q)β z/(z − 1)", R"(z = q\,(2 - \tfrac1z) - (1-q)\,\beta\,\frac{z}{z-1})"},
       {"times z(z − 1)", "z³ − [1 + 2q − (1 − q)β]z² + 3qz − q = 0",
        R"(z^3 - [1 + 2q - (1-q)\beta]\,z^2 + 3q\,z - q = 0)"},
       {"the product of all roots is q; with a pair on the unit circle, z = e^(±iφ), the third root is q",
        "sum of pairs: 1 + 2q cos φ = 3q;   sum: 2 cos φ + q = 1 + 2q − (1 − q)β",
        R"(1 + 2q\cos\varphi = 3q,\qquad 2\cos\varphi + q = 1 + 2q - (1-q)\beta)"},
       {"eliminate cos φ", "β = (1 − q)/q", R"(\beta = \frac{1-q}{q})"},
       {"waves with q = 0, which one sweep removes, behave like one row", "β < 2", R"(\beta < 2)"}});
  page.formula("all waves die out  ⟺  β < min((1 − q)/q, 2) = @",
               R"(\text{all waves die out} \iff \beta < \min\Bigl(\frac{1-q}{q},\,2\Bigr) = @)", limit);
  const Quantity share("β", beta), of_limit("limit", limit), step_growth("growth in a step", growth);
  page.text(
      R"(@ With few sweeps or many links the limit becomes very small, and the solver gives no error message: beyond the
      limit the chain just oscillates more and more.)",
      page.verdict(
          {{.when = step_growth < 1, .say = "β is below the limit: errors die out.", .law = share < of_limit},
           {.when = step_growth > 1, .say = "β is above the limit: errors grow.", .law = share > of_limit}}));
  page.figure(
      "beta_and_sweeps",
      say(R"(By how many decades errors along @ grow (red) or die out (blue) in a hundred steps. Dashed: the
                  law.)",
          several(links, "link")),
      map(setting, links));
  if (beta >= 2)
    page.text("Only a smaller β helps here: from 2 on not even one exactly solved row settles.");
  else
    page.text(
        R"(Where β is above the limit, these help:
@
        - a smaller β;
        - a cold start: small errors die out for every β below 2, but the chain sags;
        - a direct solve of the chain: then q = 0, and the limit is 2;
        - a correction that is kept out of the stored λ: split impulse (lesson 5), soft constraints (lesson 6).)",
        more_sweeps(links, sweeps, beta));
  page.measure("growth of an error in a step", growth, "1");

  // The waves that a sweep in chain order removes at once are coupled; in a long chain rounding feeds them.
  const Quantity length("links", links);
  const Condition pure = either(share <= 1.5, both(share <= 2, length <= 12));
  page.claim("growth in a step, warm", growth, "1",
             is(growth_law({links, sweeps, beta}), "largest root z over all waves", absolute(1e-3)), pure);
  page.claim("growth in a step, cold", cold, "1",
             is(growth_law({links, sweeps, beta, false}), "z² − [1 + q − (1 − q)β]z + q = 0", absolute(1e-3)),
             pure);
  const Condition in_reach = both(within(0.02, Quantity("(1 − q)/q", limit), 1.9), length <= 20);
  page.claim("β at which an error neither grows nor dies out", in_reach ? measured_limit(setting, limit) : 0, "1",
             is(limit, "(1 − q)/q", relative(0.02)), in_reach);
  page.claim("growth of the slowest wave, by the program above", wave_growth_by_hand(q, beta, 4000), "1",
             is(growth_of_wave(q, beta), "largest root of the cubic", absolute(2e-3)));
}

}  // namespace byhand::baumgarte
