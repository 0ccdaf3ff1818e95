#include "solver/contact/boxes_in_space.hpp"

#include <algorithm>
#include <cmath>

// The direction of the least translation that parts two boxes is one of fifteen: a face normal, or at right angles
// to an edge of each. A face trims the other box's face that looks at it, and what remains of that touches; two
// edges touch where they cross. Boxes that are apart may also be nearest at edges that do neither.
namespace byhand {
namespace {

using Eigen::Vector3d, Eigen::Matrix3d;

/// Several points along a face serve better than one at an edge that is hardly nearer.
constexpr double clearly = 0.99;

struct Solid {
  Vector3d centre;
  Matrix3d axes;  // as columns
  Vector3d half;
};

int face_number(int axis, bool negative) { return axis + 3 * negative; }

struct Corner {
  Vector3d at;  // in the axes of the reference box
  int side;     // the face behind the polygon's edge that begins here, as the first box numbers it
};

/// Four corners and four cuts make eight; rounding could make every cut yield half as many again.
struct Polygon {
  std::array<Corner, 20> corners;
  int size = 0;

  void add(const Corner& corner) { corners[size++] = corner; }
  const Corner& operator[](int i) const { return corners[i]; }
  const Corner& before(int i) const { return corners[(i + size - 1) % size]; }
};

/// What of the polygon has `direction` · x <= `reach`; the cut edge belongs to `side`.
Polygon trimmed(const Polygon& polygon, const Vector3d& direction, double reach, int side) {
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size];
    const double beyond_a = direction.dot(a.at) - reach, beyond_b = direction.dot(b.at) - reach;
    if (beyond_a <= 0) result.add(a);
    if ((beyond_a <= 0) != (beyond_b <= 0))
      result.add({a.at + (b.at - a.at) * (beyond_a / (beyond_a - beyond_b)), beyond_a <= 0 ? side : a.side});
  }
  return result;
}

/// At most four of the corners that hold nearly all of the area: the deepest, the one furthest from it, the one
/// furthest from the line between, and the one furthest outside this triangle. Differences below `level` [m] count
/// for nothing, so that the choice lasts; above them, a corner of a box goes before a crossing of like edges.
struct Choice {
  std::array<int, 4> corners;
  int size;
};
Choice at_most_four(const Polygon& polygon, const Vector3d& out) {
  if (polygon.size <= 4) return {{0, 1, 2, 3}, polygon.size};
  constexpr double level = 1e-4;
  const auto best = [&](auto&& distance) {
    const auto score = [&](int i) {
      const bool crossing = polygon.before(i).side == polygon[i].side;
      return distance(polygon[i].at) - (crossing ? 2 * level : 0);
    };
    int chosen = 0;
    for (int i = 1; i < polygon.size; ++i)
      if (score(i) > score(chosen) + level) chosen = i;
    return chosen;
  };
  const auto left_of = [&](const Vector3d& from, const Vector3d& to) -> Vector3d {
    return out.cross(to - from).normalized();
  };
  const int deepest = best([&](const Vector3d& p) { return -out.dot(p); });
  const Vector3d a = polygon[deepest].at;
  const int furthest = best([&](const Vector3d& p) { return (p - a).norm(); });
  const Vector3d b = polygon[furthest].at, across = left_of(a, b);
  const int aside = best([&](const Vector3d& p) { return std::abs(across.dot(p - a)); });
  const Vector3d c = polygon[aside].at;
  const double turn = across.dot(c - a) > 0 ? -1 : 1;  // outwards of the triangle
  const int outside = best([&, bc = left_of(b, c), ca = left_of(c, a)](const Vector3d& p) {
    return std::max({turn * across.dot(p - a), turn * bc.dot(p - b), turn * ca.dot(p - c)});
  });
  return {{deepest, furthest, aside, outside}, 4};
}

