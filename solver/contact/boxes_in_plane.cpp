#include <algorithm>
#include <cmath>

#include "solver/contact/manifold.hpp"

// Separating axes: the normal is one of the four face normals of the two boxes. The face that gives it is the
// reference face. The face of the other box that is turned towards it, the incident face, is clipped to its ends;
// what remains are the contact points.
//
// Scalars rather than vectors and matrices: this is the inner loop of every pile, and both rotations need one
// cosine and one sine.
namespace byhand {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point in the frame of the reference face: `out` along its normal, `along` its tangent, the normal turned by
/// +90°, from the centre of the reference box [m].
struct Point {
  double out, along;
};

/// An end of a face. Faces are numbered +x, +y, −x, −y; corner i ends face i and begins face i + 1.
struct End : Point {
  int corner;
};

/// The other box in the axes of this one.
struct View {
  const Pose<PlaneBody>& pose;  // of this box
  const double *half, *other_half;
  double x, y;      // the other's centre [m]
  double cos, sin;  // the other's rotation
  bool second;      // whether this box is the second
  double margin;
};

struct Faces {
  End reference[2], incident[2];  // in order of `along`
  double slope;                   // of the incident face: change of `out` per `along`
  double normal_x, normal_y;      // of the reference face, in the world
  const View& view;               // from the reference box

  /// Adds a point within the margin. Its feature is the pair of the two ends' corners, whichever cut which.
  void add(const End& on_reference, const End& on_incident, double separation,
           Manifold<PlaneBody>& manifold) const {
    if (!(separation <= view.margin)) return;
    const End &end1 = view.second ? on_incident : on_reference, &end2 = view.second ? on_reference : on_incident;
    manifold.add(
        {in_world(end1), in_world(end2), separation, static_cast<std::uint32_t>(end1.corner + 4 * end2.corner)});
  }
  Eigen::Vector2d in_world(const Point& point) const {
    return {view.pose.position.x() + normal_x * point.out - normal_y * point.along,
            view.pose.position.y() + normal_y * point.out + normal_x * point.along};
  }
};

/// The reference face is the one on `axis` of the view's box that is turned towards the other box.
Faces faces(const View& view, int axis) {
  const double centre = axis == 0 ? view.x : view.y, side = centre < 0 ? -1 : 1;
  const auto in_face = [&](double x, double y) {
    return axis == 0 ? Point{side * x, side * y} : Point{side * y, -side * x};
  };
  const int reference = axis + (side < 0 ? 2 : 0);
  const double out = view.half[axis], along = view.half[1 - axis];

  const Point x_axis = in_face(view.cos, view.sin), y_axis = in_face(-view.sin, view.cos);
  const int other_axis = std::abs(x_axis.out) >= std::abs(y_axis.out) ? 0 : 1;
  Point normal = other_axis == 0 ? x_axis : y_axis;
  const int incident = other_axis + (normal.out > 0 ? 2 : 0);
  if (normal.out > 0) normal = {-normal.out, -normal.along};
  const double other_out = view.other_half[other_axis], other_along = view.other_half[1 - other_axis];
  const Point middle = in_face(view.x, view.y);
  const Point face = {middle.out + normal.out * other_out, middle.along + normal.along * other_out};
  // The tangent of the incident face points against `along`, so its last corner comes first.
  const Point half_side = {normal.along * other_along, -normal.out * other_along};

  const auto& turn = view.pose.rotation;
  return {{{{out, -along}, (reference + 3) % 4}, {{out, along}, reference}},
          {{{face.out - half_side.out, face.along - half_side.along}, incident},
           {{face.out + half_side.out, face.along + half_side.along}, (incident + 3) % 4}},
          -normal.along / normal.out,
          axis == 0 ? side * turn.cos : -side * turn.sin,
          axis == 0 ? side * turn.sin : side * turn.cos,
          view};
}

/// Adds the point between two corners of separate boxes if they are clearly nearer than `nearest`, the least
/// separation of the clipped face. Returns whether it did.
bool add_corners(const Faces& faces, double nearest, Manifold<PlaneBody>& manifold) {
  // 1 % is an angle of eight degrees between the faces; below that, two points along a face are better than one.
  constexpr double clearly = 0.99;
  const End *reference = nullptr, *incident = nullptr;
  double least = clearly * nearest;
  for (const End& end : faces.incident) {
    const End& corner = faces.reference[end.along > 0];
    if (std::abs(end.along) <= std::abs(corner.along)) continue;  // nearest to the face, not to its corner
    const double out = end.out - corner.out, along = end.along - corner.along;
    const double distance = std::sqrt(out * out + along * along);
    if (distance < least) least = distance, reference = &corner, incident = &end;
  }
  if (!reference) return false;
  const double out = incident->out - reference->out, along = incident->along - reference->along;
  const bool apart =
      out > 0 && least > 1e-12 * faces.view.half[0];  // else they just touch, and the face's normal serves
  if (apart)
    manifold.normal = {(faces.normal_x * out - faces.normal_y * along) / least,
                       (faces.normal_y * out + faces.normal_x * along) / least};
  faces.add(*reference, *incident, apart ? least : out, manifold);
  return true;
}

/// Clips the incident face and adds its points; the normal points out of the reference box. Adds no point and
/// returns false if none is as near as `enough` [m].
bool add_points(const Faces& faces, double enough, Manifold<PlaneBody>& manifold) {
  const auto& [first, last] = faces.incident;
  const double face = faces.reference[1].out, along = faces.reference[1].along;
  End clipped[2] = {first, last};
  if (first.along < -along) clipped[0] = {{first.out - (first.along + along) * faces.slope, -along}, first.corner};
  if (last.along > along) clipped[1] = {{last.out - (last.along - along) * faces.slope, along}, last.corner};

  manifold.normal = {faces.normal_x, faces.normal_y};
  const bool empty = clipped[0].along > clipped[1].along;
  const double nearest = empty ? infinity : std::min(clipped[0].out, clipped[1].out) - face;
  if (nearest > enough) return false;
  if (nearest > 0 && add_corners(faces, nearest, manifold)) return true;
  const int count = clipped[0].along < clipped[1].along ? 2 : 1;
  for (int i = 0; i < count; ++i)
    faces.add({{face, clipped[i].along}, faces.reference[i].corner}, clipped[i], clipped[i].out - face, manifold);
  return true;
}

}  // namespace

