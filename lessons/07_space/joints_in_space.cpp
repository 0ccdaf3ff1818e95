// Part of step 7a: a hinge.

#include <Eigen/QR>

#include "lessons/07_space/steps.hpp"
#include "solver/constraints/hinge.hpp"

namespace byhand::space {
namespace {

using Vector = Eigen::Vector3d;

constexpr double joint_seconds = 2;  // [s]

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
  Simulation<SpaceBody> book{{}, {Direct{}, Baumgarte{0.2}}};
  book.method.gyroscopic = Gyroscopic::implicit;
  book.scene.add_body(Pose<SpaceBody>(), fixed<SpaceBody>());
  Pose<SpaceBody> pose;
  pose.position = {0.5 * book_sides().x(), 0, 0};
  const Vector omega(0, 2, 0);
  Velocity<SpaceBody> V;
  V << omega.cross(pose.position), omega;
  book.scene.add_body(pose, box<SpaceBody>(setting.mass, book_sides()), V);
  const Hinge<SpaceBody> joint = hinge<SpaceBody>(book.scene.bodies(), 0, 1, Vector::Zero(), Vector::UnitY());
  book.scene.add(joint);
  return {book, joint};
}

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

  page.claim("degrees of freedom that a hinge leaves", static_cast<double>(freedom), "1",
             is(1, "6 − 5 rows", absolute(0)));
  page.claim("sine of the angle between the axes of a door, largest", off_axis, "1",
             is(0, "its last two rows", absolute(1e-3)));
}

}  // namespace byhand::space
