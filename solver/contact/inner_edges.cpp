#include "solver/contact/inner_edges.hpp"

#include <algorithm>
#include <optional>

#include "solver/contact/contact_manager.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Of the margin: what rises by less lies flush.
constexpr double flush = 0.05;
/// Normals that include less than a few degrees are one: a box that rests on two tiles may tilt a little. A ball
/// may not: near the end of a tile its normal differs little.
constexpr double same_direction = 0.995;

/// A plane through a face: x · normal = height.
template <class M>
struct Face {
  Linear<M> normal;
  double height;
};

/// The face of a shape whose outward normal is nearly `normal`; balls and corners have none.
template <class M>
std::optional<Face<M>> face_along(const Shape<M>& shape, const Pose<M>& pose, const Linear<M>& normal) {
  Face<M> face{Linear<M>::Zero(), 0};
  if (const auto* half_space = std::get_if<HalfSpace<M>>(&shape)) {
    face.normal = detail::turned<M>(pose, half_space->normal);
  } else if (const auto* box = std::get_if<Box<M>>(&shape)) {
    const auto axes = detail::axes<M>(pose);
    int axis;
    const Linear<M> along = axes.transpose() * normal;
    along.cwiseAbs().maxCoeff(&axis);
    face = {axes.col(axis) * (along[axis] < 0 ? -1 : 1), box->half()[axis]};
  }
  if (face.normal.dot(normal) < same_direction) return {};
  face.height += face.normal.dot(pose.position);
  return face;
}

/// How far a shape reaches along a direction.
template <class M>
double height_along(const Shape<M>& shape, const Pose<M>& pose, const Linear<M>& up) {
  double extent = std::numeric_limits<double>::infinity();
  if (const auto* ball = std::get_if<Ball<M>>(&shape)) extent = ball->radius;
  if (const auto* box = std::get_if<Box<M>>(&shape))
    extent = (detail::axes<M>(pose).transpose() * up).cwiseAbs().dot(box->half());
  return up.dot(pose.position) + extent;
}

}  // namespace

template <class M>
void InnerEdges<M>::drop(const Scene<M>& scene, std::vector<ContactPair<M>>& pairs) {
  const Bodies<M>& bodies = scene.bodies();
  const std::vector<Shape<M>>& shapes = scene.colliders().shapes;
  supports_.clear();
  for (int i = 0; i < std::ssize(pairs); ++i) {
    const auto [first, second] = pairs[i].bodies;
    if (moves(bodies.inverse_mass[second])) supports_.push_back({second, first, i, pairs[i].normal});
    if (moves(bodies.inverse_mass[first])) supports_.push_back({first, second, i, -pairs[i].normal});
  }
  const auto by_body = [](const Support& a, const Support& b) {
    return std::pair(a.body, a.pair) < std::pair(b.body, b.pair);
  };
  if (!std::is_sorted(supports_.begin(), supports_.end(), by_body))
    std::sort(supports_.begin(), supports_.end(), by_body);

  const auto hides = [&](const Support& floor, const Support& corner) {
    if (!std::holds_alternative<Ball<M>>(shapes[corner.body]) && floor.normal.dot(corner.normal) >= same_direction)
      return false;
    const auto face = face_along<M>(shapes[floor.ground], bodies.pose[floor.ground], floor.normal);
    // A ball beside a seam is above one tile's face and another's edge: the former hides the latter only.
    return face && (floor.normal - face->normal).squaredNorm() < (corner.normal - face->normal).squaredNorm() &&
           height_along<M>(shapes[corner.ground], bodies.pose[corner.ground], face->normal) <=
               face->height + flush * scene.colliders().margin;
  };
  bool any = false;
  for (auto begin = supports_.begin(); begin != supports_.end();) {
    const auto end = std::find_if(begin, supports_.end(), [&](const Support& s) { return s.body != begin->body; });
    for (auto corner = begin; corner != end; ++corner)
      if (std::any_of(begin, end, [&](const Support& floor) { return hides(floor, *corner); })) {
        pairs[corner->pair].size = 0;
        any = true;
      }
    begin = end;
  }
  if (any) std::erase_if(pairs, [](const ContactPair<M>& pair) { return pair.size == 0; });
}

#define BYHAND_INSTANTIATE(M) template class InnerEdges<M>
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
