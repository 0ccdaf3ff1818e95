#include "lessons/08_where_methods_fail/stack_film.hpp"

#include "lessons/pictures/boxes.hpp"

namespace byhand::failures {

Film<PlaneBody> film_of_stacks(int boxes, const std::vector<SolvedStack>& stacks, double hurry) {
  Scene<PlaneBody> kicked = stack(boxes);
  kick(kicked, 0.02);
  const double height = boxes;
  Shooting<PlaneBody> shooting{
      .view = {-0.33 * height, -0.03 * height, 0.66 * height, 1.06 * height},
      .hurry = hurry,
      .gauge = {.label = "top box is off by (m)", .scale = renderer::Scale::logarithmic, .range = {{1e-5, 100}}},
      .read = [](const Scene<PlaneBody>& scene) { return std::abs(scene.bodies().pose.back().position.x()); },
      .failed =
          [=](const Scene<PlaneBody>& scene) { return !(scene.bodies().pose.back().position.y() > height - 1.5); },
      .failure = "falls",
      .success = "stands",
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