Manifold<PlaneBody> collide_boxes(const Box<PlaneBody>& box1, const Pose<PlaneBody>& pose1,
                                  const Box<PlaneBody>& box2, const Pose<PlaneBody>& pose2, double margin,
                                  std::uint32_t hint) {
  const auto &a = pose1.rotation, &b = pose2.rotation;
  const double cos = a.cos * b.cos + a.sin * b.sin, sin = a.cos * b.sin - a.sin * b.cos;
  const double dx = pose2.position.x() - pose1.position.x(), dy = pose2.position.y() - pose1.position.y();
  const Linear<PlaneBody> half1 = box1.half(), half2 = box2.half();
  const View views[2] = {{pose1, half1.data(), half2.data(), a.cos * dx + a.sin * dy, a.cos * dy - a.sin * dx, cos,
                          sin, false, margin},
                         {pose2, half2.data(), half1.data(), -b.cos * dx - b.sin * dy, b.sin * dx - b.cos * dy,
                          cos, -sin, true, margin}};

  double separation[4];  // along x and y of the first box, then of the second
  const double c = std::abs(cos), s = std::abs(sin);
  for (int i = 0; i < 2; ++i) {
    const auto& view = views[i];
    separation[2 * i] = std::abs(view.x) - view.half[0] - (c * view.other_half[0] + s * view.other_half[1]);
    separation[2 * i + 1] = std::abs(view.y) - view.half[1] - (s * view.other_half[0] + c * view.other_half[1]);
  }
  const int first = separation[1] > separation[0] ? 1 : 0, second = separation[3] > separation[2] ? 3 : 2;
  // A tie goes to the box further right, whichever of the two is called the first.
  const bool further = dx > 0 || (dx == 0 && dy > 0);
  const int best = separation[second] > separation[first] || (separation[second] == separation[first] && further)
                       ? second
                       : first;

  Manifold<PlaneBody> manifold;
  if (!(separation[best] <= margin)) return manifold;
  const auto add_with = [&](int reference, double enough) {
    manifold.reference = reference + 1;
    return add_points(faces(views[reference / 2], reference % 2), enough, manifold);
  };
  const bool overlap = separation[best] <= 0;
  const double least_gain = hysteresis(box1, box2);
  const int hinted = static_cast<int>(hint) - 1;
  const bool keeps = 0 <= hinted && hinted < 4 && hinted != best &&
                     separation[hinted] > separation[best] - least_gain && (overlap || separation[hinted] > 0);
  if (!keeps || !add_with(hinted, overlap ? std::min(0.0, separation[best] + least_gain) : infinity))
    add_with(best, infinity);
  if (manifold.reference > 2) manifold.normal = -manifold.normal;
  return manifold;
}

}  // namespace byhand
