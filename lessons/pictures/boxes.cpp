#include "lessons/pictures/boxes.hpp"

#include <cmath>

#include "solver/constraints/contact_manifold.hpp"

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

std::vector<Push> pushes(const Scene<M>& scene, const System<M>& system) {
  std::vector<Push> pushes;
  for (int place = 0; place < scene.count(); ++place) {
    const auto& entry = scene.entries()[place];
    const std::type_info& kind = scene.store(entry.kind).kind();
    const double* lambda = &system.lambda[system.row_of[place]];
    const Pose<M>& pose = scene.bodies().pose[entry.body2];
    const auto point = [&](const Arm<M>& arm) {
      return Point(anchor<M, double>(pose, in_world<M, double>(pose, arm)));
    };
    if (kind == typeid(Contact<M>)) {
      const Contact<M>& contact = scene.all<Contact>()[entry.index];
      pushes.push_back({point(contact.at.arms.second), lambda[0] * contact.normal});
    } else if (kind == typeid(Friction<M>)) {
      const Friction<M>& friction = scene.all<Friction>()[entry.index];
      pushes.push_back({point(friction.at.arms.second), lambda[0] * friction.tangents.col(0)});
    } else if (kind == typeid(ContactManifold<M>)) {
      const ContactManifold<M>& contact = scene.all<ContactManifold>()[entry.index];
      const double first = lambda[0], second = lambda[1], both = first + second;
      if (both <= 0) continue;
      const Linear<M> n = contact.normal, t(n.y(), -n.x());
      const Linear<M> unit = n + lambda[2] / both * t;
      pushes.push_back({point(contact.at.arms.second), first * unit});
      if (!contact.point) pushes.push_back({point(contact.second.second), second * unit});
    }
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
