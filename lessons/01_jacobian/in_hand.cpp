// Step 1: a bob on a rod in the reader's hand, with C, its rate and J.

#include "lessons/01_jacobian/steps.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "renderer/camera.hpp"

namespace byhand::lesson01 {
namespace {

/// The bob goes where the hand leads it, and no constraint holds it: what C and JV say of that motion is all that
/// is to be seen.
class BobInHand final : public course::Held {
  static constexpr double hand_rate = 8;  // of the bob's way to the hand that is left, it goes [1/s]
  static constexpr double slack = 40;     // how far from the bob it may be taken [points]
  static constexpr double letters = 34;   // [points]

 public:
  BobInHand(double length, double stretch, double mass)
      : length_(length),
        begin_((length + stretch) * Point(0.6, -0.8)),
        scene_(pendulum<PlaneParticle>(0, length, mass)),
        camera_(renderer::fit(seen(length, length + stretch), page, 8)) {
    reset();
  }

  double h() const override { return 1.0 / 60; }
  double time() const override { return time_; }
  std::vector<Body> bodies() const override { return {{"bob", camera_.to_page(bob()), 30}}; }
  int held() const override { return hand_ ? 0 : -1; }
  void grab(const renderer::Point& at) override {
    hand_.reset();
    if ((at - camera_.to_page(bob())).norm() <= slack) hand_ = camera_.to_world(at);
  }
  void move(const renderer::Point& to) override {
    if (hand_) hand_ = camera_.to_world(to);
  }
  void release() override { hand_.reset(); }

  void step() override {
    const Point velocity = hand_ ? Point(hand_rate * (*hand_ - bob())) : Point(0, 0);
    scene_.state().velocity[1] = velocity;
    scene_.set_position(1, Point(bob() + h() * velocity));
    time_ += h();
  }
  void reset() override {
    hand_.reset();
    time_ = 0;
    scene_.set_position(1, begin_);
    scene_.state().velocity[1].setZero();
  }
  std::string stopped() const override { return ""; }
  void go_on_from(const Held&) override {}

  void draw(renderer::Canvas& canvas, std::optional<double>) const override {
    canvas.clip(page);
    canvas.look(camera_);
    std::vector<Point> circle;
    for (int i = 0; i <= 120; ++i)
      circle.push_back(length_ * from_straight_down<PlaneParticle>(2 * std::numbers::pi * i / 120));
    canvas.path(circle, {palette::theory, 2.5, Dash::dashed});
    pictures::draw(canvas, pictures::rods_and_bobs(scene_), {.bob = 24, .rod = 9});
    // J is d, which is as long as the rod: half of it shows its direction and leaves it in the picture.
    const Point J = 0.5 * Point(row().l2().row(0)), V = scene_.bodies().velocity[1];
    if (J.norm() > 0) canvas.arrow(bob(), bob() + J, {palette::constraint, 6});
    name(canvas, bob() + J, J, "J", palette::constraint);
    const Point shown = V * (0.5 / hand_rate);
    if (shown.norm() > 0.02 * length_) {
      canvas.arrow(bob(), bob() + shown, {palette::velocity, 6});
      name(canvas, bob() + shown, shown, "V", palette::velocity);
    }
    canvas.look_at_page();
    const auto line = [&](double below, const std::string& words, Colour colour) {
      canvas.text({24, page.top() - below}, words,
                  {.size = letters, .colour = colour, .anchor = Anchor::top_left, .halo = 5});
    };
    line(20, course::say("C = @ m²", Value(value(), 3)), palette::error);
    line(66, course::say("Ċ = JV = @ m²/s", Value(rate(), 3)), palette::error);
  }

  std::string words(std::optional<double>) const override {
    const double off = course::without_rounding(row().l2().norm() - length_, length_);
    const std::string rod = off == 0 ? "the bob is on the circle"
                                     : course::say("the bob is @ m too @ the fixed point", Value(std::abs(off), 3),
                                                   off > 0 ? "far from" : "close to");
    const char* way = rate() == 0 ? "C does not change" : rate() > 0 ? "C grows" : "C falls";
    return course::say("C = @ m²: @. Ċ = JV = @ m²/s: @.", Value(value(), 3), rod, Value(rate(), 3), way);
  }

 private:
  /// The circle and, beyond a bob that is `far` from the anchor, the names of its arrows.
  static Rectangle seen(double length, double far) {
    const double half = std::max(1.7 * length, 1.6 * far);
    return {-half, -half, 2 * half, 2 * half};
  }
  Point bob() const { return scene_.bodies().pose[1].position; }
  const Distance<PlaneParticle>& rod() const { return scene_.all<Distance>()[0]; }
  Jacobian<PlaneParticle, 1> row() const {
    return rod().jacobian(scene_.bodies().pose[0], scene_.bodies().pose[1]);
  }
  double value() const {
    return course::without_rounding(rod().value<double>(scene_.bodies().pose[0], scene_.bodies().pose[1])[0],
                                    length_ * length_);
  }
  double rate() const {
    const double whole = dot(row(), scene_.bodies().velocity[0], scene_.bodies().velocity[1])[0];
    return course::without_rounding(whole, length_ * length_ * hand_rate);
  }
  /// Writes the name of an arrow beyond its tip.
  void name(renderer::Canvas& canvas, const Point& tip, const Point& along, const char* word,
            Colour colour) const {
    if (along.norm() == 0) return;
    const Point beyond = 26 * along.normalized();
    canvas.text(tip, word, {.size = letters, .colour = colour, .halo = 5, .offset = beyond});
  }

  double length_;  // [m]
  Point begin_;
  Scene<PlaneParticle> scene_;
  renderer::Camera camera_;
  std::optional<Point> hand_;
  double time_ = 0;
};

}  // namespace

course::Hold in_hand(const Settings& set) {
  return {
      "bob_in_hand",
      R"(Drag the bob. C is one number: 0 on the dashed circle, whose radius is the length of the rod, positive outside
          it and negative inside. J points in the direction of increasing C, and JV says how fast. It starts at the rod's length plus the stretch.)",
      [set] { return std::make_unique<BobInHand>(set.length, set.stretch, set.mass); }};
}

}  // namespace byhand::lesson01
