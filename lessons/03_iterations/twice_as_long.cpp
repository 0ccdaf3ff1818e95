// Step 5: sweeps against the length of the chain.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::iterations {
namespace {

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
    measured.point_labels.push_back(course::number(measured.y.back(), 3));
    law.x.push_back(links);
    law.y.push_back(coefficient * links * links);
  }
  renderer::Chart chart;
  chart.x = {.label = "links N", .scale = renderer::Scale::logarithmic, .range = {{2, 120}}};
  chart.y = {.label = "sweeps for one more digit", .scale = renderer::Scale::logarithmic, .range = {{3, 2e4}}};
  chart.curves = {measured, law};
  return chart;
}

}  // namespace

void twice_as_long(Page& page, const Knobs& knobs) {
  const double h = knobs.h;
  const double once = measured_digit(knobs.chain(), h), twice = measured_digit(knobs.chain(2 * knobs.links), h);
  page.predict(
      {.ask = say("One more digit takes @ sweeps with @ links. How many with @ links?", Value(once, 3),
                  knobs.links, 2 * knobs.links),
       .answer = twice,
       .unit = "sweeps",
       .tolerance = 0.12 * twice,
       .wrong = {{2 * once,
                  "Errors do not travel in one direction: each row sends half up and half down, so they wander."},
                 {once,
                  "Each sweep does touch every row once, but a row passes an error on only to its neighbours."}},
       .hints = {"A row passes its error on to the joints above and below. How far does it get in n sweeps?",
                 "A random walk gets about √n joints far in n steps.",
                 "To get twice as far, √n must double: n grows by a factor of 4."},
       .hinted = 4 * once,
       .right = say(R"(@ times as many: errors spread like a random walk
                    (exactly 4 times only for long chains).)",
                    Value(twice / once, 3))});
  page.text(
      R"(Take Jacobi, the simplest. Let eᵢ be the error of joint i's λ. Solving row i by (17) makes λᵢ right *for what its
      neighbours do now*, so afterwards its error is the mean of theirs:)");
  page.formula("eᵢ ← ½ (eᵢ₋₁ + eᵢ₊₁)", R"(e_i \leftarrow \tfrac{1}{2}\,(e_{i-1} + e_{i+1}))");
  page.text(
      R"(This is a random walk: in each sweep half of every bit of error moves up one joint and half moves down. At the
      anchor it turns back, at the free end it disappears. After n steps a random walk is about √n from where it began,
      so crossing N joints takes about N² sweeps.)");

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
      "random_walk",
      say(R"(One joint in the middle of @ was wrong: the error after some sweeps of Jacobi (each row applies @ of its
          correction; otherwise the error would sit on odd and on even joints alternately). Four times the sweeps,
          twice the standard deviation: @, @, @ joints.)",
          joints, half, Value(widths[0], 3), Value(widths[1], 3), Value(widths[2], 3)),
      walk);
  page.text(
      R"(The last error to disappear is the smoothest one, a quarter of a wave from anchor to free end: the *slow wave*. Jacobi
      multiplies it by cos(π/2N). Gauss–Seidel uses each new value at once and does two of Jacobi's sweeps
      in one: cos²(π/2N), in any order of the rows.)");
  page.derivation(
      "The rate cos(π/2N)",
      {{"try a wave, with the anchor's mirror image e₀ = e₂", "eᵢ = cos((i − 1)θ)",
        R"(e_i = \cos((i - 1)\theta))"},
       {"the mean of its neighbours", "½(cos((i − 2)θ) + cos(iθ)) = cos θ · cos((i − 1)θ)",
        R"(\tfrac12(\cos((i-2)\theta) + \cos(i\theta)) = \cos\theta\,\cos((i-1)\theta))"},
       {"nothing is missing beyond the free end: e of joint N + 1 is 0", "cos(Nθ) = 0, θ = π/2N",
        R"(\cos(N\theta) = 0, \quad \theta = \frac{\pi}{2N})"},
       {"so each sweep multiplies this error by", "cos θ = cos(π/2N)", R"(\cos\theta = \cos\frac{\pi}{2N})"},
       {"for large N, ln cos²(π/2N) ≈ −π²/4N²", "one digit takes about 4 ln 10/π² · N² = 0.933 N² sweeps",
        R"(\frac{4\ln 10}{\pi^2} N^2 = 0.933\,N^2)"}});
  page.figure(
      "digits_over_links",
      "Sweeps for one more digit against the number of links, both logarithmic: a slope of 2 for long chains.",
      digits_over_links(knobs));
  page.claim(say("ratio of sweeps per digit, @ links to @", 2 * knobs.links, knobs.links), twice / once, "1",
             is(std::log(laws::left_by_a_sweep(knobs.links)) / std::log(laws::left_by_a_sweep(2 * knobs.links)),
                "ρ = cos²(π/2N); 4 for long chains", relative(1e-6)));
  page.claim("width of the error after 16 sweeps of half a step", widths[1], "joints",
             is(std::sqrt(16 * half), "a walk that moves every other time: √(n/2)", relative(1e-6)));
}

}  // namespace byhand::iterations