/// An edge by its middle, direction and half length. In all, number = 4 axis + two bits for the sides of the other
/// axes.
struct Edge {
  Vector3d middle, direction;
  double half;
  int number;

  Vector3d at(double s) const { return middle + s * direction; }
  /// 0–11 for the edge, 12–19 for the corners of the box that are its ends.
  int feature_at(double s) const {
    if (std::abs(s) < half) return number;
    const int axis = number / 4, side[2] = {number & 1, number >> 1 & 1};
    return 12 + ((s < 0) << axis | side[0] << (axis + 1) % 3 | side[1] << (axis + 2) % 3);
  }
};
Edge edge(const Solid& box, int number) {
  const int axis = number / 4, j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double sj = number & 1 ? -1 : 1, sk = number & 2 ? -1 : 1;
  return {box.centre + sj * box.half[j] * box.axes.col(j) + sk * box.half[k] * box.axes.col(k), box.axes.col(axis),
          box.half[axis], number};
}

/// A point on each surface and what they lie on.
struct Meeting {
  Vector3d p1, p2;
  std::uint32_t feature;
};

/// Where two edges are nearest (C. Ericson, Real-Time Collision Detection, 2005, 5.1.9). Features begin beyond
/// those of faces.
Meeting nearest(const Edge& a, const Edge& b) {
  const Vector3d d = a.middle - b.middle;
  const double cos = a.direction.dot(b.direction), da = a.direction.dot(d), db = b.direction.dot(d);
  const double sin2 = 1 - cos * cos;
  double s = sin2 > 1e-12 ? std::clamp((cos * db - da) / sin2, -a.half, a.half) : 0;
  const double t = std::clamp(cos * s + db, -b.half, b.half);
  s = std::clamp(cos * t - da, -a.half, a.half);
  return {a.at(s), b.at(t), 256u + 20u * a.feature_at(s) + b.feature_at(t)};
}

/// Two boxes as they stand.
struct Boxes {
  Solid first, second;
  Matrix3d turn;  // the second's axes in the first's, as columns
  double margin;

  Vector3d apart() const { return second.centre - first.centre; }
};

/// `nearest` is the least separation [m] of the points, those beyond the margin too.
struct Touches {
  double nearest = std::numeric_limits<double>::infinity();
  Manifold<SpaceBody> manifold;
};

