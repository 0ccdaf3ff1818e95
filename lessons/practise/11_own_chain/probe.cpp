#include <numbers>

#include "lessons/practise/11_own_chain/signature.hpp"
#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/judge/stage.hpp"

/// A chain whose rods are as long as they should be, each at its own angle from straight down [rad].
std::vector<Bob> hung(double length, const std::vector<double>& angles) {
  std::vector<Bob> bobs;
  Vec2 end;
  for (const double angle : angles) bobs.push_back({end += turned({0, -length}, angle), {}});
  return bobs;
}

/// From the bob before this one, or from the origin, which rests.
Bob from_above(const std::vector<Bob>& bobs, std::size_t i) {
  const Bob above = i > 0 ? bobs[i - 1] : Bob{};
  return {bobs[i].p - above.p, bobs[i].v - above.v};
}

/// How much the bobs turn about the origin: Σ p × v, the same before and after they move by p += h·v.
double turn(const std::vector<Bob>& bobs) {
  double sum = 0;
  for (const Bob& bob : bobs) sum += cross(bob.p, bob.v);
  return sum;
}

/// Seconds that a pendulum takes from θ₀ down, by the arithmetic-geometric mean.
double quarter_of_a_swing(double theta, double length, double g) {
  double a = 1, b = std::cos(theta / 2);
  for (int i = 0; i < 6; ++i) std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
  return std::numbers::pi / 2 / a * std::sqrt(length / g);
}

