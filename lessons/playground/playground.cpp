#include "lessons/playground/playground.hpp"

#include <stdexcept>
#include <utility>

#include "lessons/catalogue/separation.hpp"
#include "lessons/pictures/step_terms.hpp"
#include "lessons/scenes/hand.hpp"
#include "solver/measure.hpp"

namespace byhand::playground {
namespace {

using renderer::Point;

template <class M>
void require_runs(const Scene<M>& scene, const VelocityStepping& method) {
  if (const std::string reason = refusal(scene, method); !reason.empty()) throw std::invalid_argument(reason);
}

template <class M>
class PlaygroundOf final : public Playground {
 public:
  explicit PlaygroundOf(SceneFile file) : file_(std::move(file)) {
    now_.scene = std::get<Scene<M>>(file_.scene);
    now_.method = file_.method;
    require_runs(now_.scene, now_.method);
  }

  stage::SceneLook look() const override { return stage::look_of(file_.scene); }

  void step() override { now_.step(file_.step); }

  void use(const SceneFile& method) override {
    require_runs(now_.scene, method.method);
    now_.method = file_.method = method.method;
    file_.step = method.step;
    file_.duration = method.duration;
  }

  void write_moment(std::vector<double>& numbers) const override {
    const Bodies<M>& bodies = now_.scene.bodies();
    numbers = {now_.time, energy(now_.scene), separation(now_.scene, now_.work.contacts)};
    for (int i = 0; i < std::get<Scene<M>>(file_.scene).bodies().size(); ++i) {
      const Pose<M>& pose = bodies.pose[i];
      numbers.insert(numbers.end(), pose.position.begin(), pose.position.end());
      if constexpr (M::angular > 0)
        numbers.insert(numbers.end(), {pose.rotation.cos, pose.rotation.sin});
      else
        numbers.insert(numbers.end(), {1, 0});
    }
  }

  SceneFile file() const override {
    SceneFile file = file_;
    Scene<M> scene = now_.scene;
    if (hand_) scene.remove_body(hand_->body());
    file.scene = std::move(scene);
    return file;
  }

  void grab(int body, const Point& at) override {
    release();
    const Bodies<M>& bodies = now_.scene.bodies();
    if (!bodies.has(body) || !moves(bodies.inverse_mass[body])) return;
    hand_.emplace(now_.scene);
    if constexpr (M::angular > 0)
      hand_->take(now_.scene, body, arm_to<M>(now_.scene.bodies().pose[body], at), at);
    else
      hand_->take(now_.scene, body, {}, at);
  }
  void move(const Point& to) override {
    if (hand_) hand_->move(now_.scene, to);
  }
  void release() override {
    if (hand_) now_.scene.remove_body(hand_->body());
    hand_.reset();
  }

  Part draw_part(renderer::Canvas& canvas, double part, double longest) const override {
    Simulation<M> next = now_;
    try {
      next.step(file_.step);
    } catch (const std::runtime_error&) {
      return {};
    }
    const pictures::StepTerms terms = pictures::terms_of(now_, next, file_.step, pictures::Seen<M>::Identity());
    pictures::draw_arrows(canvas, terms, part, longest);
    const pictures::PartInWords said = pictures::in_words(terms, static_cast<int>(part));
    Part result{said.formula, said.words, {}};
    if (part < poses_move) return result;
    const Bodies<M>& bodies = next.scene.bodies();
    const double time = pictures::share_of(part) * file_.step;  // [s]
    for (int i = 0; i < bodies.size(); ++i) {
      if (!moves(bodies.inverse_mass[i])) continue;
      double turn = 0;
      if constexpr (M::angular > 0) turn = time * bodies.velocity[i][M::linear];
      result.moves.push_back({i, time * bodies.velocity[i].template head<2>(), turn});
    }
    return result;
  }

 private:
  static constexpr double poses_move = 5;  // the last part

  SceneFile file_;
  Simulation<M> now_;
  std::optional<Hand<M>> hand_;
};

}  // namespace

std::unique_ptr<Playground> begin(SceneFile file) {
  if (std::holds_alternative<Scene<PlaneParticle>>(file.scene))
    return std::make_unique<PlaygroundOf<PlaneParticle>>(std::move(file));
  if (std::holds_alternative<Scene<PlaneBody>>(file.scene))
    return std::make_unique<PlaygroundOf<PlaneBody>>(std::move(file));
  throw std::invalid_argument(
      "the playground has scenes in the plane; ./lessons/run scene FILE runs one in space");
}

}  // namespace byhand::playground