/// Faces 0–2 are the first box's, 3–5 the second's.
Touches touch_face(const Boxes& boxes, int reference) {
  const bool second = reference >= 3;
  const Solid &box = second ? boxes.second : boxes.first, &other = second ? boxes.first : boxes.second;
  const Matrix3d turn = second ? Matrix3d(boxes.turn.transpose()) : boxes.turn;
  const Vector3d centre = box.axes.transpose() * (other.centre - box.centre);
  const int axis = reference % 3;
  const double side = centre[axis] < 0 ? -1 : 1;
  const Vector3d out = side * Vector3d::Unit(axis);

  int facing;
  turn.row(axis).cwiseAbs().maxCoeff(&facing);
  const double facing_side = turn(axis, facing) * side > 0 ? -1 : 1;
  const int sides[2] = {(axis + 1) % 3, (axis + 2) % 3}, in_face[2] = {(facing + 1) % 3, (facing + 2) % 3};

  // Names must not depend on which box is the reference, nor on which of two edges on top of each other cuts:
  // every edge is named by the side of the first box that looks its way.
  const auto like = [&](int i, int j) {
    return std::abs(turn(sides[0], in_face[i]) * turn(sides[1], in_face[j]));
  };
  const bool crosswise = like(1, 0) > like(0, 1);
  const int face1 = second ? face_number(facing, facing_side < 0) : face_number(axis, side < 0);
  const auto name_of_side = [&](int i, double s) {
    if (!second) return face_number(sides[i], s < 0);
    const int like_it = in_face[crosswise ? 1 - i : i];
    return face_number(like_it, s * turn(sides[i], like_it) < 0);
  };
  const auto name_of_edge = [&](int i, double s) {
    if (second) return face_number(in_face[i], s < 0);
    const int like_it = sides[crosswise ? 1 - i : i];
    return face_number(like_it, s * turn(like_it, in_face[i]) < 0);
  };

  Polygon polygon;
  const Vector3d middle = centre + facing_side * other.half[facing] * turn.col(facing);
  for (const auto& [s, t] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    const Vector3d a = s * turn.col(in_face[0]), b = t * turn.col(in_face[1]);
    // Going round, the edge that begins at (+, +) lies on the second axis's side, the next on the first's.
    polygon.add({middle + other.half[in_face[0]] * a + other.half[in_face[1]] * b,
                 s == t ? name_of_edge(1, t) : name_of_edge(0, s)});
  }
  for (const int i : {0, 1})
    for (const double s : {1, -1})
      polygon = trimmed(polygon, s * Vector3d::Unit(sides[i]), box.half[sides[i]], name_of_side(i, s));

  Touches result;
  result.manifold.reference = reference + 1;
  const Vector3d n = box.axes * out;
  result.manifold.normal = second ? Vector3d(-n) : n;
  const Choice choice = at_most_four(polygon, out);
  for (int k = 0; k < choice.size; ++k) {
    const int i = choice.corners[k];
    const Corner& corner = polygon[i];
    const double separation = side * corner.at[axis] - box.half[axis];
    result.nearest = std::min(result.nearest, separation);
    if (!(separation <= boxes.margin)) continue;
    const Vector3d q = box.centre + box.axes * corner.at, p = q - separation * n;
    int from = polygon.before(i).side, to = corner.side;
    if (second == (facing_side > 0)) std::swap(from, to);  // as seen from the first box
    const std::uint32_t feature = (face1 * 6 + from) * 6 + to;
    result.manifold.add({second ? q : p, second ? p : q, separation, feature});
  }
  return result;
}

Touches one_point(const Boxes& boxes, const Vector3d& n, const Meeting& meeting, std::uint32_t reference) {
  Touches result;
  result.nearest = n.dot(meeting.p2 - meeting.p1);
  result.manifold.normal = n;
  result.manifold.reference = reference;
  if (result.nearest <= boxes.margin)
    result.manifold.add({meeting.p1, meeting.p2, result.nearest, meeting.feature});
  return result;
}

/// Where edges along axis i of the first box and axis j of the second cross.
Touches touch_edges(const Boxes& boxes, int i, int j) {
  Vector3d n = boxes.first.axes.col(i).cross(boxes.second.axes.col(j)).normalized();
  if (n.dot(boxes.apart()) < 0) n = -n;
  const auto furthest = [](const Solid& box, int axis, const Vector3d& direction) {
    const auto behind = [&](int k) { return direction.dot(box.axes.col(k % 3)) < 0; };
    return 4 * axis + behind(axis + 1) + 2 * behind(axis + 2);
  };
  const Edge edge1 = edge(boxes.first, furthest(boxes.first, i, n)),
             edge2 = edge(boxes.second, furthest(boxes.second, j, -n));
  return one_point(boxes, n, nearest(edge1, edge2), 7 + 3 * i + j);
}

/// The nearest edges of boxes that are apart, if they are nearer than `limit`; `otherwise` if not.
Touches nearest_edges(const Boxes& boxes, double limit, const Touches& otherwise) {
  Meeting best{{}, {}, 0};
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      const Meeting meeting = nearest(edge(boxes.first, i), edge(boxes.second, j));
      const double distance = (meeting.p2 - meeting.p1).norm();
      if (distance < limit) limit = distance, best = meeting;
    }
  if (best.feature == 0) return otherwise;
  const Vector3d n = limit > 1e-12 ? Vector3d((best.p2 - best.p1) / limit) : otherwise.manifold.normal;
  return one_point(boxes, n, best, otherwise.manifold.reference);
}

