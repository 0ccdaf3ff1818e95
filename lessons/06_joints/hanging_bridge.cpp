// Deeper: planks that hang from two anchors.

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/scenes/bridge.hpp"

namespace byhand::joints {
namespace {

using Bridge = Simulation<PlaneBody>;

constexpr int planks = 10;

/// The bridge at rest: only friction would bring it there, so a little of what moves is taken away in each step.
Bridge at_rest(const Setting& setting) {
  Bridge bridge_now{bridge({.planks = planks, .length = setting.length, .mass = setting.mass, .slope = 0.5}),
                    {.solver = Direct{}, .drift = Baumgarte{setting.beta}}};
  const int steps = static_cast<int>(60 / setting.h);
  for (int i = 0; i < steps; ++i) {
    bridge_now.step(setting.h);
    for (int body = 0; body < bridge_now.scene.bodies().size(); ++body)
      bridge_now.scene.set_velocity(body, (1 - 3 * setting.h) * bridge_now.scene.bodies().velocity[body]);
  }
  return bridge_now;
}

/// What pin i gives the body on its right [N].
Point force(const Bridge& bridge, int i) { return bridge.reaction(i).force; }

}  // namespace

void hanging_bridge(const Setting& setting, Page& page) {
  const Bridge bridge_now = at_rest(setting);
  const double plank = setting.mass * gravity, weight = planks * plank, pull = -force(bridge_now, 0).x();
  page.text(
      R"(@ planks of @ m and @ kg, pinned end to end between two anchors: @ rows in a path, which the direct solve
      takes at once. At rest each anchor carries half the weight, and the horizontal part of the pull, H, is the same
      in every pin, because no other force is horizontal. So a plank's slope is the weight between its middle and the
      lowest point of the bridge, over H:)",
      planks, setting.length, setting.mass, 2 * (planks + 1));
  page.formula(
      "tan θᵢ = (i − (n + 1)/2) w/H,   w = @ N, H = @ N",
      R"(\tan\theta_i = \bigl(i - \tfrac{n+1}{2}\bigr)\frac{w}{H}, \qquad w = @\,\mathrm{N},\; H = @\,\mathrm{N})",
      plank, Value(pull, 4));
  Curve level{.label = "horizontal", .style = CurveStyle::line_and_markers},
      upright{.label = "vertical", .style = CurveStyle::line_and_markers},
      law{.label = "statics", .style = CurveStyle::theory};
  std::vector<std::pair<Point, Point>> arrows;
  double worst = 0, worst_level = 0, worst_slope = 0;
  const auto& scene = bridge_now.scene;
  for (int i = 0; i <= planks; ++i) {
    const Point given = force(bridge_now, i);
    const double share = weight * (0.5 - static_cast<double>(i) / planks);
    level.x.push_back(i);
    level.y.push_back(-given.x() / weight);
    upright.x.push_back(i);
    upright.y.push_back(given.y() / weight);
    law.x.push_back(i);
    law.y.push_back(share / weight);
    worst = std::max(worst, std::abs(given.y() - share) / weight);
    worst_level = std::max(worst_level, std::abs(given.x() + pull) / weight);
    const auto& at = scene.all<Pin>()[i].at;
    const int body = i < planks ? at.body2 : at.body1;
    const Bar bar = bar_of(scene.bodies().pose[body], setting.length);
    arrows.emplace_back(i < planks ? bar.from : bar.to, given);
    if (i == 0) continue;
    const auto& turn = scene.bodies().pose[i].rotation;
    worst_slope = std::max(worst_slope, std::abs(turn.sin / turn.cos - (i - 0.5 * (planks + 1)) * plank / pull));
  }
  Chart chart{.x = {.label = "pin"}, .y = {.label = "force / weight of bridge"}, .curves = {level, upright, law}};
  page.figure(
      "bridge",
      R"(The bridge at rest; arrows: the force of each pin on the body to its right (the last one: on the anchor).
              Below: their horizontal parts, all the same, and their vertical parts, the weight between pin and lowest
              point.)",
      [=](Canvas& canvas) {
        const auto [upper, lower] = canvas.page().inset(16).split_rows(0.48, 10);
        const double span = planks * setting.length;
        canvas.look(fit({-0.04 * span, -0.22 * span, 1.04 * span, 0.3 * span}, upper, 8));
        pictures::draw(canvas, pictures::rods_and_bobs(bridge_now.scene), {.link = 12});
        for (const auto& [at, given] : arrows) canvas.vector(at, given, {palette::force, 0.08 * span / pull, "N"});
        canvas.look_at_page();
        draw(canvas, chart, lower);
      });
  page.text(
      R"(A flatter bridge has a larger H. Here each anchor is pulled with √(H² + (W/2)²) = @ N, @ of the whole weight W,
      although it bears only half of it; a level bridge would pull infinitely hard. The tension all along the chain
      makes bridges hard for sweeps (lesson 3).)",
      Value(force(bridge_now, 0).norm(), 4), Value(force(bridge_now, 0).norm() / weight, 3));
  const std::string source = "statics: the weight between the pin and the lowest point";
  page.claim("vertical force of each pin, largest difference over the weight", worst, "1",
             is(0, source, absolute(1e-4)));
  page.claim("horizontal force, largest difference from pin to pin over the weight", worst_level, "1",
             is(0, "no other force is horizontal", absolute(1e-4)));
  page.claim("slope of the planks, largest difference", worst_slope, "1",
             is(0, "tan θᵢ = (i − (n + 1)/2) w/H", absolute(1e-3)));
}

}  // namespace byhand::joints
