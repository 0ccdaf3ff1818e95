#pragma once

#include <functional>

#include "lessons/practise/learner/practise.hpp"
#include "renderer/chart.hpp"

namespace byhand::single_constraint {

/// plain_step, or what a reader made of it.
using Step = std::function<void(Vec2& x, Vec2& v, double m, Vec2 g, double h)>;

/// The bob that the step swings: the lesson's own at its defaults.
struct Bob {
  double L = 2, m = 3, release = 1.5707963267948966, h = 1.0 / 60;  // [m], [kg], [rad], [s]
};

/// C in units of L² and the change of energy in units of m·g·L over ten seconds of a swing. A reader's step stands
/// beside this lesson's own, which is dashed.
renderer::Chart chart_of(const Step& step, const Bob& bob);
renderer::Chart chart_beside_ours(const Step& readers);

}  // namespace byhand::single_constraint
