#include "lessons/08_where_methods_fail/stack_film.hpp"

#include "lessons/pictures/boxes.hpp"

namespace byhand::failures {

Film<PlaneBody> film_of_stacks(int boxes, const std::vector<SolvedStack>& stacks, double hurry) {
  Scene<PlaneBody> kicked = stack(boxes);
  kick(kicked, 0.02);
  // It falls once its top has sunk by half a box, which is then so far aside.
  const double height = boxes, half = std::sqrt(height) + 1;
  Shooting<PlaneBody> shooting{
      .view = {-half, -0.03 * height, 2 * half, 1.06 * height},
      .hurry = hurry,
      .gauge = {.label = "top box is off by (m)", .scale = renderer::Scale::logarithmic, .range = {{1e-5, 10}}},
      .read = [](const Scene<PlaneBody>& scene) { return std::abs(scene.bodies().pose.back().position.x()); },
      .failed =
          [=](const Scene<PlaneBody>& scene) { return !(scene.bodies().pose.back().position.y() > height - 1); },
      .failure = "falls",
      .success = "stands",
      .drifting = "still leans further when the film ends",
      .noticed = 0.02,
      .draw =
          [](renderer::Canvas& canvas, const Scene<PlaneBody>& scene, const renderer::Look& look) {
            pictures::Shapes shapes = pictures::shapes_of(scene);
            for (auto& box : shapes.boxes) box.look = {look.fill, {look.edge.colour, 1}};
            pictures::draw(canvas, shapes);
          }};
  for (const SolvedStack& solved : stacks) shooting.takes.push_back({solved.name, {kicked, solved.method}});
  return Film<PlaneBody>(std::move(shooting));
}

}  // namespace byhand::failures
