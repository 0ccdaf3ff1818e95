// Deeper: the limit that is not 2.

#include <algorithm>
#include <cmath>

#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/04_baumgarte/warm_chain.hpp"
#include "lessons/pictures/growing.hpp"
#include "renderer/canvas.hpp"

namespace byhand::baumgarte {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double chain_seconds = 4;

/// Decades that errors grow by in a hundred steps.
double decades(double growth) { return 100 * std::log10(std::max(growth, 1e-30)); }

Chart map(const Setting& setting, int links) {
  constexpr double far = 4;  // decades: what is farther has the colour of the end
  HeatMap grows{.label = "growth in 100 steps (decades)", .diverging = true, .range = {{-far, far}}};
  grows.x = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
  for (int i = 0; i < 24; ++i) grows.y.push_back(0.01 * std::pow(250, i / 23.0));
  for (const double beta : grows.y)
    for (const double sweeps : grows.x) {
      const double growth = measured_growth({links, static_cast<int>(sweeps), beta}, setting.h, 300);
      grows.values.push_back(std::clamp(decades(growth), -far, far));
    }
  Curve law{.label = "β = (1 − q)/q, and 2", .style = CurveStyle::theory};
  for (int i = 0; i <= 60; ++i) {
    const double sweeps = std::pow(64, i / 60.0);
    const double q = std::pow(slow_wave(links, 1), sweeps);
    const double limit = std::min(2.0, (1 - q) / q);
    if (limit < grows.y.front()) continue;
    law.x.push_back(sweeps);
    law.y.push_back(limit);
  }
  std::vector<Tick> ticks;
  for (const double sweeps : {1, 2, 4, 8, 16, 32, 64}) ticks.push_back({sweeps, say("@", sweeps)});
  Chart chart{.x = {.label = "warm sweeps a step (1)", .scale = Scale::logarithmic, .ticks = ticks},
              .y = {.label = "β (1)", .scale = Scale::logarithmic},
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

struct ChainsFilm {
  HangingChain warm, cold;
  double length, view;  // [m]
  Chart beside;
  int bobs;

  void draw(Canvas& canvas, double time, double h) {
    while (warm.time() < time - 0.5 * h) {
      warm.step();
      cold.step();
    }
    const auto [left, right] = canvas.page().inset(16).split_columns(0.36, 16);
    const auto frames = left.cells(1, 2, 8);
    const std::pair<const HangingChain*, const char*> both[] = {{&warm, "warm"}, {&cold, "cold"}};
    for (int i = 0; i < 2; ++i) {
      const auto& [chain, name] = both[i];
      const Rectangle below{frames[i].x, frames[i].y + 30, frames[i].width, frames[i].height - 70};
      canvas.text({frames[i].centre().x(), frames[i].top() - 16}, name,
                  {.size = 24, .colour = palette::series(i), .bold = true});
      canvas.look(fit({-0.1 * view, -view, 0.2 * view, 1.06 * view}, below, 6));
      const double spacing = length * canvas.camera().scale;
      canvas.clip(below);
      pictures::draw(canvas, chain->linkage(),
                     {.bob = std::min(13.0, 0.3 * spacing), .rod = std::min(5.0, 0.15 * spacing)});
      canvas.clip({});
      canvas.look_at_page();
      canvas.text({frames[i].centre().x(), frames[i].y + 12},
                  say("|C| to @ L", Value(chain->largest_error() / length, 2)),
                  {.size = 18, .colour = palette::error});
    }
    renderer::draw(canvas, pictures::grown_to(beside, time), right.inset(0, 40));
  }
};

ChainsFilm film(const Setting& setting, double beta) {
  const double h = setting.h(), length = setting.length();
  const auto hanging = [&](bool warm) {
    return HangingChain({setting.links, setting.sweeps, beta, warm}, length, setting.mass, h);
  };
  ChainsFilm film{hanging(true), hanging(false), length, 0, {}, setting.links};
  film.beside = {.x = {.label = "time (s)"}, .y = {.label = "largest |C|/L (1)", .scale = Scale::logarithmic}};
  constexpr double least = 1e-5;  // of the chart
  double depth = setting.links * length, most = 0.1;
  for (const auto& [start, name] : {std::pair{&film.warm, "warm"}, std::pair{&film.cold, "cold"}}) {
    HangingChain chain = *start;
    Curve curve{.label = name};
    while (chain.time() < chain_seconds) {
      chain.step();
      curve.x.push_back(chain.time());
      const double error = chain.largest_error() / length;
      curve.y.push_back(error > least ? error : NAN);
      most = std::max(most, error);
    }
    const double lowest = -chain.linkage().bobs.back().at.y();
    if (start == &film.cold && lowest < 2 * depth) depth = std::max(depth, lowest);
    film.beside.curves.push_back(curve);
  }
  film.beside.y.range = {least, 2 * most};
  film.view = 1.08 * depth;
  return film;
}

}  // namespace

void the_trap(const Setting& setting, Page& page) {
  const int links = setting.links, sweeps = setting.sweeps;
  const double beta = setting.beta(), q = slow_wave(links, sweeps), limit = limit_of_beta(links, sweeps);
  const double growth = measured_growth({links, sweeps, beta}, setting.h, 2000),
               cold = measured_growth({links, sweeps, beta, false}, setting.h, 2000);
  const bool dies_out = growth < 1;

  page.text(
      R"(One row, solved exactly, takes any β below 2. Now the chain of lesson 3: @ links, warm start, and @
      Gauss–Seidel sweeps a step, as an engine would do it. β = @.)",
      links, sweeps, setting.beta);
  page.choose(
      {.ask = say(R"("Usually between 0.1 and 0.3": β = @, @ links, @ warm sweeps a step. Does an error die out?)",
                  setting.beta, links, sweeps),
       .options = {{"yes", dies_out
                               ? say("Yes, it is multiplied by @ a step: β is below (1 − q)/q = @.", growth, limit)
                               : say(R"(It is multiplied by @ a step. λ remembers the correction of last step and
                                     pays it twice; see (1 − q)/q.)",
                                     growth)},
                   {"no",
                    dies_out ? say("It is multiplied by @ a step, and that is less than 1.", growth)
                             : say(R"(No, it is multiplied by @ a step: λ remembers last step's correction and pays
                                   it again, more than was due.)",
                                   growth)}},
       .answer = dies_out ? 0 : 1,
       .hints = {"λ starts from last step's, and that held a correction too."}});
  page.sequence(
      "warm_and_cold",
      say(R"(The same chain of @ m with β = @ and @ sweeps a step, warm and cold. The warm one @; the cold one @.
          What leaves the picture goes on in the chart.)",
          links * setting.length(), setting.beta, sweeps,
          dies_out ? "calms down" : "rings louder with every swing",
          cold < 1 ? "sags, and stays" : "does no better"),
      Seconds{chain_seconds}, [film = film(setting, beta), h = setting.h()](Canvas& canvas, double time) mutable {
        film.draw(canvas, time, h);
      });
  page.text(
      R"(Follow the slowest wave along the chain, of which k sweeps leave q = cos²ᵏ(π/2N) = @. A warm step begins
      with all of last step's λ, the correction that it held included; sweeps take the surplus out again, but only
      1 − q of it. From e′ = e + hV and V′ = V + the new impulse, a step multiplies the wave by a root z of)",
      q);
  page.formula(
      "z³ − [1 + 2q − (1 − q)β] z² + 3q z − q = 0,   |z| < 1 only for β < (1 − q)/q = @",
      R"(z^3 - [1 + 2q - (1-q)\beta]\,z^2 + 3q\,z - q = 0, \qquad |z| < 1 \iff \beta < \frac{1-q}{q} = @)", limit);
  page.text(
      R"(The limit is (1 − q)/q, and 2 only where that is more. Few sweeps, or many links, and it is tiny. Nobody
      tells you by an error message: the chain just sings.)");
  page.figure(
      "beta_and_sweeps",
      say(R"(By how many decades errors along @ links grow (red) or die out (blue) in a hundred steps. Dashed: the
          law.)",
          links),
      map(setting, links));
  page.text(
      R"(What helps: more sweeps (here the limit reaches @ with ten times as many), smaller β, a cold start, which
      is stable up to 2 and sags, or solving the chain directly, where q = 0 and 2 is the limit again. Later
      lessons keep the correction out of what λ remembers.)",
      Value(std::min(2.0, limit_of_beta(links, 10 * sweeps)), 3));
  page.measure("growth of an error in a step", growth, "1");

  // The waves that a sweep in chain order removes at once hang together; in a long chain rounding feeds them.
  const bool pure = beta <= 1.5 || (beta <= 2 && links <= 12);
  const std::string range = "β ≤ 1.5, or β ≤ 2 and at most 12 links";
  page.claim({.quantity = "growth in a step, warm",
              .unit = "1",
              .expected = growth_law({links, sweeps, beta}),
              .source = "largest root z over all waves",
              .measured = growth,
              .tolerance = absolute(1e-3),
              .claimed = pure,
              .range = range});
  page.claim({.quantity = "growth in a step, cold",
              .unit = "1",
              .expected = growth_law({links, sweeps, beta, false}),
              .source = "z² − [1 + q − (1 − q)β]z + q = 0",
              .measured = cold,
              .tolerance = absolute(1e-3),
              .claimed = pure,
              .range = range});
  const bool in_reach = limit >= 0.02 && limit <= 1.9 && links <= 20;
  page.claim({.quantity = "β at which an error neither grows nor dies out",
              .unit = "1",
              .expected = limit,
              .source = "law B6: (1 − q)/q",
              .measured = in_reach ? measured_limit(setting, limit) : 0,
              .tolerance = relative(0.02),
              .claimed = in_reach,
              .range = "0.02 ≤ (1 − q)/q ≤ 1.9, at most 20 links"});
}

}  // namespace byhand::baumgarte
