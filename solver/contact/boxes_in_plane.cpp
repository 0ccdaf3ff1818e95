#include "solver/contact/boxes_in_plane.hpp"

#include <algorithm>
#include <cmath>

// Among the four face normals of two boxes is the direction of the least translation that parts them (separating
// axis). The face whose normal it is, the reference, then trims the other box's face that looks at it, the
// incident one; what remains of that touches.
//
// Scalars rather than vectors and matrices: this is the inner loop of every pile, and what the two rotations
// have in common is one cosine and one sine.
namespace byhand {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point in the frame of the reference face: `out` along its normal, `along` its tangent, the normal turned by
/// +90°, from the centre of the reference box [m].
struct Point {
  double out, along;
};

/// Faces are numbered +x, +y, −x, −y; corner i ends face i and begins face i + 1.
struct End {
  Point at;
  int corner;
};

/// The reference face and the incident face as the reference box sees them. Ends come in order of `along`.
struct Faces {
  End reference[2], incident[2];
  double slope;               // of the incident face: change of `out` per `along`
  double normal_x, normal_y;  // of the reference face, in the world
};

/// How one box sees the other.
struct View {
  const Pose<PlaneBody>* pose;  // of the box that looks
  const double *half, *other_half;
  double x, y;      // the other's centre in the axes of this one [m]
  double cos, sin;  // the other's turn against this one
};

/// `axis` of the box that looks, in the direction of the other's centre, gives the reference face.
Faces faces(const View& see, int axis) {
  const double centre = axis == 0 ? see.x : see.y, side = centre < 0 ? -1 : 1;
  const auto in_face = [&](double x, double y) {
    return axis == 0 ? Point{side * x, side * y} : Point{side * y, -side * x};
  };
  const int reference = axis + (side < 0 ? 2 : 0);
  const double out = see.half[axis], along = see.half[1 - axis];

  const Point x_axis = in_face(see.cos, see.sin), y_axis = in_face(-see.sin, see.cos);
  const int other_axis = std::abs(x_axis.out) >= std::abs(y_axis.out) ? 0 : 1;
  Point normal = other_axis == 0 ? x_axis : y_axis;
  const int incident = other_axis + (normal.out > 0 ? 2 : 0);
  if (normal.out > 0) normal = {-normal.out, -normal.along};
  const double other_out = see.other_half[other_axis], other_along = see.other_half[1 - other_axis];
  const Point middle = in_face(see.x, see.y);
  const Point face = {middle.out + normal.out * other_out, middle.along + normal.along * other_out};
  // The incident face looks back, so its own tangent points down `along`, and its last corner comes first.
  const Point half_side = {normal.along * other_along, -normal.out * other_along};

  const auto& turn = see.pose->rotation;
  return {{{{out, -along}, (reference + 3) % 4}, {{out, along}, reference}},
          {{{face.out - half_side.out, face.along - half_side.along}, incident},
           {{face.out + half_side.out, face.along + half_side.along}, (incident + 3) % 4}},
          -normal.along / normal.out,
          axis == 0 ? side * turn.cos : -side * turn.sin,
          axis == 0 ? side * turn.sin : side * turn.cos};
}

/// Writes down what touches, for a normal from the reference box to the other.
struct Writer {
  const Pose<PlaneBody>& pose;  // of the reference box
  bool reference_is_second;
  double margin;
  Manifold<PlaneBody>& manifold;

  void set_normal(double x, double y) {
    manifold.normal = reference_is_second ? Eigen::Vector2d(-x, -y) : Eigen::Vector2d(x, y);
  }
  /// `separation` is along the normal; a touch is named by the two corners that bound it, whichever cut it.
  void add(const Faces& faces, const End& reference, const End& incident, double separation) {
    if (!(separation <= margin)) return;
    TouchPoint<PlaneBody>& point = manifold.points[manifold.size++];
    Eigen::Vector2d &p = reference_is_second ? point.p2 : point.p1, &q = reference_is_second ? point.p1 : point.p2;
    p = in_world(faces, reference.at);
    q = in_world(faces, incident.at);
    point.separation = separation;
    point.feature =
        reference_is_second ? incident.corner + 4 * reference.corner : reference.corner + 4 * incident.corner;
  }

