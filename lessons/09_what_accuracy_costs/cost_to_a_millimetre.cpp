// A chapter of the appendix: what a millimetre costs on chains that grow longer, and on chains whose end grows
// heavier.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/catalogue/cheapest.hpp"
#include "lessons/catalogue/limits.hpp"
#include "lessons/catalogue/tidy.hpp"
#include "lessons/catalogue/verification.hpp"

namespace byhand::accuracy {
namespace {

constexpr double wanted_drift = 1e-3;
constexpr double angle = 30;     // [°]: from level a light chain whips, which has nothing to do with its length
constexpr double per_row = 1e4;  // instructions a row and substep of law 7, up to which it is looked for
const std::vector<std::string_view> compared{"Gauss–Seidel", "conjugate sweeps", "direct", "RATTLE", "RK4", "XPBD",
                                             "AVBD"};

/// What each method costs to a millimetre on each problem; infinite where it costs more than is looked for.
struct Scaling {
  std::vector<double> x;
  std::vector<std::vector<double>> cost = {};  // by method
  std::string data = tidy_head();

  std::vector<double> of(std::string_view family) const {
    return cost[static_cast<std::size_t>(std::find(compared.begin(), compared.end(), family) - compared.begin())];
  }
};

/// What reaches it from a few starts at the least cost, with so many more substeps that it keeps it from all of
/// `starts`, of which the first is the chain's own, over the whole time.
Candidate cheapest_kept(const Problem& problem, const Family& family, double most) {
  constexpr int few = 2;
  const Wish wish{.limits = {{Error::drift, wanted_drift}}};
  Candidate found = cheapest(variations(problem, first_numbers(few), seed_of_searches), family, wish, most);
  if (!found.reached) return found;
  const std::vector<int> numbers = first_numbers(starts);
  const std::vector<Problem> others = variations(problem, std::span(numbers).subspan(1), seed_of_verifications);
  for (Knobs knobs = found.point.knobs;; knobs.substeps += std::max(1, knobs.substeps / 8)) {
    found.point = whole_run(problem, family, knobs, wish);
    found.reached = found.point.cost <= most;
    if (!found.reached) return found;
    const bool own = excess(found.point, wish.limits) <= 1;
    if (own && verify(others, found.point, wish, one_after_another, true).kept()) return found;
  }
}

Scaling scaling(const Page& page, const std::vector<double>& x, const std::function<Problem(double)>& problem_at) {
  Scaling result{.x = x};
  const int methods = static_cast<int>(compared.size());
  const auto found = page.side_by_side(methods * static_cast<int>(x.size()), [&](int i) {
    const Problem problem = problem_at(x[static_cast<std::size_t>(i / methods)]);
    const double most = per_row * problem.start().rows() * limit_of(problem).substeps;
    return cheapest_kept(problem, family_named(compared[static_cast<std::size_t>(i % methods)]), most);
  });
  result.cost.resize(compared.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    result.cost[i % compared.size()].push_back(found[i].reached ? found[i].point.cost : INFINITY);
    result.data +=
        tidy_rows(problem_at(x[i / compared.size()]), std::span(&found[i].point, 1), std::array{Error::drift});
  }
  return result;
}

/// "N to the power of 1 ± 0.1".
std::string power_in_words(const char* of, const std::optional<Order>& power) {
  return say("as @ to the power of @ ± @", of, Value(power->slope, 2), Value(power->uncertainty, 1));
}

renderer::Chart chart_of(const Scaling& scaling, const std::string& label, const std::vector<double>& slopes) {
  using namespace renderer;
  Chart chart{.title = "cost to a drift of 1 mm",
              .x = {.label = label, .scale = Scale::logarithmic},
              .y = {.label = "cost (instructions per frame)", .scale = Scale::logarithmic}};
  for (std::size_t i = 0; i < compared.size(); ++i)
    chart.curves.push_back({.label = std::string(compared[i]),
                            .x = scaling.x,
                            .y = scaling.cost[i],
                            .style = CurveStyle::line_and_markers,
                            .place = pictures::place_of(compared[i])});
  // Dashed lines end in the direct solve's last point.
  const double last = scaling.of("direct").back();
  for (const double slope : slopes)
    chart.curves.push_back({.label = say("slope @", slope),
                            .x = {scaling.x.front(), scaling.x.back()},
                            .y = {last * std::pow(scaling.x.front() / scaling.x.back(), slope), last},
                            .style = CurveStyle::theory});
  return chart;
}

}  // namespace

void cost_to_a_millimetre(Page& page) {
  const std::vector<double> lengths{10, 22, 50, 100, 300, 1000}, ratios{1, 10, 100, 1e3, 1e4, 1e5, 1e6};
  const auto with_end = [](double r) {
    return Problem("chain", {{"links", 10}, {"end_mass", r}, {"angle", angle}});
  };
  const Scaling longer = scaling(page, lengths,
                                 [](double n) {
                                   return Problem("chain", {{"links", n}, {"angle", angle}});
                                 }),
                heavier = scaling(page, ratios, with_end);
  page.text(
      R"(What does a millimetre cost? For each chain the program looks for the cheapest run of each method, all choices
      free, whose joints open by @ m at most in @ s, from each of @ starts. First, chains of @ to @ equal links, let go at @° from straight down:)",
      wanted_drift, Problem("chain").scene().duration, starts, lengths.front(), lengths.back(), angle);
  page.figure("appendix_millimetre_by_length",
              R"(Cost of a drift of a millimetre against the number of links. Crosses: the search found no
              choice of the method that reaches it for 10 000 instructions a row and substep of law 7.)",
              chart_of(longer, "links", {1, 2}), longer.data);
  const auto by_length = fitted_power(lengths, longer.of("direct")),
             swept = fitted_power(lengths, longer.of("Gauss–Seidel"));
  page.text(
      R"(The cost of the direct solve grows @ (with the 95 % interval of the fit): @. @)",
      by_length ? power_in_words("N", by_length) : "in no way that these runs show",
      "each link costs the same, and whatever exceeds the power of 1 is the substeps of a longer chain",
      !swept
          ? std::string("Gauss–Seidel reaches the millimetre on too few of them for a fit.")
          : say(R"(That of Gauss–Seidel grows @. By law 4 a chain that starts cold needs sweeps in proportion to N² for
                each digit, each of N rows: a power of 3. A warm start and a target of a millimetre need few digits in a
                frame.)",
                power_in_words("N", swept)));
  page.text(
      R"(Now ten links with an end that is up to @ times as heavy as a link. By law 7 the step must shrink as the root
      of the tension, whatever solves the rows:)",
      ratios.back());
  page.figure("appendix_millimetre_by_mass",
              R"(Cost of a drift of a millimetre against the mass of the end over that of a link. Crosses: the
              search found no choice of the method that reaches it for 10 000 instructions a row and
              substep of law 7.)",
              chart_of(heavier, "mass ratio", {0.5}), heavier.data);
  // Where the law asks for one substep a heavier end costs nothing.
  const auto first = std::ranges::find_if(ratios, [&](double r) { return limit_of(with_end(r)).substeps > 1; });
  const auto light = first - ratios.begin();
  const std::vector<double> costs = heavier.of("direct");
  const auto by_mass = fitted_power(std::span(ratios).subspan(light), std::span(costs).subspan(light));
  page.text(
      "From a ratio of @ on the law asks for more than one substep. From there the direct solve's cost grows @.",
      *first, by_mass ? power_in_words("the ratio", by_mass) : "in no way that these runs show");
  page.claim("direct, cost to a millimetre: power of the number of links, least of the 95 % interval",
             by_length ? by_length->slope - by_length->uncertainty : NAN, "1",
             is_at_most(1, "a chain's factor has a block for each link"));
  page.claim("direct, cost to a millimetre: power of the mass ratio, where law 7 asks for more than one substep",
             by_mass ? by_mass->slope : NAN, "1", is(0.5, "law 7: its root", absolute(0.1)));
}

}  // namespace byhand::accuracy
