#include <algorithm>
#include <cmath>
#include <span>

#include "solver/contact/manifold.hpp"

// Separating axes: the normal is one of the three face normals of each box, or perpendicular to an edge of each.
// A face is the reference face: the face of the other box that is turned towards it, the incident face, is clipped
// to its sides, and what remains are the contact points. Two edges touch at their closest points. Separate boxes
// may be nearest at two edges whose common perpendicular is none of these axes.
namespace byhand {
namespace {

using Eigen::Vector2d, Eigen::Vector3d, Eigen::Matrix3d;
using ContactPoint3 = ContactPoint<SpaceBody>;
using Manifold3 = Manifold<SpaceBody>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Several points along a face are better than one point at an edge that is less than 1 % nearer.
constexpr double clearly = 0.99;

struct OrientedBox {
  Vector3d centre;
  Matrix3d axes;  // as columns
  Vector3d half;
};

struct Boxes {
  OrientedBox first, second;
  Matrix3d turn;   // the second's axes in the first's, as columns
  Vector3d apart;  // from the first's centre to the second's
};

int face_number(int axis, bool negative) { return axis + 3 * negative; }

struct Vertex {
  Vector3d at;   // along the two sides of the reference face, and out of it, from the centre of its box [m]
  int from, to;  // the faces of the first box that name the polygon's edges that end and begin here
};

/// Four vertices and four cuts make eight; rounding could make every cut yield half as many again.
struct Polygon {
  static constexpr int capacity = 20;

  std::array<Vertex, capacity> vertices;
  int size = 0;

  void add(const Vertex& vertex) { vertices[size++] = vertex; }
  const Vertex* begin() const { return vertices.data(); }
  const Vertex* end() const { return vertices.data() + size; }
  const Vertex& operator[](int i) const { return vertices[i]; }
  const Vertex& after(int i) const { return vertices[i + 1 == size ? 0 : i + 1]; }
};

/// The part of the polygon with |x[axis]| <= `reach`; the sides name the edges cut below and above
/// (Sutherland–Hodgman, two cuts at a time).
template <int axis>
Polygon clipped(const Polygon& polygon, double reach, int side_below, int side_above) {
  const auto place = [&](const Vertex& v) { return (v.at[axis] > reach) - (v.at[axis] < -reach); };
  const auto crossing = [&](const Vector3d& a, const Vector3d& b, double sign) -> Vector3d {
    const double beyond_a = sign * a[axis] - reach, beyond_b = sign * b[axis] - reach;
    return a + (b - a) * (beyond_a / (beyond_a - beyond_b));
  };
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    const Vertex &a = polygon[i], &b = polygon.after(i);
    const int place_a = place(a), place_b = place(b);
    if (place_a == 0) result.add(a);
    if (place_a == place_b) continue;
    Vector3d begin = a.at, end = b.at;
    if (place_a > 0) begin = crossing(begin, end, 1);
    if (place_b > 0) end = crossing(begin, end, 1);
    if (place_a < 0) begin = crossing(begin, end, -1);
    if (place_b < 0) end = crossing(begin, end, -1);
    if (place_a != 0) result.add({begin, place_a < 0 ? side_below : side_above, a.to});
    if (place_b != 0) result.add({end, a.to, place_b < 0 ? side_below : side_above});
  }
  return result;
}

/// A directed line along the reference face.
struct Line {
  Vector2d left;  // a unit vector
  double offset;  // [m]

