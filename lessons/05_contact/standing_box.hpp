#pragma once

#include "lessons/05_contact/setting.hpp"

#include "solver/constraints/contact.hpp"
#include "solver/contact/contact_manager.hpp"

namespace byhand::contact {

/// What is kept at zero or above: the sum of a row's impulses in this step, or each of them.
enum class Clamp { sum, each };

/// A box of 1 m height that falls flat onto level ground, stepped line by line with the article's arithmetic and
/// without friction.
class StandingBox {
 public:
  /// It begins at rest, `lift` [m] above the ground.
  StandingBox(double width, double mass, double h, int sweeps, Clamp clamp, double lift = 0);

  /// One time step; returns λ of the two lower corners after each sweep [N s], left and right.
  std::vector<std::array<double, 2>> step();

  const Scene<PlaneBody>& scene() const { return scene_; }
  std::span<const Contact<PlaneBody>> contacts() const {
    return contacts_.constraints().all<Contact<PlaneBody>>();
  }
  double time() const { return time_; }
  /// λ of each contact in the last step [N s].
  const std::vector<double>& lambda() const { return lambda_; }
  /// v and ω of the box [m/s, rad/s].
  Velocity<PlaneBody> velocity() const { return scene_.bodies().velocity[1]; }

 private:
  void sweep();

  Scene<PlaneBody> scene_;
  ContactManager<PlaneBody> contacts_;
  double h_, time_ = 0;
  int sweeps_;
  Clamp clamp_;
  std::vector<double> lambda_;
};

}  // namespace byhand::contact
