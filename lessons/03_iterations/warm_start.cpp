// Step 6: what a warm start buys.

#include <algorithm>
#include <cmath>

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/textbook.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "renderer/canvas.hpp"
#include "solver/step.hpp"

namespace byhand::iterations {
namespace {

using namespace tutor;
namespace palette = renderer::palette;
using Chain = Simulation<PlaneParticle>;

/// The hanging chain without a cure for drift, so that only (17) and (20) are at work.
Chain hanging(const Knobs& knobs, bool warm) {
  return {
      rod_chain<PlaneParticle>(knobs.chain()),
      VelocityStepping{.solver = GaussSeidel{.sweeps = knobs.sweeps, .warm_start = warm}, .drift = NoDriftCure{}}};
}

/// How fast each link of a vertical chain is getting longer [m/s].
std::vector<double> stretching(const Chain& chain) {
  std::vector<double> rates;
  for (int bob = 1; bob < chain.scene.bodies().size(); ++bob)
    rates.push_back(chain.scene.bodies().velocity[bob - 1].y() - chain.scene.bodies().velocity[bob].y());
  return rates;
}

double largest(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// Largest error [gh] over time, from the first step on.
renderer::Curve error_over_time(std::string label, Chain chain, const Knobs& knobs, double seconds) {
  renderer::Curve curve{.label = std::move(label)};
  while (chain.time < seconds) {
    chain.step(knobs.h);
    curve.x.push_back(chain.time);
    curve.y.push_back(largest(stretching(chain)) / knobs.fall());
    if (curve.y.back() < 1e-14) curve.y.back() = NAN;
  }
  return curve;
}

/// What k sweeps leave of the slow wave, q, as a warm chain shows it: its errors obey rₙ₊₁ = q(2rₙ - rₙ₋₁), so
/// rₙ² - rₙ₊₁rₙ₋₁ is multiplied by q in every step. Taken between errors of about 1e-2 and 1e-5, when faster waves
/// have gone.
double measured_q(const Knobs& knobs, double q) {
  const int begin = static_cast<int>(std::ceil(std::log(1e-2) / std::log(std::sqrt(q)))), span = 2 * begin;
  Chain chain = hanging(knobs, true);
  std::vector<double> top{0};
  for (int i = 0; i <= begin + span; ++i) {
    chain.step(knobs.h);
    top.push_back(stretching(chain).front());
  }
  const auto invariant = [&](int n) { return top[n] * top[n] - top[n + 1] * top[n - 1]; };
  return std::pow(invariant(begin + span) / invariant(begin), 1.0 / span);
}

/// The cold chain once its errors have settled.
Chain settled_cold(const Knobs& knobs, double q) {
  Chain chain = hanging(knobs, false);
  const int steps = 10 + static_cast<int>(std::log(1e-10) / std::log(q));
  for (int i = 0; i < steps; ++i) chain.step(knobs.h);
  return chain;
}

void draw_chains(renderer::Canvas& canvas, const Chain& cold, const Chain& warm, double depth, double pitch,
                 const renderer::Rectangle& frame) {
  const auto panels = frame.cells(1, 2, 8);
  const std::pair<const Chain*, const char*> both[] = {{&cold, "cold"}, {&warm, "warm"}};
  for (int i = 0; i < 2; ++i) {
    const auto& [chain, name] = both[i];
    const renderer::Rectangle below{panels[i].x, panels[i].y, panels[i].width, panels[i].height - 40};
    canvas.look_at_page();
    canvas.text({panels[i].centre().x(), panels[i].top() - 16}, name,
                {.size = 24, .colour = palette::series(i), .bold = true});
    const renderer::Camera camera = renderer::fit({-0.1 * depth, -depth, 0.2 * depth, depth + pitch}, below, 6);
    canvas.look(camera);
    canvas.clip(below);
    const double spacing = pitch * camera.scale;
    pictures::draw(canvas, pictures::rods_and_bobs(chain->scene),
                   {.bob = std::min(13.0, 0.3 * spacing), .rod = std::min(5.0, 0.15 * spacing)});
    canvas.clip({});
  }
  canvas.look_at_page();
}

}  // namespace

void warm_start(Page& page, const Knobs& knobs) {
  const int k = knobs.sweeps, n = knobs.links;
  const double q = std::pow(chain_factor(n), k), fall = knobs.fall(), seconds = 3;
  const bool visible = q >= 0.01;
  // λ is kept per metre of a rod that meanwhile changes its length; what that does to √q is of second order in
  // this.
  const double slack = n * Knobs::gravity * knobs.h * knobs.h / knobs.length;
  const std::string range = "q ≥ 0.01";

  page.text(
      R"(A simulation does not take the sweeps it needs: it takes @ a step and moves on. What k = @ sweeps leave of
      the slow wave is q = ρᵏ = @. Let the chain hang like that for some seconds, without any correction of
      positions, once *cold* (each step begins at λ = 0) and once *warm* (each begins with the λ of the last).)",
      k, k, q);