  static Line through(const Vector3d& from, const Vector3d& to) {
    const Vector2d left = Vector2d(from.y() - to.y(), to.x() - from.x()).normalized();
    return {left, left.x() * from.x() + left.y() * from.y()};
  }
  double to_the_left(const Vector3d& p) const { return left.x() * p.x() + left.y() * p.y() - offset; }
};

/// Four of more than four vertices that keep nearly all of the area: the deepest, the one furthest from it, the
/// one furthest from the line between them, and the one furthest outside this triangle. Differences below `level`
/// [m] do not count, so that the choice lasts; above it, vertices of a box go before crossings of parallel edges.
std::array<const Vertex*, 4> four_of(std::span<const Vertex* const> vertices, double level) {
  std::array<double, Polygon::capacity> score;
  const auto best = [&](auto&& distance) {
    double most = -infinity;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex& vertex = *vertices[i];
      score[i] = distance(vertex.at) - (vertex.from == vertex.to ? 2 * level : 0);
      most = std::max(most, score[i]);
    }
    std::size_t i = 0;
    while (score[i] < most - level) ++i;
    return vertices[i];
  };
  const Vertex* deepest = best([](const Vector3d& p) { return -p.z(); });
  const Vector3d& a = deepest->at;
  const Vertex* furthest = best([&](const Vector3d& p) { return (p - a).norm(); });
  const Line ab = Line::through(a, furthest->at);
  const Vertex* aside = best([&](const Vector3d& p) { return std::abs(ab.to_the_left(p)); });
  const Line bc = Line::through(furthest->at, aside->at), ca = Line::through(aside->at, a);
  const double outwards = ab.to_the_left(aside->at) > 0 ? -1 : 1;
  const Vertex* outside = best([&](const Vector3d& p) {
    return std::max({outwards * ab.to_the_left(p), outwards * bc.to_the_left(p), outwards * ca.to_the_left(p)});
  });
  return {deepest, furthest, aside, outside};
}

/// Writes the contact points within the margin, or else the nearest, for a reference face: 0–2 are the axes of the
/// first box, 3–5 of the second.
void collide_face(const Boxes& boxes, int reference, double margin, Manifold3& manifold) {
  const bool second = reference >= 3;
  const OrientedBox &box = second ? boxes.second : boxes.first, &other = second ? boxes.first : boxes.second;
  const Matrix3d turn = second ? Matrix3d(boxes.turn.transpose()) : boxes.turn;
  const Vector3d centre = box.axes.transpose() * (other.centre - box.centre);
  const int axis = reference % 3;
  const double side = centre[axis] < 0 ? -1 : 1;
  const Vector3d n = side * box.axes.col(axis);

  int facing;
  turn.row(axis).cwiseAbs().maxCoeff(&facing);
  const double facing_side = turn(axis, facing) * side > 0 ? -1 : 1;
  const int sides[2] = {(axis + 1) % 3, (axis + 2) % 3}, in_face[2] = {(facing + 1) % 3, (facing + 2) % 3};

  // Features must not depend on which box is the reference, nor on which of two edges on top of each other cuts:
  // every edge is named by the side of the first box that faces the same way.
  const auto like = [&](int i, int j) {
    return std::abs(turn(sides[0], in_face[i]) * turn(sides[1], in_face[j]));
  };
  const bool crosswise = like(1, 0) > like(0, 1);
  const int face1 = second ? face_number(facing, facing_side < 0) : face_number(axis, side < 0);
  const auto name = [&](bool of_reference, int i, double s) {
    const int j = crosswise ? 1 - i : i;
    if (of_reference != second) return face_number(of_reference ? sides[i] : in_face[i], s < 0);
    if (of_reference) return face_number(in_face[j], s * turn(sides[i], in_face[j]) < 0);
    return face_number(sides[j], s * turn(sides[j], in_face[i]) < 0);
  };

  const auto by_face = [&](const Vector3d& v) { return Vector3d(v[sides[0]], v[sides[1]], side * v[axis]); };
  const Vector3d middle = by_face(centre + facing_side * other.half[facing] * turn.col(facing)),
                 half0 = by_face(other.half[in_face[0]] * turn.col(in_face[0])),
                 half1 = by_face(other.half[in_face[1]] * turn.col(in_face[1]));
  // The edge that begins at (+, +) is on the second axis's side, the next one on the first's.
  const int right = name(false, 0, 1), left = name(false, 0, -1), top = name(false, 1, 1),
            bottom = name(false, 1, -1);
  Polygon whole;
  whole.add({middle + half0 + half1, right, top});
  whole.add({middle - half0 + half1, top, left});
  whole.add({middle - half0 - half1, left, bottom});
  whole.add({middle + half0 - half1, bottom, right});
  const Polygon between = clipped<0>(whole, box.half[sides[0]], name(true, 0, -1), name(true, 0, 1)),
                polygon = clipped<1>(between, box.half[sides[1]], name(true, 1, -1), name(true, 1, 1));

  manifold.size = 0;
  manifold.reference = reference + 1;
  manifold.normal = second ? Vector3d(-n) : n;
  const double height = box.half[axis];
  double lowest = infinity;
  for (const Vertex& vertex : polygon) lowest = std::min(lowest, vertex.at.z());
  const double limit = std::max(margin, lowest - height);
  std::array<const Vertex*, Polygon::capacity> near;
  int size = 0;
  for (const Vertex& vertex : polygon)
    if (vertex.at.z() - height <= limit) near[size++] = &vertex;
  if (size > 4) {
    const auto four = four_of({near.data(), near.data() + size}, 2e-4 * box.half.minCoeff());
    size = static_cast<int>(std::copy(four.begin(), four.end(), near.begin()) - near.begin());
  }
  const bool reversed = second == (facing_side > 0);  // as seen from the first box
  for (int i = 0; i < size; ++i) {
    const Vertex& vertex = *near[i];
    const double separation = vertex.at.z() - height;
    Vector3d own;
    own[sides[0]] = vertex.at.x(), own[sides[1]] = vertex.at.y(), own[axis] = side * vertex.at.z();
    const Vector3d q = box.centre + box.axes * own, p = q - separation * n;
    const int edges = reversed ? vertex.to * 6 + vertex.from : vertex.from * 6 + vertex.to;
    const std::uint32_t feature = face1 * 36 + edges;
    manifold.add({second ? q : p, second ? p : q, separation, feature});
  }
}

