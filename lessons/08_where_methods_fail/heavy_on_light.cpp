// Deeper: a heavy box on a light one.

#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/column.hpp"
#include "lessons/laws/hopping.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;

constexpr double pair_beta = 0.2;

Outcome two_boxes(int sweeps, double ratio) {
  return laws::hop({.boxes = 2, .sweeps = sweeps, .beta = pair_beta, .top_mass = ratio, .steps = 10'000});
}

/// Whether a box flies off while a heavier one only hops: " Not always …", or "".
std::string out_of_order(const Map& map) {
  const std::size_t columns = map.x.values.size(), rows = map.y.values.size();
  for (std::size_t column = 0; column < columns; ++column)
    for (std::size_t row = 0; row + 1 < rows; ++row)
      if (map.outcomes[row * columns + column] == Outcome::explodes &&
          map.outcomes[(row + 1) * columns + column] == Outcome::rings)
        return say(" Not always in order of mass: with @, @ kg flies off, @ kg only hops.",
                   several(std::lround(map.x.values[column]), "sweep"), Value(map.y.values[row], 2),
                   Value(map.y.values[row + 1], 2));
  return "";
}

}  // namespace

void heavy_on_light(const Setting& setting, Page& page) {
  constexpr int sweeps = 10;
  const double law = laws::heaviest_top(sweeps, pair_beta);
  double measured = 1.3 * law;
  while (two_boxes(sweeps, measured) != Outcome::settles) measured /= 1.01;

  page.text(
      R"(This is the first family, with a little of the second. A box of r kg lies on a box of 1 kg, which lies on the
      ground. The ground's row sees only the light box, the row between the two sees both: a sweep leaves r/(1 + r) of
      what is missing, k sweeps leave q = (r/(1 + r))ᵏ. A warm start adds up what the sweeps bring, and the correction
      with it. And contacts are not rods: one that has opened closes its gap within one step, as if β were 1. So the
      boxes hop on each other instead of coming to rest.)");
  const double heavier = laws::heaviest_top(2 * sweeps, pair_beta) / law;
  page.choose(
      {.ask = say(
           R"(With @ warm sweeps a step and β = @, the heaviest box that settles on one of 1 kg weighs @ kg. How
                          heavy may it be with twice as many sweeps?)",
           sweeps, pair_beta, Value(measured, 2)),
       .options = {{"about as heavy", "Twice as many sweeps leave q², which is much less."},
                   {"about twice as heavy",
                    "q = (r/(1 + r))ᵏ is about e^(−k/r): the same for twice the mass with twice the sweeps."},
                   {"about four times as heavy", "N² is the law of long chains. Here there are two boxes."}},
       .answer = static_cast<int>(std::lround(std::log2(heavier))),
       .hints = {"What do k sweeps leave, and on which combination of k and r does it depend?",
                 "q = (r/(1 + r))ᵏ = (1 − 1/(1 + r))ᵏ", "For large r that is about e^(−k/r)."}});
  const Map map = map_of(page, counting_knob("warm sweeps a step", 1, 16, setting.resolution),
                         knob("upper mass / lower mass", 1, 200, setting.resolution),
                         [](double k, double ratio) { return two_boxes(static_cast<int>(k), ratio); });
  std::vector<double> limits(1);
  for (int k = 1; k <= 17; ++k) limits.push_back(laws::heaviest_top(k, pair_beta));
  const auto boundary = [&](double k) { return limits[std::min(17, static_cast<int>(std::lround(k)))]; };
  page.figure("mass_and_sweeps",
              say("Each cell is one run of two boxes, β = @. A box “flies off” if it rises a box's height. "
                  "Dashed: the law.@",
                  pair_beta, out_of_order(map)),
              chart(map, say("r of law 9 at β = @", pair_beta), boundary,
                    {"settles", "drifts", "goes on hopping", "flies off", "no solution"}));
  const Agreement agreed = agreement(map, boundary, Settles::below);
  page.text(
      R"(@ The limit also depends on β: a weaker correction lets heavier boxes settle (by law 9 with @ sweeps, @ kg at
      β = 0.1 and @ kg at β = 0.5). A light box on a heavy one has no such limit.)",
      agreed.sentence(), sweeps, Value(laws::heaviest_top(sweeps, 0.1), 2),
      Value(laws::heaviest_top(sweeps, 0.5), 2));
  claim_agreement(page, agreed, 0.15, "law of heavy on light", setting.resolution);
  page.claim(say("heaviest box that settles on one of 1 kg, @ sweeps, from above", sweeps), measured, "kg",
             is(law, "law of heavy on light", relative(0.05)));
  for (const double light : {0.5, 0.1, 0.01})
    page.claim(say("a box of @ kg on one of 1 kg, one sweep: whether it settles", light),
               two_boxes(1, light) == Outcome::settles ? 1.0 : 0.0, "1",
               is(1, "law of heavy on light: q < 1/2", absolute(0)));
}

}  // namespace byhand::failures
