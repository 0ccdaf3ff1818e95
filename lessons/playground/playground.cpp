#include "lessons/playground/playground.hpp"

#include <stdexcept>
#include <utility>

#include "lessons/catalogue/separation.hpp"
#include "lessons/pictures/step_terms.hpp"
#include "lessons/scenes/hand.hpp"
#include "solver/measure.hpp"

namespace byhand::playground {
namespace {

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
    for (int i = 0; i < std::get<Scene<M>>(file_.scene).bodies().size(); ++i) write_pose(bodies.pose[i], numbers);
  }

  SceneFile file() const override {
    SceneFile file = file_;
    Scene<M> scene = now_.scene;
    if (hand_) scene.remove_body(hand_->body());
    file.scene = std::move(scene);
    return file;
  }

  void grab(int body, const Eigen::Vector3d& at, const Seen& seen) override {
    release();
    const Bodies<M>& bodies = now_.scene.bodies();
    if (!bodies.has(body) || !moves(bodies.inverse_mass[body])) return;
    hand_.emplace(now_.scene, directions(seen));
    const Linear<M> point = at.head<M::linear>();
    if constexpr (M::angular > 0)
      hand_->take(now_.scene, body, arm_to<M>(now_.scene.bodies().pose[body], point), point);
    else
      hand_->take(now_.scene, body, {}, point);
  }
  void move(const Eigen::Vector3d& to) override {
    if (hand_) hand_->move(now_.scene, to.head<M::linear>());
  }
  void release() override {
    if (hand_) now_.scene.remove_body(hand_->body());
    hand_.reset();
  }

  Part draw_part(renderer::Canvas& canvas, double part, double longest, const Seen& seen) const override {
    Simulation<M> next = now_;
    try {
      next.step(file_.step);
    } catch (const std::runtime_error&) {
      return {};
    }
    const pictures::StepTerms terms = pictures::terms_of(now_, next, file_.step, directions(seen));
    pictures::draw_arrows(canvas, terms, part, longest);
    const pictures::PartInWords said = pictures::in_words(terms, static_cast<int>(part));
    Part result{said.formula, said.words, {}};
    if (part < poses_move) return result;
    const Bodies<M>& bodies = next.scene.bodies();
    for (int i = 0; i < bodies.size(); ++i) {
      if (!moves(bodies.inverse_mass[i])) continue;
      Pose<M> pose = now_.scene.bodies().pose[i];
      byhand::move(pose, bodies.velocity[i], pictures::share_of(part) * file_.step);
      result.moved.push_back({i, {}});
      write_pose(pose, result.moved.back().numbers);
    }
    return result;
  }

 private:
  static pictures::Seen<M> directions(const Seen& seen) { return seen.leftCols<M::linear>(); }
  static void write_pose(const Pose<M>& pose, std::vector<double>& numbers) {
    numbers.insert(numbers.end(), pose.position.begin(), pose.position.end());
    if constexpr (M::linear == 3) {
      Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
      if constexpr (M::angular == 3) rotation = pose.rotation.toRotationMatrix();
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) numbers.push_back(rotation(row, column));
    } else if constexpr (M::angular > 0) {
      numbers.insert(numbers.end(), {pose.rotation.cos, pose.rotation.sin});
    } else {
      numbers.insert(numbers.end(), {1, 0});
    }
  }

  static constexpr double poses_move = 5;  // the last part

  SceneFile file_;
  Simulation<M> now_;
  std::optional<Hand<M>> hand_;
};

}  // namespace

std::unique_ptr<Playground> begin(SceneFile file) {
  return std::visit(
      [&]<class M>(const Scene<M>&) -> std::unique_ptr<Playground> {
        return std::make_unique<PlaygroundOf<M>>(std::move(file));
      },
      file.scene);
}

}  // namespace byhand::playground
