// Deeper: the longest step at which each method is stable, by eigenvalues and by runs.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/catalogue/spectrum.hpp"

namespace byhand::accuracy {
namespace {

constexpr double longest = 0.1;              // [s]
constexpr double largest_radius = 1 + 1e-4;  // beyond which a spectral radius is no rounding
const std::vector<double> masses{100, 1e4};  // of the end [kg]
constexpr std::size_t middle = 0;

ChainOptions taut(double end_mass) { return {.links = 6, .end_mass = end_mass}; }

/// The longest stable step of a method [s], by end mass.
struct Limits {
  std::string name;
  Method method;
  std::vector<double> eigenvalues = {}, runs = {};
};

std::vector<Limits> limits(const Page& page) {
  std::vector<Limits> methods;
  for (const auto& [name, cure] :
       {std::pair{"direct", Cure::baumgarte}, std::pair{"RATTLE", Cure::none},
        std::pair{"implicit midpoint", Cure::none}, std::pair{"RK4", Cure::none}, std::pair{"XPBD", Cure::none}})
    methods.push_back({name, family_named(name).setting(with_cure({}, cure)).method});
  const std::size_t count = masses.size();
  const auto found = page.side_by_side(static_cast<int>(2 * count * methods.size()), [&](int i) {
    const auto cell = static_cast<std::size_t>(i / 2);
    const Method& method = methods[cell / count].method;
    const ChainOptions chain = taut(masses[cell % count]);
    return longest_step(
        [&](double h) {
          return i % 2 == 0 ? spectral_radius(chain, method, h) < largest_radius : stays(chain, method, h);
        },
        longest);
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    Limits& method = methods[i / 2 / count];
    (i % 2 == 0 ? method.eigenvalues : method.runs).push_back(found[i]);
  }
  return methods;
}

std::string in_ms(double step) {
  return std::isfinite(step) ? say("@ ms", Value(1000 * step, 3)) : say("more than @ ms", 1000 * longest);
}

}  // namespace

void stability(Page& page) {
  const std::vector<Limits> methods = limits(page);
  const Limits &direct = methods.front(), &rk4 = methods[3], &xpbd = methods.back();
  page.text(
      R"(Before a method can be accurate it has to be stable. Take @ bobs of 1 kg on rods of 1 m that hang straight
      down, the last of them heavier, and push them aside a little. To first order a step is then a matrix that takes
      the sideways positions and velocities before it to those after it. The largest modulus of its eigenvalues is the
      *spectral radius*. Up to 1 a disturbance does not grow; beyond 1 the method is unstable, however well each step
      is solved.)",
      taut(1).links);
  const double dearer = 4 * direct.eigenvalues[middle] / rk4.eigenvalues[middle];
  page.predict(
      {.ask =
           R"(Sideways the bobs are springs with frequencies ω. The direct solve is stable for ωh < 2 (lesson 8), RK4
              for ωh < 2√2. Each at its longest stable step: how many times the work does RK4 take, with four slopes a
              step?)",
       .answer = 2 * std::sqrt(2.0),
       .unit = "1",
       .tolerance = 0.05,
       .wrong = {{4, "That is what a step costs. But RK4 takes fewer steps."},
                 {std::sqrt(2.0), "That is how much longer its step is. Each takes four slopes."}},
       .hints = {"How many times as long may its step be?", "2√2/2 = √2 times as long, with four slopes.",
                 "4/√2 = …"},
       .right = say("4/√2 (measured: @): with an end of @ kg its step is @ instead of @, with four slopes in it.",
                    Value(dearer, 4), masses[middle], in_ms(rk4.eigenvalues[middle]),
                    in_ms(direct.eigenvalues[middle]))});
  page.text(
      R"(Below, by eigenvalues: where the spectral radius of a step passes 1. By runs: the longest step with which a
      small disturbance stays below a thousand times its size for a thousand steps.)");
  std::vector<std::vector<std::string>> rows;
  std::string always;
  for (const Limits& method : methods) {
    rows.push_back({method.name});
    for (const std::size_t i : {middle, masses.size() - 1})
      for (const double step : {method.eigenvalues[i], method.runs[i]}) rows.back().push_back(in_ms(step));
    if (std::none_of(method.eigenvalues.begin(), method.eigenvalues.end(),
                     [](double h) { return std::isfinite(h); }))
      always += (always.empty() ? "" : ", ") + method.name;
  }
  const std::string light = say("@ kg", masses[middle]), heavy = say("@ kg", masses.back());
  page.table({"longest stable step", light + ", eigenvalues", light + ", runs", heavy + ", eigenvalues",
              heavy + ", runs"},
             rows);
  page.text(
      R"(All limits fall as one over the root of the end mass. This is law 7, which holds for every method whose forces
      act along directions known before the step ends. Implicit midpoint takes them from the middle of the step and has
      no limit in theory; but it finds that middle by repetition, which converges only where ωh < 2.@)",
      always.empty()
          ? ""
          : say(" Stable at every step that was tried: @. Step 3 showed what that costs in energy.", always));
  page.claim("RK4 over direct, longest stable step", rk4.eigenvalues[middle] / direct.eigenvalues[middle], "1",
             is(std::sqrt(2.0), "2√2 over 2 on the imaginary axis", relative(0.01)));
  for (const Limits* method : {&direct, &methods[1], &methods[2], &rk4})
    page.claim(method->name + ", longest stable step by runs over that by eigenvalues",
               method->runs[middle] / method->eigenvalues[middle], "1",
               is(1, "a small disturbance follows the linearised step", relative(0.03)));
  page.claim(say("XPBD at a step of @ s, end of @ kg: spectral radius", longest, masses.back()),
             spectral_radius(taut(masses.back()), xpbd.method, longest), "1",
             is_at_most(largest_radius, "it takes velocities from positions, which damps at every step"));
}

}  // namespace byhand::accuracy