/// Edge `number` = 4 axis + one bit for the side along each of the next two axes.
struct Edge {
  Vector3d middle, direction;
  double half;
  int number;

  Vector3d at(double s) const { return middle + s * direction; }
  /// The furthest that it reaches along a unit vector [m].
  double reach(const Vector3d& n) const { return n.dot(middle) + half * std::abs(n.dot(direction)); }
  /// 0–11 for the edge, 12–19 for the corners of the box that are its ends.
  int feature_at(double s) const {
    if (std::abs(s) < half) return number;
    const int axis = number / 4, side[2] = {number & 1, number >> 1 & 1};
    return 12 + ((s < 0) << axis | side[0] << (axis + 1) % 3 | side[1] << (axis + 2) % 3);
  }
};
Edge edge(const OrientedBox& box, int number) {
  const int axis = number / 4, j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double sj = number & 1 ? -1 : 1, sk = number & 2 ? -1 : 1;
  return {box.centre + sj * box.half[j] * box.axes.col(j) + sk * box.half[k] * box.axes.col(k), box.axes.col(axis),
          box.half[axis], number};
}

/// How far from the middles of two edges, along each, they are closest to each other [m] (C. Ericson, Real-Time
/// Collision Detection, 2005, 5.1.9).
std::array<double, 2> closest_places(const Edge& a, const Edge& b) {
  const Vector3d d = a.middle - b.middle;
  const double cos = a.direction.dot(b.direction), da = a.direction.dot(d), db = b.direction.dot(d);
  const double sin2 = 1 - cos * cos;
  const double s = sin2 > 1e-12 ? std::clamp((cos * db - da) / sin2, -a.half, a.half) : 0;
  const double t = std::clamp(cos * s + db, -b.half, b.half);
  return {std::clamp(cos * t - da, -a.half, a.half), t};
}

