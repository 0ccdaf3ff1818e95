#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {

void why_velocity(const Setting& setting, Page& page) {
  const double length = setting.length(), stretched = 1.2;
  Pendulum scene = pendulum<PlaneParticle>(radians(setting.angle()), length, setting.mass());
  scene.set_position(1, stretched * scene.bodies().pose[1].position);
  const auto& rod = scene.all<Distance>().front();
  const auto error = [&] { return rod.value<double>(scene.bodies().pose[0], scene.bodies().pose[1])[0]; };

  page.text(
      R"(Why not move the *position* until C = 0, with the same row? Pull the bob out to @ L and try. C of (2) is
      quadratic, so J changes with the position: a move of −C/(JM⁻¹Jᵀ) along M⁻¹Jᵀ leaves an error.)",
      stretched);
  Curve left{.label = "", .style = CurveStyle::line_and_markers, .colour = palette::error};
  std::vector<double> distances;
  for (int i = 0; i <= 3; ++i) {
    const OneRow row(scene);
    left.x.push_back(i);
    left.y.push_back(std::abs(error()));
    distances.push_back(row.d.norm());
    scene.set_position(1, scene.bodies().pose[1].position + row.W.l2().transpose() * (-error() / row.K));
  }
  page.figure(
      "why_velocity",
      R"(|C| after each position correction. This is Newton's method: each error is proportional to the square of
      the last. JV = 0 is linear in V, and one impulse solves it to rounding.)",
      Chart{.x = {.label = "corrections", .ticks = {{0, "0"}, {1, "1"}, {2, "2"}, {3, "3"}}},
            .y = {.label = "|C| (m²)", .scale = Scale::logarithmic},
            .curves = {left}});
  page.text(
      R"(After one move @ m² of the @ m² is left, after two moves @ m². But the bob keeps its
      velocity: if it moves outwards, it is off the circle again one step later, unless V is corrected too.
      Position-based dynamics does that by V = Δx/h; this course, like the article, solves JV = 0 and corrects what
      drift is left (lesson 4). JV = 0 for all rows is a linear system; C = 0 for all rows is not.)",
      left.y[1], left.y[0], left.y[2]);

  const double C0 = left.y[0];
  page.claim("C left after one move of the position", left.y[1], "m²",
             is(C0 * C0 / (2 * distances[0] * distances[0]), "C₀²/(2|d|²), what the linear part leaves",
                relative(1e-12)));
}

}  // namespace byhand::single_constraint
