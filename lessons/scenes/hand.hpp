#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lessons/scenes/pull.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A reader's hand in a scene: a fixed body without a shape that is tied to the body it holds by two soft rows,
/// along two directions at right angles, such as the right and up of a picture. They are tuned to that body, each
/// of limited strength, so that the hand pulls with a spring's force and never with more than ten times the weight
/// of all bodies.
template <class M>
class Hand {
 public:
  struct Grip {
    int body = 0;
    Arm<M> arm = {};  // where it is held
    std::array<Handle<Pull<M>>, 2> rows = {};
  };

  using Directions = Eigen::Matrix<double, 2, M::linear>;  // one a row, of length 1

  Hand() = default;
  /// Adds the hand to the scene, where it holds nothing yet.
  explicit Hand(Scene<M>& scene, const Directions& along = Directions::Identity()) : along_(along) {
    double mass = 0;
    for (const InverseMass<M>& inverse : scene.bodies().inverse_mass)
      if (moves(inverse)) mass += 1 / inverse.linear;
    strength_ = weights * mass * std::max(scene.gravity.norm(), 1.0);
    body_ = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  }

  int body() const { return body_; }             // the hand's own
  double strength() const { return strength_; }  // [N]
  const std::optional<Grip>& grip() const { return grip_; }

  /// Takes a body at a point of it; the hand is at `at` in the world.
  void take(Scene<M>& scene, int body, const Arm<M>& arm, const Linear<M>& at) {
    release(scene);
    scene.set_position(body_, at);
    grip_ = Grip{body, arm, {}};
    for (int axis = 0; axis < 2; ++axis) {
      Pull<M> pull{
          .at = {body_, body}, .along = along_.row(axis).transpose(), .strength = strength_ / std::sqrt(2.0)};
      if constexpr (M::angular > 0) pull.at.arms.second = arm;
      pull.elastic = tuned(scene.bodies(), pull, rate, 1);
      grip_->rows[static_cast<std::size_t>(axis)] = scene.add(pull);
    }
  }
  void move(Scene<M>& scene, const Linear<M>& to) {
    if (grip_) scene.set_position(body_, to);
  }
  void release(Scene<M>& scene) {
    if (!grip_) return;
    for (const auto& row : grip_->rows) scene.remove(row);
    grip_.reset();
  }

 private:
  static constexpr double rate = 20;     // ω of its springs [rad/s], damped critically
  static constexpr double weights = 10;  // its strength, over the weight of all bodies

  Directions along_ = Directions::Identity();
  int body_ = -1;
  double strength_ = 0;
  std::optional<Grip> grip_;
};

}  // namespace byhand
