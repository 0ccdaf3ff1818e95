#include "lessons/stage/looks.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/pictures/space_scene.hpp"
#include "renderer/space.hpp"

namespace byhand::stage {
namespace {

using Eigen::Vector3d;
using namespace renderer;

template <class V>
Vector3d in_space(const Eigen::MatrixBase<V>& v) {
  if constexpr (V::RowsAtCompileTime == 2)
    return {v[0], v[1], 0};
  else
    return v;
}

template <class M>
Vector3d arm_of(const Arm<M>& arm) {
  if constexpr (M::angular == 0)
    return Vector3d::Zero();
  else
    return in_space(arm);
}

/// Calls f(anchors, look) if the constraint at a place is one that can be seen.
template <class M, class F>
void with_anchors(const Scene<M>& scene, int place, F&& f) {
  const auto as = [&]<class Kind>(TieLook::As look, const Kind* constraint) {
    if (constraint) f(constraint->at, look);
  };
  as(TieLook::As::rod, scene.template get_if<Distance<M>>(place));
  as(TieLook::As::rod, scene.template get_if<NormalisedDistance<M>>(place));
  as(TieLook::As::rod, scene.template get_if<Rope<M>>(place));
  as(TieLook::As::spring, scene.template get_if<Spring<M>>(place));
  as(TieLook::As::joint, scene.template get_if<Pin<M>>(place));
  as(TieLook::As::surface, scene.template get_if<Contact<M>>(place));
  if constexpr (M::angular > 0) {
    as(TieLook::As::joint, scene.template get_if<Weld<M>>(place));
    as(TieLook::As::joint, scene.template get_if<Slider<M>>(place));
  }
  if constexpr (M::angular == 3) as(TieLook::As::joint, scene.template get_if<Hinge<M>>(place));
}

/// Of a body without a shape: in space the box that has its mass and moments, in the plane a link from its first
/// joint through its centre, or a bob.
template <class M>
BodyLook shapeless(const Scene<M>& scene, int body, const SceneLook& look) {
  const InverseMass<M>& mass = scene.bodies().inverse_mass[body];
  BodyLook result;
  if (!moves(mass)) return result;
  if constexpr (M::angular == 3) {
    const Vector3d moments = mass.angular.cwiseInverse();
    result.as = BodyLook::As::box;
    for (int k = 0; k < 3; ++k)
      result.sides[k] = std::sqrt(
          std::max(6 * mass.linear * (moments.sum() - 2 * moments[k]), 1e-4 * mass.linear * moments.sum()));
    return result;
  }
  result.mass = 1 / mass.linear;
  result.as = BodyLook::As::bob;
  for (const TieLook& tie : look.ties) {
    const Vector3d arm = tie.body1 == body ? tie.arm1 : tie.arm2;
    if ((tie.body1 != body && tie.body2 != body) || arm.isZero(0) || tie.as == TieLook::As::surface) continue;
    result.as = BodyLook::As::link;
    result.from = arm;
    result.to = -arm;
    break;
  }
  return result;
}

template <class M>
BodyLook look_of_body(const Scene<M>& scene, int body, const SceneLook& look) {
  const auto& shapes = scene.colliders().shapes;
  BodyLook result;
  if (static_cast<std::size_t>(body) < shapes.size()) {
    const Shape<M>& shape = shapes[body];
    if (const auto* round = std::get_if<Ball<M>>(&shape)) {
      result.as = BodyLook::As::disc;
      result.sides.x() = round->radius;
    }
    if constexpr (M::angular > 0)
      if (const auto* block = std::get_if<Box<M>>(&shape)) {
        result.as = BodyLook::As::box;
        result.sides = in_space(block->sides);
      }
    if (const auto* half = std::get_if<HalfSpace<M>>(&shape)) {
      result.as = BodyLook::As::half_space;
      result.sides = in_space(half->normal);
    }
  }
  return result.as == BodyLook::As::nothing ? shapeless(scene, body, look) : result;
}

double reach(const BodyLook& body) {
  switch (body.as) {
    case BodyLook::As::disc: return body.sides.x();
    case BodyLook::As::box: return 0.5 * body.sides.norm();
    case BodyLook::As::link: return body.from.norm();
    default: return 0;
  }
}

Vector3d world(const Placement& at, const Vector3d& arm) { return at.position + at.rotation * arm; }
Point flat(const Vector3d& p) { return {p.x(), p.y()}; }

/// Radius of a bob by its mass, of which the lightest has 1.
double size_of_bob(const SceneLook& look, const BodyLook& bob) {
  double lightest = bob.mass;
  for (const BodyLook& other : look.bodies)
    if (other.as == BodyLook::As::bob) lightest = std::min(lightest, other.mass);
  return std::min(std::cbrt(bob.mass / lightest), 5.0);
}

bool is_in(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

void draw_flat(Canvas& canvas, const SceneLook& look, const Instant& instant, const View& view,
               const Rectangle& frame, const std::vector<int>& marked) {
  const Rectangle seen{view.low.x(), view.low.y(), view.high.x() - view.low.x(), view.high.y() - view.low.y()};
  const Camera camera = fit(seen, frame, 36);
  canvas.look(camera);
  canvas.clip(frame);
  const Point low = camera.to_world({frame.x, frame.y}), high = camera.to_world({frame.right(), frame.top()});
  const int count = static_cast<int>(look.bodies.size());
  const auto body_colours = [&](int i) {
    Look colours = instant[static_cast<std::size_t>(i)].moves ? body_look : fixed_look;
    if (is_in(marked, i)) colours.fill = mix(palette::error, palette::paper, 0.4);
    return colours;
  };
  for (int i = 0; i < count; ++i) {
    const BodyLook& body = look.bodies[static_cast<std::size_t>(i)];
    if (body.as != BodyLook::As::half_space) continue;
    const Placement& at = instant[static_cast<std::size_t>(i)];
    const Point normal = flat(at.rotation * body.sides), along(normal.y(), -normal.x());
    const Point middle = flat(at.position) + along * along.dot(0.5 * (low + high) - flat(at.position));
    const Point half = along * (high - low).norm();
    canvas.ground(middle - half, middle + half);
  }
  for (int i = 0; i < count; ++i) {
    const BodyLook& body = look.bodies[static_cast<std::size_t>(i)];
    const Placement& at = instant[static_cast<std::size_t>(i)];
    const double angle = std::atan2(at.rotation(1, 0), at.rotation(0, 0));
    if (body.as == BodyLook::As::box) canvas.box(flat(at.position), flat(body.sides), angle, body_colours(i));
    if (body.as == BodyLook::As::link)
      canvas.rod(flat(world(at, body.from)), flat(world(at, body.to)), body_colours(i), 12);
    if (body.as == BodyLook::As::disc) {
      canvas.disc(flat(at.position), body.sides.x(), body_colours(i));
      canvas.line(flat(at.position), flat(world(at, {body.sides.x(), 0, 0})), {palette::ink, 1.2});
    }
  }
  const Look rods{palette::constraint, {palette::ink, 0}};
  for (const TieLook& tie : look.ties) {
    const Placement &one = instant[static_cast<std::size_t>(tie.body1)],
                    &two = instant[static_cast<std::size_t>(tie.body2)];
    const Point from = flat(world(one, tie.arm1)), to = flat(world(two, tie.arm2));
    if (tie.as == TieLook::As::surface) {
      const Point along(tie.normal.y(), -tie.normal.x());
      const Point middle = from + along * along.dot(0.5 * (low + high) - from), half = along * (high - low).norm();
      canvas.ground(middle - half, middle + half);
      continue;
    }
    if (tie.as == TieLook::As::rod) canvas.rod(from, to, rods, 6);
    if (tie.as == TieLook::As::spring) canvas.spring(from, to);
    for (const auto& [body, point] : {std::pair{tie.body1, from}, std::pair{tie.body2, to}})
      if (!instant[static_cast<std::size_t>(body)].moves &&
          look.bodies[static_cast<std::size_t>(body)].as == BodyLook::As::nothing)
        canvas.anchor(point);
    if (tie.as == TieLook::As::joint) canvas.hinge(to);
  }
  for (int i = 0; i < count; ++i) {
    const BodyLook& body = look.bodies[static_cast<std::size_t>(i)];
    if (body.as == BodyLook::As::bob)
      canvas.disc(flat(instant[static_cast<std::size_t>(i)].position), 12 * size_of_bob(look, body) / camera.scale,
                  body_colours(i));
  }
  canvas.clip({});
  canvas.look_at_page();
}

void draw_in_space(Canvas& canvas, const SceneLook& look, const Instant& instant, const View& view,
                   const Rectangle& frame, const std::vector<int>& marked) {
  const Vector3d centre = 0.5 * (view.low + view.high);
  const double radius = 0.5 * (view.high - view.low).norm();
  Space space(pictures::from_aside(centre, radius, frame));
  const int count = static_cast<int>(look.bodies.size());
  bool grounded = false;
  for (int i = 0; i < count; ++i) {
    const BodyLook& body = look.bodies[static_cast<std::size_t>(i)];
    const Placement& at = instant[static_cast<std::size_t>(i)];
    const Colour colour = is_in(marked, i) ? mix(palette::error, palette::paper, 0.4)
                          : at.moves       ? palette::body
                                           : palette::fixed;
    const Vector3d normal = at.rotation * body.sides;
    if (body.as == BodyLook::As::half_space && !grounded && normal.y() > 0.99) {
      grounded = true;
      space.ground(Vector3d(centre.x(), at.position.y(), centre.z()), 3 * radius,
                   std::pow(10, std::floor(std::log10(radius))));
    }
    if (body.as == BodyLook::As::disc) space.sphere(at.position, body.sides.x(), colour);
    if (body.as == BodyLook::As::box) space.box(at.position, body.sides, Eigen::Quaterniond(at.rotation), colour);
    if (body.as == BodyLook::As::link) space.rod(world(at, body.from), world(at, body.to), 0.012 * radius, colour);
    if (body.as == BodyLook::As::bob) space.sphere(at.position, 0.02 * radius * size_of_bob(look, body), colour);
  }
  for (const TieLook& tie : look.ties) {
    const Vector3d from = world(instant[static_cast<std::size_t>(tie.body1)], tie.arm1),
                   to = world(instant[static_cast<std::size_t>(tie.body2)], tie.arm2);
    if (tie.as == TieLook::As::joint) {
      space.sphere(to, 0.016 * radius, palette::constraint);
      for (const int body : {tie.body1, tie.body2})
        if (const Placement& at = instant[static_cast<std::size_t>(body)];
            at.moves && (at.position - to).norm() > 0.01 * radius)
          space.rod(at.position, to, 0.008 * radius, palette::body);
    }
    if ((tie.as == TieLook::As::rod || tie.as == TieLook::As::spring) && (to - from).norm() > 1e-9 * radius)
      space.rod(from, to, 0.006 * radius, palette::constraint);
  }
  canvas.draw(space);
}

}  // namespace

SceneLook look_of(const SceneOfAnyModel& any) {
  return std::visit(
      []<class M>(const Scene<M>& scene) {
        SceneLook look{.in_space = M::linear == 3};
        for (int place = 0; place < scene.count(); ++place)
          with_anchors(scene, place, [&](const Anchors<M>& at, TieLook::As as) {
            TieLook tie{as, at.body1, at.body2, arm_of<M>(at.arms.first), arm_of<M>(at.arms.second)};
            if (const auto* contact = scene.template get_if<Contact<M>>(place))
              tie.normal = in_space(contact->normal);
            look.ties.push_back(tie);
          });
        for (int i = 0; i < scene.bodies().size(); ++i) look.bodies.push_back(look_of_body(scene, i, look));
        return look;
      },
      any);
}

View view_of(const SceneLook& look, const std::vector<Instant>& instants) {
  // What flies off is let go: a view is at most three times as large as the first one.
  Eigen::AlignedBox3d first, all;
  for (const Instant& instant : instants) {
    for (std::size_t i = 0; i < look.bodies.size(); ++i) {
      if (look.bodies[i].as == BodyLook::As::half_space || !instant[i].position.allFinite()) continue;
      const double margin = reach(look.bodies[i]);
      all.extend(instant[i].position - Vector3d::Constant(margin));
      all.extend(instant[i].position + Vector3d::Constant(margin));
    }
    if (first.isEmpty()) first = all;
  }
  if (all.isEmpty()) return {Vector3d::Constant(-1), Vector3d::Constant(1)};
  const double size = std::max(first.sizes().maxCoeff(), 0.1);
  const Vector3d most = Vector3d::Constant(size);
  View view{all.min().cwiseMax(first.min() - most), all.max().cwiseMin(first.max() + most)};
  const Vector3d least = 0.1 * most;  // of something that only hangs there
  view.low -= least, view.high += least;
  return view;
}

void draw(Canvas& canvas, const SceneLook& look, const Instant& instant, const View& view, const Rectangle& frame,
          const std::vector<int>& marked) {
  look.in_space ? draw_in_space(canvas, look, instant, view, frame, marked)
                : draw_flat(canvas, look, instant, view, frame, marked);
}

}  // namespace byhand::stage
