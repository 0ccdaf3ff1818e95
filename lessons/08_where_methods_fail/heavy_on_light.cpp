// Deeper: a heavy box on a light one.

#include <cmath>

#include "lessons/08_where_methods_fail/laws/column.hpp"
#include "lessons/08_where_methods_fail/laws/hopping.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::Outcome;

constexpr double pair_beta = 0.2;

Outcome two_boxes(int sweeps, double ratio) {
  return laws::hop({.boxes = 2, .sweeps = sweeps, .beta = pair_beta, .top_mass = ratio, .steps = 10'000});
}

}  // namespace

void heavy_on_light(const Setting& setting, Page& page) {
  const int sweeps = 10;
  const double law = laws::heaviest_top(sweeps, pair_beta);
  double measured = 1.3 * law;
  while (two_boxes(sweeps, measured) != Outcome::settles) measured /= 1.01;

  page.predict(
      {.ask = say(R"(@ warm sweeps a step, β = @; a box of 1 kg on the ground. What is the heaviest box that
                  settles on top of it?)",
                  sweeps, pair_beta),
       .answer = measured,
       .unit = "kg",
       .tolerance = 0.25 * measured,
       .wrong = {{1000 * measured,
                  "Each sweep hands over only 1/r of the weight; warm start plus β turn the delay into ringing."},
                 {1, "More than that: warm steps add up, and ten sweeps see a good part of it."}},
       .hints = {"What share of the upper box's weight does one sweep bring to the ground?"},
       .right = "About three kilogrammes a sweep."});
  page.text(
      R"(Family one, with a little of family two. The ground sees the light box only, which sees the heavy one
      only: a sweep leaves r/(1 + r) of what is missing. A warm start adds up what sweeps bring, the correction
      with it, and what overshoots hops: an open contact closes its gap within one step, as if β were 1. So there
      are masses below the limit that ring on or settle by how they were put down; above it none settles.)");
  const Map map = map_of(page, counting_knob("warm sweeps a step (1)", 1, 16, setting.resolution),
                         knob("upper mass / lower mass (1)", 1, 200, setting.resolution),
                         [](double k, double ratio) { return two_boxes(static_cast<int>(k), ratio); });
  std::vector<double> limits(1);
  for (int k = 1; k <= 17; ++k) limits.push_back(laws::heaviest_top(k, pair_beta));
  const auto boundary = [&](double k) { return limits[std::min(17, static_cast<int>(std::lround(k)))]; };
  page.figure(
      "mass_and_sweeps",
      say(R"(Each cell is a run of two boxes, β = @. Dashed: the law, about r = 3k. "Rings" is: goes on hopping.)",
          pair_beta),
      chart(map, "about r = 3k", boundary));
  const double foreseen = share_foreseen(map, [&](double k, double ratio) { return ratio < boundary(k); });
  page.text("Of @ runs the law foresees @ %. Turn the stack round, light upon heavy, and there is nothing to see.",
            map.outcomes.size(), Value(100 * foreseen, 3));
  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.9,
              .source = "law B9",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  page.claim({.quantity = say("heaviest box that settles on one of 1 kg, @ sweeps, from above", sweeps),
              .unit = "kg",
              .expected = law,
              .source = "law B9",
              .measured = measured,
              .tolerance = relative(0.05)});
}

}  // namespace byhand::failures