/// The closest points of two edges, without their separation. Features begin beyond those of faces.
ContactPoint3 closest_points(const Edge& a, const Edge& b) {
  const auto [s, t] = closest_places(a, b);
  return {a.at(s), b.at(t), 0, 256u + 20u * a.feature_at(s) + b.feature_at(t)};
}

void set_only_point(const Vector3d& n, ContactPoint3 point, Manifold3& manifold) {
  point.separation = n.dot(point.p2 - point.p1);
  manifold.normal = n;
  manifold.size = 0;
  manifold.add(point);
}

/// Writes the contact points for one of the fifteen axes: faces as in `collide_face`, then 6 + 3i + j for edge
/// directions i of the first box and j of the second. Not returned, as that would copy them.
void collide_axis(const Boxes& boxes, int axis, double margin, Manifold3& manifold) {
  if (axis < 6) return collide_face(boxes, axis, margin, manifold);
  const int i = (axis - 6) / 3, j = (axis - 6) % 3;
  Vector3d n = boxes.first.axes.col(i).cross(boxes.second.axes.col(j)).normalized();
  if (n.dot(boxes.apart) < 0) n = -n;
  const auto furthest_edge = [](const OrientedBox& box, int along, const Vector3d& direction) {
    const auto behind = [&](int k) { return direction.dot(box.axes.col(k % 3)) < 0; };
    return edge(box, 4 * along + behind(along + 1) + 2 * behind(along + 2));
  };
  set_only_point(n, closest_points(furthest_edge(boxes.first, i, n), furthest_edge(boxes.second, j, -n)),
                 manifold);
  manifold.reference = axis + 1;
}

/// Replaces the manifold by the closest edges of separate boxes, if they are nearer than `limit` [m].
void collide_closest_edges(const Boxes& boxes, double limit, Manifold3& manifold) {
  std::array<Edge, 12> edges1, edges2;
  std::array<double, 12> from, to;  // of the gap between two edges along the manifold's normal
  for (int i = 0; i < 12; ++i) {
    edges1[i] = edge(boxes.first, i), edges2[i] = edge(boxes.second, i);
    from[i] = edges1[i].reach(manifold.normal), to[i] = -edges2[i].reach(-manifold.normal);
  }
  const double least_to = *std::min_element(to.begin(), to.end());
  const Edge *best1 = nullptr, *best2 = nullptr;
  // Edges are at least as far apart as the gap; one per cent of it is more than rounding.
  const auto in_reach = [&](double gap) { return clearly * gap <= limit; };
  for (int i = 0; i < 12; ++i) {
    if (!in_reach(least_to - from[i])) continue;
    for (int j = 0; j < 12; ++j) {
      if (!in_reach(to[j] - from[i])) continue;
      const auto [s, t] = closest_places(edges1[i], edges2[j]);
      const double distance = (edges2[j].at(t) - edges1[i].at(s)).norm();
      if (distance < limit) limit = distance, best1 = &edges1[i], best2 = &edges2[j];
    }
  }
  if (!best1) return;
  const ContactPoint3 point = closest_points(*best1, *best2);
  const Vector3d n =
      limit > 1e-12 * boxes.first.half[0] ? Vector3d((point.p2 - point.p1) / limit) : manifold.normal;
  set_only_point(n, point, manifold);
}

/// The separation of the nearest point [m].
double gap(const Manifold3& manifold) {
  double nearest = infinity;
  for (const ContactPoint3& point : manifold) nearest = std::min(nearest, point.separation);
  return nearest;
}