/// By how much each of the fifteen directions parts the boxes [m]: faces as in `touch_face`, then 6 + 3i + j for
/// edge i of the first and j of the second.
std::array<double, 15> gaps(const Boxes& boxes) {
  const Matrix3d& turn = boxes.turn;
  const Matrix3d size = turn.cwiseAbs();
  const Vector3d &h1 = boxes.first.half, &h2 = boxes.second.half;
  const Vector3d to2 = boxes.first.axes.transpose() * boxes.apart(),
                 to1 = boxes.second.axes.transpose() * boxes.apart();
  const Vector3d of1 = to2.cwiseAbs() - h1 - size * h2, of2 = to1.cwiseAbs() - h2 - size.transpose() * h1;

  std::array<double, 15> gap;
  for (int i = 0; i < 3; ++i) gap[i] = of1[i], gap[3 + i] = of2[i];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double sin2 = turn(i1, j) * turn(i1, j) + turn(i2, j) * turn(i2, j);
      const double reach =
          h1[i1] * size(i2, j) + h1[i2] * size(i1, j) + h2[j1] * size(i, j2) + h2[j2] * size(i, j1);
      // Parallel edges have no direction of their own.
      gap[6 + 3 * i + j] =
          sin2 < 1e-8 ? -std::numeric_limits<double>::infinity()
                      : (std::abs(to2[i2] * turn(i1, j) - to2[i1] * turn(i2, j)) - reach) / std::sqrt(sin2);
    }
  return gap;
}

Touches touch_reference(const Boxes& boxes, int reference) {
  return reference < 6 ? touch_face(boxes, reference)
                       : touch_edges(boxes, (reference - 6) / 3, (reference - 6) % 3);
}

}  // namespace

Manifold<SpaceBody> touch_boxes(const Box<SpaceBody>& box1, const Pose<SpaceBody>& pose1,
                                const Box<SpaceBody>& box2, const Pose<SpaceBody>& pose2, double margin,
                                std::uint32_t hint) {
  Boxes boxes{{pose1.position, detail::axes<SpaceBody>(pose1), box1.half()},
              {pose2.position, detail::axes<SpaceBody>(pose2), box2.half()},
              {},
              margin};
  boxes.turn = boxes.first.axes.transpose() * boxes.second.axes;
  const auto gap = gaps(boxes);
  const auto largest = [&](int from, int to) {
    return static_cast<int>(std::max_element(gap.begin() + from, gap.begin() + to) - gap.begin());
  };
  // A draw goes to the box further right, so that it falls alike whichever box is called the first.
  const int first = largest(0, 3), second = largest(3, 6), best = largest(0, 15);
  const Vector3d apart = boxes.apart();
  const bool further = apart.x() > 0 || (apart.x() == 0 && (apart.y() > 0 || (apart.y() == 0 && apart.z() > 0)));
  const int face = gap[second] > gap[first] || (gap[second] == gap[first] && further) ? second : first;
  if (!(gap[best] <= margin)) return {};

  // Faces touch at more points than edges, so they come first; taken is what first shows the boxes as near as they
  // are.
  const bool overlap = gap[best] <= 0;
  Touches touches;
  for (const int reference : {static_cast<int>(hint) - 1, face, largest(6, 15)}) {
    if (reference < 0 || reference >= (overlap ? 15 : 6)) continue;
    if (gap[reference] < gap[best] - reference_hysteresis) continue;
    touches = touch_reference(boxes, reference);
    if (overlap ? touches.nearest <= std::min(0.0, gap[best] + reference_hysteresis)
                : clearly * touches.nearest <= gap[best])
      return touches.manifold;
  }
  const double limit = clearly * touches.nearest;
  if (touches.manifold.reference == 0)
    touches = touch_reference(boxes, best);  // for its normal, should edges meet
  return nearest_edges(boxes, limit, touches).manifold;
}

}  // namespace byhand
