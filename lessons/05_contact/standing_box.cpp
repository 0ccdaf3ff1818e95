#include "lessons/05_contact/standing_box.hpp"

#include "lessons/scenes/boxes.hpp"
#include "solver/cures/baumgarte.hpp"
#include "solver/integrate/euler.hpp"

namespace byhand::contact {
namespace {

/// b of (21): an open contact may close and not more, a share of an overlap is taken away.
double bias(double C, double h) { return C > 0 ? C / h : Baumgarte{}.correction(h).per_second * C; }

}  // namespace

StandingBox::StandingBox(double width, double mass, double h, int sweeps, Clamp clamp, double lift)
    : h_(h), sweeps_(sweeps), clamp_(clamp) {
  const Surface smooth{.friction = 0};
  scene_.set_contact_rows(ContactRows::points);
  add_ground(scene_, smooth);
  add_box(scene_, {{0, 0.5 + lift}, {}}, mass, {width, 1}, smooth);
}

void StandingBox::sweep() {
  const auto& poses = scene_.bodies().pose;
  const auto& masses = scene_.bodies().inverse_mass;
  auto& velocities = scene_.state().velocity;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const Contact<PlaneBody>& contact = contacts()[i];
    const int one = contact.at.body1, two = contact.at.body2;
    const auto J = contact.jacobian(poses[one], poses[two]);
    const auto W = times_inverse_mass(J, masses[one], poses[one], masses[two], poses[two]);
    const double C = contact.value<double>(poses[one], poses[two])[0];
    //! [clamp]
    double change = impulse(J, W, velocities[one], velocities[two], bias(C, h_));  // (17)
    if (clamp_ == Clamp::sum)
      change = std::max(0.0, lambda_[i] + change) - lambda_[i];
    else
      change = std::max(0.0, change);
    lambda_[i] += change;
    apply_impulse(W, Rows<1>(change), velocities[one], velocities[two]);  // (20)
    //! [clamp]
  }
}

std::vector<std::array<double, 2>> StandingBox::step() {
  contacts_.find(scene_);
  add_gravity(scene_.state(), scene_.gravity, h_);
  lambda_.assign(contacts().size(), 0.0);
  std::vector<std::array<double, 2>> by_sweep;
  for (int i = 0; i < sweeps_; ++i) {
    sweep();
    by_sweep.push_back({lambda_.empty() ? 0 : lambda_.front(), lambda_.size() < 2 ? 0 : lambda_.back()});
  }
  advance_poses(scene_.state(), h_);
  time_ += h_;
  return by_sweep;
}

}  // namespace byhand::contact
