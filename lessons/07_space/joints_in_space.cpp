// Part of step 7a: a hinge, and bounds on swing and twist.

#include <Eigen/QR>

#include "lessons/07_space/steps.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"

namespace byhand::space {
namespace {

using Vector = Eigen::Vector3d;

constexpr double joint_seconds = 2, cone = 40, twisted = 60;  // [s], of the swing's stop [deg], a twist [deg]

Vector book_edge() { return {0.5 * book_sides().x(), 0, 0}; }

/// A book that moves about a point of the ground, at the middle of its edge, at `omega` [rad/s].
Simulation<SpaceBody> jointed(const Setting& setting, const Vector& from_edge, const Vector& omega) {
  Simulation<SpaceBody> book{{}, {Direct{}, Baumgarte{0.2}}};
  book.method.gyroscopic = Gyroscopic::implicit;
  book.scene.add_body(Pose<SpaceBody>(), fixed<SpaceBody>());
  Pose<SpaceBody> pose;
  pose.position = from_edge;
  Velocity<SpaceBody> V;
  V << omega.cross(from_edge), omega;
  book.scene.add_body(pose, box<SpaceBody>(setting.mass, book_sides()), V);
  return book;
}

/// The book as a door, and its hinge.
struct Door {
  Simulation<SpaceBody> book;
  Hinge<SpaceBody> hinge;

  /// C of the hinge: the gap of its anchors [m], then two cosines between the axis and the directions across it.
  Rows<5> error() const {
    const auto& pose = book.scene.bodies().pose;
    return hinge.value<double>(pose[0], pose[1]);
  }
};

Door door_of(const Setting& setting) {
  Simulation<SpaceBody> book = jointed(setting, book_edge(), {0, 2, 0});
  const Hinge<SpaceBody> joint = hinge<SpaceBody>(book.scene.bodies(), 0, 1, Vector::Zero(), Vector::UnitY());
  book.scene.add(joint);
  return {book, joint};
}

/// φ about y of an orientation p, read without a look at its sign [deg].
double twist(const Eigen::Quaterniond& p) { return degrees(2 * std::atan2(p.y(), p.w())); }

}  // namespace

void joints_in_space(const Setting& setting, Page& page) {
  Door door = door_of(setting);
  const auto& pose = door.book.scene.bodies().pose;
  const auto J = door.hinge.jacobian(pose[0], pose[1]);
  const long freedom = 6 - Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(J.matrix.rightCols<6>()).rank();
  double off_axis = 0;
  while (door.book.time < joint_seconds) {
    door.book.step(setting.h);
    off_axis = std::max(off_axis, door.error().tail<2>().norm());
  }

  page.text(
      R"(The most common joint in space is the *hinge* of a door: five rows. Three hold a point, like a ball joint; two
      keep the axes parallel. Let n₂ be the axis in body 2, and t₁ and t₂ two directions across it in body 1. They must
      stay at right angles, C_k = t_k · n₂ = 0, and their derivatives only contain the two ω:)");
  page.formula("J_k = [0,  −(n₂ × t_k),  0,  n₂ × t_k],   k = 1, 2",
               R"(J_k = \begin{bmatrix} 0 & -(n_2\times t_k) & 0 & n_2\times t_k\end{bmatrix}, \quad k = 1, 2)");
  const Vector below(0, -0.5 * book_sides().y(), 0);
  Simulation<SpaceBody> shoulder = jointed(setting, below, {0, 0, 8});
  const auto& held = shoulder.scene.bodies();
  shoulder.scene.add(pin<SpaceBody>(held, 0, 1, Vector::Zero()));
  const Swing<SpaceBody> angle = swing<SpaceBody>(held, 0, 1, Vector(-Vector::UnitY()));
  shoulder.scene.add(at_most<SpaceBody>(radians(cone), angle));
  double widest = 0;
  while (shoulder.time < joint_seconds) {
    shoulder.step(setting.h);
    widest = std::max(widest, degrees(angle.value<double>(held.pose[0], held.pose[1])));
  }
  const Eigen::Quaterniond p = space_rotation(Vector(0, radians(twisted), 0)),
                           opposite(-p.w(), -p.x(), -p.y(), -p.z());
  page.text(
      R"(Each turn that a joint leaves free can be bounded by one row, a stop as in lesson 6. *Swing* is the angle
      between an axis of one body and an axis of the other: a stop at @° keeps a book on a ball joint within a cone, as
      a shoulder keeps an arm. *Twist* is the turn about the axis n. With the orientation p = (p_w, **p**) of body 2 as
      seen from body 1 it is φ = 2·atan2(**p**·n, p_w). The classic mistake: p and −p are the same orientation, but
      where p says @°, −p says @°, and a stop at −90° finds itself passed by @°. So where p_w is negative, change the
      sign of p first.)",
      cone, Value(twist(p), 4), Value(twist(opposite), 4), Value(-90 - twist(opposite), 4));

  page.claim("degrees of freedom that a hinge leaves", static_cast<double>(freedom), "1",
             is(1, "6 − 5 rows", absolute(0)));
  page.claim("sine of the angle between the axes of a door, largest", off_axis, "1",
             is(0, "its last two rows", absolute(1e-3)));
  page.claim(say("widest swing with a stop at @°", cone), widest, "deg",
             is(cone, "it reaches the stop, and a step along the tangent at most passes it", absolute(1)));
  page.claim("twist read from −p", twist(opposite), "deg", is(twisted - 360, "a full turn less", absolute(1e-9)));
}

}  // namespace byhand::space
