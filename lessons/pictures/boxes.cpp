#include "lessons/pictures/boxes.hpp"

namespace byhand::pictures {

using renderer::Canvas;
using renderer::Point;

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
