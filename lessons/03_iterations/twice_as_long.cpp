// Step 5: why twice as long takes four times as many.

#include <cmath>

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/textbook.hpp"

namespace byhand::iterations {
namespace {

using namespace tutor;

/// What is missing at each joint, after so many sweeps of Jacobi's, of a disturbance that began in the middle
/// joint of a chain at rest, as a share of that beginning.
std::vector<double> spread(const ChainOptions& chain, double h, int sweeps, double relaxation) {
  HeldStep direct(chain, h, Direct{});
  direct.solve();
  const std::vector<double> exact = direct.lambda();
  std::vector<double> lambda = exact;
  const double amount = exact.back();
  lambda[lambda.size() / 2] += amount;
  HeldStep step(chain, h, Jacobi{.sweeps = sweeps, .warm_start = true, .relaxation = relaxation});
  step.start_from(lambda);
  step.solve();
  std::vector<double> missing = step.lambda();
  for (std::size_t i = 0; i < missing.size(); ++i) missing[i] = (missing[i] - exact[i]) / amount;
  return missing;
}

/// Standard deviation of a distribution over joints.
double width(const std::vector<double>& share) {
  double sum = 0, first = 0, second = 0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    const auto at = static_cast<double>(i);
    sum += share[i];
    first += share[i] * at;
    second += share[i] * at * at;
  }
  return std::sqrt(second / sum - (first / sum) * (first / sum));
}

renderer::Chart digits_over_links(const Knobs& knobs) {
  renderer::Curve measured{.label = "measured", .style = renderer::CurveStyle::markers};
  renderer::Curve law{.label = {}, .style = renderer::CurveStyle::theory};
  // ln ρ = 2 ln cos(π/2N) → -π²/4N²
  const double coefficient = 4 * std::log(10.0) / (M_PI * M_PI);
  law.label = say("@ N²", Value(coefficient, 3));
  for (const int links : {3, 5, 10, 20, 40, 80}) {
    measured.x.push_back(links);
    measured.y.push_back(measured_digit(knobs.chain(links), knobs.h));
    measured.point_labels.push_back(number(measured.y.back(), 3));
    law.x.push_back(links);
    law.y.push_back(coefficient * links * links);
  }
  renderer::Chart chart;
  chart.x = {.label = "links N (1)", .scale = renderer::Scale::logarithmic, .range = {{2, 120}}};
  chart.y = {.label = "sweeps for one more digit (1)", .scale = renderer::Scale::logarithmic, .range = {{3, 2e4}}};
  chart.curves = {measured, law};
  return chart;
}

}  // namespace

void twice_as_long(Page& page, const Knobs& knobs) {
  const double h = knobs.h;
  const double once = measured_digit(knobs.chain(), h), twice = measured_digit(knobs.chain(2 * knobs.links), h);
  page.predict(
      {.ask = say("@ sweeps for one more digit with @ links. How many with @ links?", std::round(once),
                  knobs.links, 2 * knobs.links),
       .answer = twice,
       .unit = "sweeps",
       .tolerance = 0.12 * twice,
       .wrong = {{2 * once, "News walks like a drunkard: twice as far takes four times as long."},
                 {once,
                  R"(Each sweep does touch every row once, but an error that stretches over the whole
                           chain is hard to see from any one of them.)"}},
       .hints = {R"(An error spreads by halves: half to the joint above, half to the joint below. How far does
                    somebody get who tosses a coin before each step?)"},
       .right = say("@ times as many.", Value(twice / once, 3))});
  page.text(
      R"(Here is why. Take Jacobi, the simplest. Say e is what is still missing from a joint's λ. Solving its row
      by (17) makes the joint right *for what its neighbours now do*, so what is missing from it afterwards is the
      mean of what is missing from them:)");
  page.formula("eᵢ ← ½ (eᵢ₋₁ + eᵢ₊₁)", R"(e_i \leftarrow \tfrac{1}{2}\,(e_{i-1} + e_{i+1}))");
  page.text(
      R"(That is a drunkard's walk: every bit of error goes up or down one joint by the toss of a coin, and is gone
      only when it falls off the free end (at the anchor it turns back). After n steps a walker is about √n from
      where it began. To cross N joints takes about N² sweeps.)");

  constexpr int joints = 41;
  constexpr double half = 0.5;
  renderer::Chart walk;
  walk.x.label = "joint, from the top";
  walk.y.label = "error left there (share)";
  std::vector<double> widths;
  for (const int sweeps : {4, 16, 64}) {
    renderer::Curve curve{.label = say("@ sweeps", sweeps), .style = renderer::CurveStyle::line_and_markers};
    curve.y = spread(knobs.chain(joints), h, sweeps, half);
    for (int i = 1; i <= joints; ++i) curve.x.push_back(i);
    widths.push_back(width(curve.y));
    walk.curves.push_back(std::move(curve));
  }
  page.figure(
      "drunkard",
      say(R"(One joint in the middle of @ was wrong; where that error is some sweeps of Jacobi's later (each takes
          @ of its step, else odd and even joints blink by turns). Four times the sweeps, twice the width: @, @, @
          joints.)",
          joints, half, Value(widths[0], 3), Value(widths[1], 3), Value(widths[2], 3)),
      walk);
  page.text(
      R"(The last error to go is the smoothest one, a quarter of a wave from anchor to free end: put eᵢ = cos((i −
      1)θ) into the rule and it comes out multiplied by cos θ; the free end wants cos Nθ = 0, so θ = π/2N.
      Gauss–Seidel uses news as it comes in, and does two of Jacobi's sweeps in one: cos²(π/2N). No order of rows
      helps, for a wave as long as the chain looks flat from everywhere.)");
  page.figure("digits_over_links", "Sweeps for one more digit against the number of links: a slope of 2.",
              digits_over_links(knobs));
  page.claim({.quantity = say("sweeps for a digit, @ links over @", 2 * knobs.links, knobs.links),
              .unit = "1",
              .expected = std::log(chain_factor(knobs.links)) / std::log(chain_factor(2 * knobs.links)),
              .source = "law B4; 4 for long chains",
              .measured = twice / once,
              .tolerance = relative(1e-6)});
  page.claim({.quantity = "width of the error after 16 sweeps of half a step",
              .unit = "joints",
              .expected = std::sqrt(16 * half),
              .source = "a walk that moves every other time: √(n/2)",
              .measured = widths[1],
              .tolerance = relative(1e-6)});
}

}  // namespace byhand::iterations
