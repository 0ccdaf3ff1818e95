#pragma once

#include "solver/work.hpp"

namespace byhand {

/// The refusal of methods that run every scene.
template <class M, class Method>
std::string refusal(const Scene<M>&, const Method&) {
  return {};
}

/// Begins every `advance`. Throws std::invalid_argument for a time step [s] that is not positive, gravity that is
/// not finite, a method outside its range, and a method that refuses the scene.
template <class M, class Method>
void require_steppable(const Scene<M>& scene, const Method& method, double step) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if (const std::string reason = refusal(scene, method); !reason.empty()) throw std::invalid_argument(reason);
}

/// Throws NotFinite for a step that `came` to numbers that are not finite and was taken back. It names the first
/// body that began with one, or else the first constraint with such a value at the start, or else the first body
/// at the end.
template <class M>
void refuse_not_finite(const Scene<M>& scene, const State<M>& came);

/// Within a step either all bodies move or none: whatever throws before the end of `finish` leaves them as they
/// were, and the next step begins without λ.
template <class M, class Work>
class Attempt {
 public:
  Attempt(Scene<M>& scene, Work& work) : scene_(scene), work_(work) {
    work.start.pose = scene.bodies().pose;
    work.start.velocity = scene.bodies().velocity;
    if constexpr (requires { work.contacts; }) work.contacts.begin_step(scene);
  }
  Attempt(const Attempt&) = delete;
  ~Attempt() {
    if (!finished_) take_back();
  }

  /// Throws NotFinite if a pose or velocity is not finite.
  void finish() {
    finished_ = true;
    if (!are_finite(scene_.bodies().pose, scene_.bodies().velocity)) refuse_not_finite(scene_, take_back());
    scene_.state().applied.clear();
  }

 private:
  /// Returns what it takes back.
  State<M> take_back() {
    State<M> state = std::move(work_.start);
    std::swap(scene_.state().pose, state.pose);
    std::swap(scene_.state().velocity, state.velocity);
    work_ = {};
    return state;
  }

  Scene<M>& scene_;
  Work& work_;
  bool finished_ = false;
};

}  // namespace byhand