/// The separation of the boxes along each of the fifteen axes [m]; of edge directions -infinity where it is less
/// than the largest of faces by more than `gain` [m], or where that is more than `margin` [m].
std::array<double, 15> separations(const Boxes& boxes, double margin, double gain) {
  const Matrix3d &turn = boxes.turn, size = turn.cwiseAbs();
  const Vector3d &h1 = boxes.first.half, &h2 = boxes.second.half;
  const Vector3d to2 = boxes.first.axes.transpose() * boxes.apart,
                 to1 = boxes.second.axes.transpose() * boxes.apart;
  const Vector3d of1 = to2.cwiseAbs() - h1 - size * h2, of2 = to1.cwiseAbs() - h2 - size.transpose() * h1;

  std::array<double, 15> result;
  for (int i = 0; i < 3; ++i) result[i] = of1[i], result[3 + i] = of2[i];
  std::fill(result.begin() + 6, result.end(), -infinity);
  const double of_faces = std::max(of1.maxCoeff(), of2.maxCoeff()), least = std::min(of_faces - gain, 0.0);
  if (of_faces > margin) return result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double reach =
          h1[i1] * size(i2, j) + h1[i2] * size(i1, j) + h2[j1] * size(i, j2) + h2[j2] * size(i, j1);
      const double times_sine = std::abs(to2[i2] * turn(i1, j) - to2[i1] * turn(i2, j)) - reach;
      if (times_sine < least) continue;  // a sine is at most 1
      const double sin2 = turn(i1, j) * turn(i1, j) + turn(i2, j) * turn(i2, j);
      // Parallel edges have no common perpendicular.
      if (sin2 >= 1e-8) result[6 + 3 * i + j] = times_sine / std::sqrt(sin2);
    }
  return result;
}

}  // namespace

Manifold<SpaceBody> collide_boxes(const Box<SpaceBody>& box1, const Pose<SpaceBody>& pose1,
                                  const Box<SpaceBody>& box2, const Pose<SpaceBody>& pose2, double margin,
                                  std::uint32_t hint) {
  Boxes boxes{{pose1.position, detail::axes<SpaceBody>(pose1), box1.half()},
              {pose2.position, detail::axes<SpaceBody>(pose2), box2.half()},
              {},
              pose2.position - pose1.position};
  boxes.turn = boxes.first.axes.transpose() * boxes.second.axes;
  const double least_gain = hysteresis(box1, box2), rounding = 1e-6 * least_gain;
  const auto separation = separations(boxes, margin, least_gain);
  const auto largest = [&](int from, int to) {
    return static_cast<int>(std::max_element(&separation[from], separation.data() + to) - separation.data());
  };
  const auto larger = [&](int a, int b) { return separation[b] > separation[a] ? b : a; };
  const int first = largest(0, 3), second = largest(3, 6), edge = largest(6, 15),
            best = larger(larger(first, second), edge);
  Manifold3 manifold;
  if (!(separation[best] <= margin)) return manifold;
  // A tie goes to the box further right, whichever of the two is called the first.
  const Vector3d& apart = boxes.apart;
  const bool further = apart.x() > 0 || (apart.x() == 0 && (apart.y() > 0 || (apart.y() == 0 && apart.z() > 0)));
  const int face = separation[second] > separation[first] || (separation[second] == separation[first] && further)
                       ? second
                       : first;

  // Faces before edges, for they give more points; taken is the first whose points are as near as the boxes are.
  const bool overlap = separation[best] <= 0;
  const double far = overlap ? std::min(0.0, separation[best] + least_gain) : separation[best] / clearly;
  double nearest = infinity;
  for (const int axis : {static_cast<int>(hint) - 1, face, edge}) {
    if (axis < 0 || axis >= (overlap ? 15 : 6)) continue;
    if (separation[axis] < separation[best] - least_gain) continue;
    collide_axis(boxes, axis, margin, manifold);
    nearest = gap(manifold);
    if (nearest <= far + rounding) break;
  }
  if (!(nearest <= far + rounding)) {
    if (manifold.reference == 0) {
      collide_axis(boxes, best, margin, manifold);  // for its normal alone
      manifold.size = 0;
    }
    collide_closest_edges(boxes, std::min(clearly * nearest, margin + rounding), manifold);
    nearest = gap(manifold);
  }
  if (!(nearest <= margin)) manifold.size = 0;
  return manifold;
}

}  // namespace byhand