 private:
  Eigen::Vector2d in_world(const Faces& faces, const Point& point) const {
    return {pose.position.x() + faces.normal_x * point.out - faces.normal_y * point.along,
            pose.position.y() + faces.normal_y * point.out + faces.normal_x * point.along};
  }
};

/// Corner against corner, when the boxes are apart and nothing is nearer: true if that is so. `nearest` is the
/// least separation of the trimmed face, infinite if nothing remained of it.
bool write_corners(const Faces& faces, double nearest, Writer& writer) {
  // Eight degrees between two faces make one per cent: below that two points along a face serve better than one
  // corner.
  constexpr double clearly = 0.99;
  const End *reference = nullptr, *incident = nullptr;
  double least = clearly * nearest;
  for (const End& end : faces.incident) {
    const End& corner = faces.reference[end.at.along > 0];
    if (std::abs(end.at.along) <= std::abs(corner.at.along)) continue;  // it looks at the face, not at its corner
    const double out = end.at.out - corner.at.out, along = end.at.along - corner.at.along;
    const double distance = std::sqrt(out * out + along * along);
    if (distance < least) least = distance, reference = &corner, incident = &end;
  }
  if (!reference) return false;
  const double out = incident->at.out - reference->at.out, along = incident->at.along - reference->at.along;
  if (out > 0 && least > 1e-12) {
    writer.set_normal((faces.normal_x * out - faces.normal_y * along) / least,
                      (faces.normal_y * out + faces.normal_x * along) / least);
    writer.add(faces, *reference, *incident, least);
  } else {
    writer.add(faces, *reference, *incident, out);  // they just touch, along the normal of the face
  }
  return true;
}

/// False, with nothing written, if nothing of the incident face is as near as `enough`.
bool write(const Faces& faces, Writer writer, double enough) {
  const auto& [first, last] = faces.incident;
  End trimmed[2] = {first, last};
  const double along = faces.reference[1].at.along;
  if (first.at.along < -along) trimmed[0].at = {first.at.out - (first.at.along + along) * faces.slope, -along};
  if (last.at.along > along) trimmed[1].at = {last.at.out - (last.at.along - along) * faces.slope, along};

  writer.set_normal(faces.normal_x, faces.normal_y);
  const double face = faces.reference[0].at.out;
  const bool empty = trimmed[0].at.along > trimmed[1].at.along;
  const double nearest = empty ? infinity : std::min(trimmed[0].at.out, trimmed[1].at.out) - face;
  if (nearest > enough) return false;
  if (nearest > 0 && write_corners(faces, nearest, writer)) return true;
  const int count = trimmed[0].at.along < trimmed[1].at.along ? 2 : 1;
  for (int i = 0; i < count; ++i)
    writer.add(faces, {{face, trimmed[i].at.along}, faces.reference[i].corner}, trimmed[i],
               trimmed[i].at.out - face);
  return true;
}

}  // namespace

Manifold<PlaneBody> touch_boxes(const Box<PlaneBody>& box1, const Pose<PlaneBody>& pose1,
                                const Box<PlaneBody>& box2, const Pose<PlaneBody>& pose2, double margin,
                                std::uint32_t hint) {
  const auto &a = pose1.rotation, &b = pose2.rotation;
  const double cos = a.cos * b.cos + a.sin * b.sin, sin = a.cos * b.sin - a.sin * b.cos;
  const double dx = pose2.position.x() - pose1.position.x(), dy = pose2.position.y() - pose1.position.y();
  const Linear<PlaneBody> half1 = box1.half(), half2 = box2.half();
  const View sees[2] = {
      {&pose1, half1.data(), half2.data(), a.cos * dx + a.sin * dy, a.cos * dy - a.sin * dx, cos, sin},
      {&pose2, half2.data(), half1.data(), -b.cos * dx - b.sin * dy, b.sin * dx - b.cos * dy, cos, -sin}};

  double gap[4];  // along x and y of the first box, then of the second
  const double c = std::abs(cos), s = std::abs(sin);
  for (int i = 0; i < 2; ++i) {
    const auto& see = sees[i];
    gap[2 * i] = std::abs(see.x) - see.half[0] - (c * see.other_half[0] + s * see.other_half[1]);
    gap[2 * i + 1] = std::abs(see.y) - see.half[1] - (s * see.other_half[0] + c * see.other_half[1]);
  }
  const int first = gap[1] > gap[0] ? 1 : 0, second = gap[3] > gap[2] ? 3 : 2;
  // A draw goes to the box further right, so that it falls alike whichever box is called the first.
  const bool further = dx > 0 || (dx == 0 && dy > 0);
  const int best = gap[second] > gap[first] || (gap[second] == gap[first] && further) ? second : first;

  Manifold<PlaneBody> manifold;
  if (!(gap[best] <= margin)) return manifold;
  const auto write_with = [&](int reference, double enough) {
    const View& see = sees[reference / 2];
    manifold.reference = reference + 1;
    return write(faces(see, reference % 2), {*see.pose, reference >= 2, margin, manifold}, enough);
  };
  const bool overlap = gap[best] <= 0;
  const int hinted = static_cast<int>(hint) - 1;
  const bool keeps = 0 <= hinted && hinted < 4 && hinted != best &&
                     gap[hinted] > gap[best] - reference_hysteresis && (overlap || gap[hinted] > 0);
  if (!keeps || !write_with(hinted, overlap ? std::min(0.0, gap[best] + reference_hysteresis) : infinity))
    write_with(best, infinity);
  return manifold;
}

}  // namespace byhand
