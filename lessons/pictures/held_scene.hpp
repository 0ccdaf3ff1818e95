#pragma once

#include "lessons/page/held.hpp"
#include "lessons/pictures/step_terms.hpp"
#include "lessons/scenes/hand.hpp"
#include "renderer/camera.hpp"
#include "solver/step.hpp"

namespace byhand::pictures {

/// What a reader gets to hold, and how it is called.
template <class M>
struct InHand {
  Simulation<M> start;
  double h = 1.0 / 60;            // [s]
  renderer::Rectangle view = {};  // what is to be seen of the world [m]
  std::string body = {};          // "bob"
  std::string unit_of_C = "m";
  std::string law = {};                                        // what is said where it flies apart
  std::function<std::string(const Simulation<M>&)> says = {};  // a sentence before the numbers of every scene
};

/// A scene in the plane that a reader holds.
template <class M>
class HeldScene final : public course::Held {
 public:
  explicit HeldScene(InHand<M> given);

  double h() const override { return given_.h; }
  double time() const override { return now_.time; }
  std::vector<Body> bodies() const override;
  int held() const override;
  void grab(const renderer::Point& at) override;
  void move(const renderer::Point& to) override;
  void release() override;
  void step() override;
  void reset() override;
  std::string stopped() const override { return stopped_; }
  void go_on_from(const Held& other) override;
  void draw(renderer::Canvas& canvas, std::optional<double> part = {}) const override;
  std::string words(std::optional<double> part = {}) const override;

  const Simulation<M>& simulation() const { return now_; }
  /// What the hand has given since the beginning [N s].
  const Linear<M>& hand_impulse() const { return hand_impulse_; }
  double strength() const { return hand_.strength(); }  // [N]

 private:
  /// The body that moves at a point of the world, or -1.
  int body_at(const Linear<M>& point) const;
  bool covers(int body, const Linear<M>& point) const;
  double reach(int body) const;  // [m]
  void draw_hand(renderer::Canvas& canvas) const;
  /// What the next step does; nothing where it would fail.
  std::optional<StepTerms> next_terms() const;

  InHand<M> given_;
  Simulation<M> now_;
  renderer::Camera camera_;
  Hand<M> hand_, no_hand_;  // the latter as it begins, with nothing in it
  Linear<M> hand_impulse_ = Linear<M>::Zero();
  std::string stopped_;
};

template <class M>
std::unique_ptr<course::Held> in_hand(InHand<M> given) {
  return std::make_unique<HeldScene<M>>(std::move(given));
}

}  // namespace byhand::pictures
