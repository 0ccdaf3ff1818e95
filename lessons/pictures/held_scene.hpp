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
  renderer::Rectangle view = {};  // what is to be seen of the world, in directions `seen` [m]
  std::string body = {};          // "bob"
  std::string unit_of_C = "m";
  std::string law = {};                                        // what is said where it flies apart
  std::function<std::string(const Simulation<M>&)> says = {};  // a sentence before the numbers of every scene
  double reach = 0;  // how far from its middle a body may be taken [m]; 0: as far as it is drawn
  Seen<M> seen = Seen<M>::Identity();
  std::function<void(renderer::Canvas&, const Scene<M>&)> draw = {};  // instead of rods, bobs and shapes
};

/// A scene that a reader holds, by a hand that pulls to the right and up in the picture.
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
  renderer::Point seen(const Linear<M>& point) const { return given_.seen * point; }
  /// The point of the world that is seen at `at`, at the depth of `beside`.
  Linear<M> in_world_at(const renderer::Point& at, const Linear<M>& beside) const;
  /// The body that moves at a point of the picture, or -1.
  int body_at(const renderer::Point& point) const;
  bool covers(int body, const renderer::Point& point) const;
  /// The arm to the point of a body's surface that is seen there; in the plane, and beside the body, to the point.
  Arm<M> arm_at(int body, const renderer::Point& point) const;
  double reach(int body) const;  // [m]
  void draw_hand(renderer::Canvas& canvas) const;
  /// What the next step does; nothing where it would fail.
  struct Next {
    StepTerms terms;
    std::vector<Velocity<M>> velocity;
  };
  std::optional<Next> next() const;

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
