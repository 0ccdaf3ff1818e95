// Step 5: a block on a slope, a little steeper and a little less steep than friction holds.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/incline.hpp"

namespace byhand::beside {
namespace {

using M = PlaneBody;

constexpr int slope_frames = 120;  // 2 s
constexpr double degree = 3.14159265358979323846 / 180;

/// How far the block has come down the slope in two seconds [m].
double slid(const Contestant<M>& contestant, double slope, double friction) {
  const Scene<M> scene = box_on_incline(slope, friction);
  double way = 0;
  engines::run<M>(contestant, scene, slope_frames, [&](const Scene<M>& seen, double) {
    way = (seen.bodies().pose[1].position - scene.bodies().pose[1].position)
              .dot(Linear<M>(std::cos(slope), -std::sin(slope)));
  });
  return way;
}

}  // namespace

void block_on_a_slope(const Setting& setting, Page& page) {
  const double mu = setting.friction, limit = std::atan(mu), time = slope_frames * frame;
  const auto acceleration = [&](double slope) {
    return std::max(0.0, gravity * (std::sin(slope) - mu * std::cos(slope)));
  };
  page.text(
      R"(A block slides where tanθ > μ (lesson 5). With μ = @ the limit is @°. Here the slope is 1° and 0.1° to either side
      of it; a block on the steeper ones slides by ½at² in @ s, on the others it stays.)",
      mu, Value(limit / degree, 4), time);
  const double steeper = limit + degree, way = 0.5 * acceleration(steeper) * time * time;
  page.predict({.ask = say("1° steeper than the limit of @°: how far does the block slide in @ s?",
                           Value(limit / degree, 4), time),
                .answer = way,
                .unit = "m",
                .tolerance = 0.04 * way,
                .wrong = {{0.5 * gravity * std::sin(steeper) * time * time, "That is a slope without friction."}},
                .hints = {"What is left of gravity along the slope, less friction?", "a = g (sinθ − μ cosθ)",
                          say("a = 9.81 · (sin @° − @ · cos @°)", Value(steeper / degree, 4), mu,
                              Value(steeper / degree, 4))},
                .right = say("a = @ m/s², and ½at² = @ m.", Value(acceleration(steeper), 3), Value(way, 3))});
  const auto field = entrants<M>(1, 1, [](const Engine&) { return true; });
  const std::vector<double> aside{1, 0.1, -0.1, -1};
  std::vector<std::vector<std::string>> rows{{"closed form"}};
  for (const double d : aside)
    rows[0].push_back(say("@ m", Value(0.5 * acceleration(limit + d * degree) * time * time, 3)));
  std::vector<double> ours;
  int wrong = 0;
  std::string creeping;
  for (const Entrant<M>& entrant : field) {
    std::vector<std::string> row{entrant.name};
    bool creeps = false;
    for (const double d : aside) {
      const double found = slid(entrant.settings.front(), limit + d * degree, mu),
                   exact = 0.5 * acceleration(limit + d * degree) * time * time;
      row.push_back(std::abs(found) < 1e-6 ? std::string("0") : say("@ m", Value(found, 3)));
      if (entrant.name == ours_name)
        ours.push_back(found);
      else if (std::abs(found - exact) > std::max(0.1 * exact, 0.001))
        creeps = true;
    }
    if (creeps) ++wrong, creeping += (creeping.empty() ? "" : ", ") + entrant.name;
    rows.push_back(row);
  }
  page.table({"slid in 2 s", "1° steeper", "0.1° steeper", "0.1° less steep", "1° less steep"}, rows);
  page.text(
      R"(@ Symplectic Euler slides by ½at(t + h), which is @ % too far.)",
      field.size() == 1 ? std::string("There is no other engine here to compare with.")
      : wrong == 0
          ? std::string("All engines are within a tenth of the closed form, or a millimetre.")
          : say(R"(More than a tenth and a millimetre off the closed form on one slope or another: @. Where friction is
                solved before the normal impulses have grown, or has an impulse of an earlier step as its limit, a block
                creeps.)",
                creeping),
      Value(100 * frame / time, 2));
  for (std::size_t i = 0; i < aside.size(); ++i)
    page.claim(say("this course, @° from the limit: slid", Value(aside[i], 2)), ours[i], "m",
               is(0.5 * acceleration(limit + aside[i] * degree) * time * (time + frame),
                  "½at(t + h) of symplectic Euler", absolute(2e-4)));
}

}  // namespace byhand::beside
