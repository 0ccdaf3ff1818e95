#include "lessons/pictures/boxes.hpp"

#include <cmath>

namespace byhand::pictures {

using renderer::Canvas;
using renderer::Point;
using M = PlaneBody;

Shapes shapes_of(const Scene<M>& scene) {
  Shapes shapes;
  const std::vector<Shape<M>>& all = scene.colliders().shapes;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Pose<M>& pose = scene.bodies().pose[i];
    const double angle = std::atan2(pose.rotation.sin, pose.rotation.cos);
    const renderer::Look look = moves(scene.bodies().inverse_mass[i]) ? renderer::body_look : renderer::fixed_look;
    if (const auto* box = std::get_if<byhand::Box<M>>(&all[i]))
      shapes.boxes.push_back({i, pose.position, box->sides, angle, look});
    if (const auto* ball = std::get_if<Ball<M>>(&all[i]))
      shapes.discs.push_back({i, pose.position, ball->radius, angle, look});
    if (const auto* ground = std::get_if<HalfSpace<M>>(&all[i]))
      shapes.grounds.push_back({pose.position, rotate(pose.rotation, ground->normal)});
  }
  return shapes;
}

std::vector<Push> pushes(const Simulation<M>& simulation) {
  std::vector<Push> pushes;
  for (const Touch<M>& touch : simulation.touches()) {
    const Linear<M> per_normal = touch.impulse / touch.impulse.dot(touch.normal);
    for (const auto& point : touch.points) pushes.push_back({point.at, point.normal_impulse * per_normal});
  }
  return pushes;
}

void draw(Canvas& canvas, const Shapes& shapes) {
  const renderer::Camera& camera = canvas.camera();
  const Point lower = camera.to_world({camera.frame.x, camera.frame.y}),
              upper = camera.to_world({camera.frame.right(), camera.frame.top()});
  for (const Shapes::Ground& ground : shapes.grounds) {
    const Point along(ground.normal.y(), -ground.normal.x());
    const Point middle = ground.at + along * along.dot(0.5 * (lower + upper) - ground.at);
    const Point reach = std::abs(along.x()) > std::abs(along.y())
                            ? Point(along * (0.5 * (upper - lower).x() / std::abs(along.x())))
                            : Point(along * (0.5 * (upper - lower).y() / std::abs(along.y())));
    canvas.ground(middle - reach, middle + reach);
  }
  for (const Shapes::Box& box : shapes.boxes) canvas.box(box.at, box.size, box.angle, box.look);
  for (const Shapes::Disc& disc : shapes.discs) {
    canvas.disc(disc.at, disc.radius, disc.look);
    canvas.line(disc.at, disc.at + disc.radius * Point(std::cos(disc.angle), std::sin(disc.angle)),
                {disc.look.edge.colour, 1.2});
  }
}

void draw(Canvas& canvas, const std::vector<Push>& pushes, const renderer::ArrowKind& kind) {
  for (const Push& push : pushes)
    if (push.impulse.squaredNorm() > 0) canvas.vector(push.at, push.impulse, kind);
}

}  // namespace byhand::pictures