// Programs that are right may differ in C and in its roundings, so no answer is compared: the laws judge.
void probe(Probe& p, const Code& code) {
  const auto [simulate] = Learners::of(code);
  constexpr double exact = 1e-9;
  constexpr double plenty = 400;  // sweeps that leave nothing of five rods' errors
  const auto links = static_cast<std::size_t>(2 + (p.one_of(4) + 1) % 4);
  Setting given;
  given.length = p.number("length", "m", 0.5, 2.5);
  given.mass = p.number("mass", "kg", 0.3, 5);
  given.g = p.number("g", "m/s²", 2, 20);
  given.h = p.number("h", "s", 0.004, 0.02);
  given.beta = p.number("beta", "1", 0.05, 0.7);
  const double v0 = p.number("v0/length", "1/s", 1, 3) * given.length, theta = p.number("theta0", "rad", 0.3, 1.5);
  std::vector<double> angles(links);
  Numbers errors(links);
  for (std::size_t i = 0; i < links; ++i) angles[i] = p.number("angle" + std::to_string(i + 1), "rad", -3, 3);
  std::vector<Bob> moving = hung(given.length, angles);
  for (std::size_t i = 0; i < links; ++i) moving[i].v = p.vector("v" + std::to_string(i + 1), "m/s", 3);
  for (std::size_t i = 0; i < links; ++i)
    errors[i] = 1e-5 * given.length * p.number("error" + std::to_string(i + 1), "1e-5 length", -3, 3);

  const double L = given.length, g = given.g, h = given.h, weight = given.mass * g;
  const auto after = [&, &simulate = simulate](std::vector<Bob> bobs, double steps, double sweeps, double beta,
                                               double gravity, double step) {
    simulate({L, given.mass, gravity, step, beta, sweeps, steps}, bobs);
    return bobs;
  };

  const auto unsolved = after(moving, 1, 0, given.beta, g, h);
  p.law("a step begins with gravity: without sweeps, a bob falls by g·h", "m/s",
        unsolved.back().v.y - moving.back().v.y, -g * h, exact);
  const auto moved = after(moving, 1, 3, given.beta, g, h);
  p.law("a step ends with p += h·v, v being what the sweeps have solved", "m/s",
        (moved.back().p.y - moving.back().p.y) / h, moved.back().v.y, exact);
  const auto alone = after({moving[0]}, 1, 1, given.beta, g, h);
  p.law("one sweep solves the row of a single rod, JV = 0", "m²/s", dot(moving[0].p, alone[0].v), 0, exact);
  p.law(
      "a rod pulls at both its bobs alike, so that gravity alone changes how much the chain turns about the "
      "origin, Σ p × v",
      "m²/s", turn(moved) - turn(moving),
      -g * h *
          [&] {
            double sum = 0;
            for (const Bob& bob : moving) sum += bob.p.x;
            return sum;
          }(),
      exact);
  const auto solved = after(moving, 1, plenty, given.beta, g, h);
  for (std::size_t i = 0; i < links; ++i)
    p.law("many sweeps solve all rows: JV = 0 where no rod has an error", "m²/s",
          dot(from_above(moving, i).p, from_above(solved, i).v), 0, exact);

  const auto still = hung(L, std::vector<double>(links, 0));
  const int k = 1 + p.one_of(5);
  const std::string k_is = "k = " + std::to_string(k);
  p.law("of two rods that hang, " + k_is + " sweeps leave the lower bob cos²ᵏ(π/4) of its fall g·h (lesson 3)",
        "1", after(hung(L, {0, 0}), 1, k, 0, g, h)[1].v.y / (-g * h), std::pow(0.5, k), exact);
  const double sweeps = 6.0 * static_cast<double>(links);
  const auto fall = [&](double swept) { return after(still, 1, swept, 0, g, h).back().v.y; };
  p.law("a sweep leaves cos²(π/2N) of the speed at which a chain of N = " + std::to_string(links) +
            " rods still falls (lesson 3)",
        "1", fall(sweeps + 1) / fall(sweeps),
        std::pow(std::cos(std::numbers::pi / (2 * static_cast<double>(links))), 2), exact);

  const double steps = std::floor(2 / h);
  p.law(
      "without gravity and β, a rod of length L whose bob is thrown at v₀ across it grows to L(1 + 2v₀²ht/L²)^¼ "
      "in "
      "⌊2 s/h⌋ steps (lesson 4)",
      "m", length(after({{{L, 0}, {0, v0}}}, steps, 1, 0, 0, h)[0].p),
      L * std::pow(1 + 2 * v0 * v0 * h * steps * h / (L * L), 0.25), 5e-4 * L);
  auto strained = hung(L, std::vector<double>(links, angles[0]));
  double longer = 0;
  for (std::size_t i = 0; i < links; ++i) strained[i].p += turned({0, -(longer += errors[i])}, angles[0]);
  const auto cured = after(strained, k, plenty, given.beta, 0, h);
  for (std::size_t i = 0; i < links; ++i)
    p.law("at rest and without gravity, " + k_is + " steps leave (1 − β)ᵏ of a rod's error (lesson 4)", "1",
          (length(from_above(cured, i).p) - L) / errors[i], std::pow(1 - given.beta, k), 1e-4);

  const auto hanging = after(still, 3, plenty, given.beta, g, h);
  p.law("a chain that hangs straight down rests", "m", hanging.back().p.y, still.back().p.y, exact);
  for (std::size_t i = 0; i < links; ++i)
    p.law("each rod of a hanging chain pulls with the weight below it", "m·g", hanging[i].pull / weight,
          static_cast<double>(links - i), exact);
  const double fine = 2e-3 * std::sqrt(L / g);
  p.law(
      "let go at θ₀, a bob's rod pulls with (3 − 2cosθ₀)·m·g where it hangs straight down (lesson 2)", "m·g",
      after(hung(L, {theta}), std::round(quarter_of_a_swing(theta, L, g) / fine), 1, given.beta, g, fine)[0].pull /
          weight,
      3 - 2 * std::cos(theta), 1e-3);
}

void film(Film& film, const Code& code) {
  const auto [simulate] = Learners::of(code);
  film.title = "Five rods of 1 m, let go level";
  film.quantity = "length of the chain, along its rods";
  film.unit = "m";
  std::vector<Bob> bobs = hung(1, std::vector<double>(5, std::numbers::pi / 2));
  for (int i = 0; i <= 120; ++i) {
    Frame frame{{{Shape::anchor, {}, {}}}};
    for (std::size_t k = 0; k < bobs.size(); ++k) {
      const Vec2 rod = from_above(bobs, k).p;
      frame.shapes.push_back({Shape::rod, bobs[k].p - rod, bobs[k].p});
      frame.shapes.push_back({Shape::bob, bobs[k].p, {0.1, 0}});
      frame.reading += length(rod);
    }
    film.frames.push_back(frame);
    simulate({.sweeps = 60, .steps = 2}, bobs);
  }
}