  const Chain settled = settled_cold(knobs, visible ? q : 0.01);
  const double rate = largest(stretching(settled));
  // λ belongs to the rod's length before the poses moved on.
  const auto& bodies = settled.scene.bodies();
  const double held = knobs.h * bodies.velocity[1].y() - bodies.pose[1].position.y();
  const double carried = settled.work.system.lambda.front() * -held / knobs.h;
  page.text(
      R"(**Cold, it never gets there.** Every step finds the same missing share again, and whatever is left of it
      stays in V and is added to the next. It settles where links part at a steady speed: the worst of them at @
      m/s. The joints do carry the weight by then (@ N of @ N at the top), but only because the chain is coming
      apart: its stretching speed is what makes the rows pull.)",
      rate, carried, knobs.weight());
  page.text(
      R"(**Warm, it arrives.** What this step could not finish is where the next one starts. For the slow wave,
      with rₙ the error that step n leaves:)");
  page.formula("rₙ₊₁ = q (2rₙ − rₙ₋₁),   so |rₙ| falls by √q = @ a step",
               R"(r_{n+1} = q\,(2r_n - r_{n-1}), \qquad |r_n| \sim \sqrt{q}^{\,n}, \quad \sqrt q = @)",
               std::sqrt(q));
  page.text(
      R"((The step adds to V what it failed to remove, and its λ is off by as much again: hence 2rₙ − rₙ₋₁.) Each
      warm sweep is worth half a cold one, but they add up over steps and cold ones do not.)");

  const Chain cold = hanging(knobs, false), warm = hanging(knobs, true);
  renderer::Chart chart;
  chart.x.label = "time (s)";
  chart.y = {.label = "largest error (gh)", .scale = renderer::Scale::logarithmic, .range = {{1e-6, 30}}};
  chart.curves = {error_over_time("cold", cold, knobs, seconds), error_over_time("warm", warm, knobs, seconds)};
  renderer::Curve law{.label = "√q a step", .style = renderer::CurveStyle::theory};
  for (double t = 0; t < seconds; t += knobs.h) {
    const double value = std::pow(q, 0.5 * t / knobs.h);
    if (value < 1e-6) break;
    law.x.push_back(t);
    law.y.push_back(value);
  }
  if (law.x.size() > 1) chart.curves.push_back(law);
  const double worst = *std::max_element(chart.curves[0].y.begin(), chart.curves[0].y.end());
  chart.y.range->second = std::max(3.0, 2 * worst);

  Chain last = cold;
  while (last.time < seconds) last.step(knobs.h);
  const double pitch = knobs.length, depth = 0.6 * pitch - last.scene.bodies().pose.back().position.y();
  page.sequence(
      "cold_and_warm",
      say(R"(The same chain with @ sweeps a step, cold and warm, without any correction of positions; both began at
          @ m. Right: the largest error over time, dashed the law √qⁿ.)",
          k, n * knobs.length()),
      Seconds{seconds}, [=, cold = cold, warm = warm](renderer::Canvas& canvas, double time) mutable {
        while (cold.time < time - 0.5 * knobs.h) {
          cold.step(knobs.h);
          warm.step(knobs.h);
        }
        const auto [left, right] = canvas.page().inset(16).split_columns(0.36, 16);
        draw_chains(canvas, cold, warm, depth, pitch, left);
        draw(canvas, pictures::grown_to(chart, time), right.inset(0, 40));
      });
  if (visible) {
    const double arrived = std::pow(q, 0.5 / knobs.h);
    page.text(
        R"(After one second of warm steps the slow wave is down to about @ of where it began. One cold step would
        need about @ sweeps for that, in every step anew.)",
        Value(arrived, 2), Value(std::max(1.0, std::log(arrived) / std::log(chain_factor(n))), 3));
  }
  const auto limit = [](double left) { return (1 - left) / left; };
  page.text(
      R"(**And it has a price.** Look at the warm curve: it does not just fall, it *rings*, for the roots of that
      rule are complex. λ remembers. As soon as positions are corrected as well, it remembers the correction too
      and pays it twice: then the ringing grows unless β < (1 − q)/q, which is @ here and @ for one sweep a step.
      Lesson 4 shows what that looks like.)",
      Value(limit(q), 3), Value(limit(chain_factor(n)), 3));

  page.measure("largest error of the cold chain", rate / fall, "gh");
  page.claim({.quantity = "warm: what a step leaves of the slow wave",
              .unit = "1",
              .expected = std::sqrt(q),
              .source = "√q, q = cos²ᵏ(π/2N) (law B6 at β = 0)",
              .measured = visible ? std::sqrt(measured_q(knobs, q)) : std::sqrt(q),
              .tolerance = relative(1e-5 + slack * slack),
              .claimed = visible && slack < 0.1,
              .range = range + ", N g h² < L/10"});
  page.claim({.quantity = "cold: the worst link's speed of parting",
              .unit = "m/s",
              .expected = textbook_cold_errors(knobs.chain(), k, fall).cwiseAbs().maxCoeff(),
              .source = "(1 − Gᵏ)⁻¹Gᵏ of the sweep's matrix G",
              .measured = rate,
              .tolerance = relative(1e-6),
              .claimed = visible,
              .range = range});
  page.claim({.quantity = "cold: force at the top joint all the same",
              .unit = "N",
              .expected = knobs.weight(),
              .source = "nothing speeds up any more",
              .measured = carried,
              .tolerance = relative(1e-6)});
}

}  // namespace byhand::iterations
