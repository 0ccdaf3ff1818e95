#include "lessons/pictures/held_scene.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/page/rounding.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "renderer/canvas.hpp"
#include "solver/measure.hpp"

namespace byhand::pictures {
namespace {

using namespace renderer;
using course::say;
using course::Value;

constexpr double slack = 12;     // how far beside a body it may be taken [points]
constexpr double too_far = 0.5;  // of the picture, in one step: a scene where a body moves so has flown apart

template <class M>
bool has_shapes(const Scene<M>& scene) {
  return !scene.colliders().shapes.empty();
}

/// Rods and bobs as large as fingers want them, but small beside the shortest rod.
LinkageStyle style_of(const Linkage& linkage, double points_per_metre) {
  double shortest = 1e9;
  for (const Linkage::Bar& rod : linkage.rods)
    shortest = std::min(shortest, points_per_metre * (rod.to - rod.from).norm());
  const double size = std::clamp(shortest / 60, 0.2, 1.0);
  return {.bob = 20 * size, .rod = 8 * size, .link = 22};
}

template <class M>
void draw_scene(Canvas& canvas, const Scene<M>& scene) {
  if constexpr (M::linear == 2) {
    if constexpr (M::angular > 0)
      if (has_shapes(scene)) return pictures::draw(canvas, shapes_of(scene));
    const Linkage linkage = rods_and_bobs(scene);
    pictures::draw(canvas, linkage, style_of(linkage, canvas.camera().scale));
  }
}

template <class M>
bool begin_alike(const Bodies<M>& one, const Bodies<M>& other) {
  return std::equal(one.pose.begin(), one.pose.end(), other.pose.begin(), other.pose.end(),
                    [](const Pose<M>& a, const Pose<M>& b) {
                      if constexpr (M::angular == 1)
                        if (a.rotation.cos != b.rotation.cos || a.rotation.sin != b.rotation.sin) return false;
                      if constexpr (M::angular == 3)
                        if (a.rotation.coeffs() != b.rotation.coeffs()) return false;
                      return a.position == b.position;
                    });
}

/// The largest impulse λ|l₂| of a row that is not the hand's [N s].
template <class M>
double largest_impulse(const Simulation<M>& simulation) {
  double largest = 0;
  const System<M>& system = simulation.work.system;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    if (simulation.scene.store(run, simulation.work.contacts.constraints()).kind() == typeid(Pull<M>)) return;
    for (int k = 0; k < K; ++k) {
      const double impulse = system.lambda[block.row + k] * block.J.l2().row(k).norm();
      if (std::abs(impulse) > std::abs(largest)) largest = impulse;
    }
  });
  return largest;
}

}  // namespace

template <class M>
HeldScene<M>::HeldScene(InHand<M> given)
    : given_(std::move(given)),
      now_(given_.start),
      camera_(fit(given_.view, {page.x, page.y + 36, page.width, page.height - 96}, 20)) {
  no_hand_ = Hand<M>(given_.start.scene, given_.seen);
  reset();
}

template <class M>
void HeldScene<M>::reset() {
  now_ = given_.start;
  hand_ = no_hand_;
  hand_impulse_.setZero();
  stopped_.clear();
}

template <class M>
double HeldScene<M>::reach(int body) const {
  if (given_.reach > 0) return given_.reach;
  const Scene<M>& scene = now_.scene;
  if constexpr (M::angular > 0) {
    if (has_shapes(scene)) {
      const Shape<M>& shape = scene.colliders().shapes[body];
      if (const auto* box = std::get_if<byhand::Box<M>>(&shape)) return box->half().norm();
      if (const auto* ball = std::get_if<Ball<M>>(&shape)) return ball->radius;
    }
    return 40 / camera_.scale;
  } else {
    const Linkage linkage = rods_and_bobs(scene);
    const Linkage::Bob bob{scene.bodies().pose[body].position, 1 / scene.bodies().inverse_mass[body].linear};
    return bob_radius(linkage, bob, style_of(linkage, camera_.scale)) / camera_.scale;
  }
}

template <class M>
std::vector<course::Held::Body> HeldScene<M>::bodies() const {
  const Bodies<M>& bodies = now_.scene.bodies();
  std::vector<Body> all;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      all.push_back({given_.body, camera_.to_page(seen(bodies.pose[i].position)), reach(i) * camera_.scale});
  if (all.size() > 1)
    for (std::size_t i = 0; i < all.size(); ++i) all[i].name += " " + std::to_string(i + 1);
  return all;
}

template <class M>
int HeldScene<M>::held() const {
  if (!hand_.grip()) return -1;
  const auto& mass = now_.scene.bodies().inverse_mass;
  return static_cast<int>(std::count_if(mass.begin(), mass.begin() + hand_.grip()->body, moves<M>));
}

template <class M>
Linear<M> HeldScene<M>::in_world_at(const Point& at, const Linear<M>& beside) const {
  return beside + given_.seen.transpose() * Eigen::Vector2d(at - seen(beside));
}

template <class M>
bool HeldScene<M>::covers(int body, const Point& point) const {
  const Pose<M>& pose = now_.scene.bodies().pose[body];
  const double beside = slack / camera_.scale;
  if constexpr (M::angular == 1)
    if (has_shapes(now_.scene))
      if (const auto* box = std::get_if<byhand::Box<M>>(&now_.scene.colliders().shapes[body]))
        return ((arm_to<M>(pose, point).cwiseAbs() - box->half()).array() <= beside).all();
  return (point - seen(pose.position)).norm() <= reach(body) + beside;
}

template <class M>
Arm<M> HeldScene<M>::arm_at(int body, const Point& point) const {
  if constexpr (M::angular == 0) {
    return {};
  } else {
    if (!has_shapes(now_.scene)) return Arm<M>::Zero();
    const Pose<M>& pose = now_.scene.bodies().pose[body];
    const Arm<M> arm = arm_to<M>(pose, in_world_at(point, pose.position));
    if constexpr (M::angular == 3)
      if (const auto* box = std::get_if<byhand::Box<M>>(&now_.scene.colliders().shapes[body])) {
        // Where the line of sight leaves the box, between the two planes of each pair.
        const Linear<M> right = given_.seen.row(0), up = given_.seen.row(1);
        const Arm<M> sight = rotate(inverse(pose.rotation), Linear<M>(right.cross(up)));
        double enters = -1e9, leaves = 1e9;  // [m]
        for (int axis = 0; axis < 3; ++axis)
          for (const double side : {-1, 1}) {
            const double way = (side * box->half()[axis] - arm[axis]) / sight[axis];
            if (side * sight[axis] > 0) leaves = std::min(leaves, way);
            if (side * sight[axis] < 0) enters = std::max(enters, way);
          }
        if (enters < leaves) return arm + leaves * sight;
      }
    return arm;
  }
}

template <class M>
int HeldScene<M>::body_at(const Point& point) const {
  const Bodies<M>& bodies = now_.scene.bodies();
  int nearest = -1;
  const auto distance = [&](int body) { return (point - seen(bodies.pose[body].position)).norm(); };
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]) && covers(i, point) && (nearest < 0 || distance(i) < distance(nearest)))
      nearest = i;
  return nearest;
}

template <class M>
void HeldScene<M>::grab(const Point& at) {
  release();
  const Point point = camera_.to_world(at);
  const int body = body_at(point);
  if (body < 0) return;
  const Arm<M> arm = arm_at(body, point);
  const Pose<M>& pose = now_.scene.bodies().pose[body];
  hand_.take(now_.scene, body, arm, in_world_at(point, anchor<M, double>(pose, in_world<M, double>(pose, arm))));
}

template <class M>
void HeldScene<M>::move(const Point& to) {
  if (hand_.grip())
    hand_.move(now_.scene, in_world_at(camera_.to_world(to), now_.scene.bodies().pose[hand_.body()].position));
}

template <class M>
void HeldScene<M>::release() {
  hand_.release(now_.scene);
}

template <class M>
void HeldScene<M>::step() {
  if (!stopped_.empty()) return;
  const auto stop = [&](const std::string& how) {
    stopped_ = say("After @ s @. @", Value(now_.time, 3), how, given_.law);
  };
  try {
    now_.step(given_.h);
  } catch (const std::runtime_error& error) {
    return stop(say("the step failed: @", error.what()));
  }
  const Bodies<M>& bodies = now_.scene.bodies();
  if (const auto& grip = hand_.grip())
    for (int axis = 0; axis < 2; ++axis)
      hand_impulse_ += now_.impulse(grip->rows[axis])[0] * Linear<M>(given_.seen.row(axis).transpose());
  double moved = 0;
  for (const Velocity<M>& V : bodies.velocity)
    moved = std::max(moved, given_.h * V.template head<M::linear>().norm());
  if (moved > too_far * std::max(given_.view.width, given_.view.height))
    stop(say("the scene has flown apart: a body moves @ m in one step", Value(moved, 2)));
}

template <class M>
void HeldScene<M>::go_on_from(const Held& other) {
  const auto* that = dynamic_cast<const HeldScene*>(&other);
  if (!that || !that->stopped_.empty()) return;
  if (!begin_alike(given_.start.scene.bodies(), that->given_.start.scene.bodies())) return;
  now_.scene.state().pose = that->now_.scene.bodies().pose;
  now_.scene.state().velocity = that->now_.scene.bodies().velocity;
  now_.time = that->now_.time;
  hand_impulse_ = that->hand_impulse_;
  if (const auto& grip = that->hand_.grip())
    hand_.take(now_.scene, grip->body, grip->arm, that->now_.scene.bodies().pose[that->hand_.body()].position);
}

template <class M>
void HeldScene<M>::draw_hand(Canvas& canvas) const {
  const auto& grip = hand_.grip();
  if (!grip) return;
  const Pose<M>& pose = now_.scene.bodies().pose[grip->body];
  const Point hand = seen(now_.scene.bodies().pose[hand_.body()].position),
              point = seen(anchor<M, double>(pose, in_world<M, double>(pose, grip->arm)));
  canvas.line(point, hand, {palette::muted, 3, Dash::dashed});
  canvas.disc(hand, 9 / canvas.camera().scale, {fade(palette::highlight, 0.5), {palette::ink, 1.8}});
}

template <class M>
auto HeldScene<M>::next() const -> std::optional<Next> {
  if (!stopped_.empty()) return {};
  Simulation<M> next = now_;
  try {
    next.step(given_.h);
  } catch (const std::runtime_error&) {
    return {};
  }
  return Next{terms_of(now_, next, given_.h, given_.seen), next.scene.bodies().velocity};
}

template <class M>
void HeldScene<M>::draw(Canvas& canvas, std::optional<double> part) const {
  canvas.clip(page);
  canvas.look(camera_);
  const std::optional<Next> coming = part ? next() : std::nullopt;
  Scene<M> shown = now_.scene;
  if (coming && *part >= parts - 1)
    for (int i = 0; i < shown.bodies().size(); ++i)
      byhand::move(shown.state().pose[i], coming->velocity[i], share_of(*part) * given_.h);
  given_.draw ? given_.draw(canvas, shown) : draw_scene(canvas, shown);
  draw_hand(canvas);
  if (coming) draw_part(canvas, coming->terms, *part, 0.2 * std::min(given_.view.width, given_.view.height));
}

template <class M>
std::string HeldScene<M>::words(std::optional<double> part) const {
  if (const std::optional<Next> coming = part ? next() : std::nullopt) {
    const PartInWords now = in_words(coming->terms, static_cast<int>(*part));
    return now.formula + ". " + now.words;
  }
  const int constraints = now_.scene.count() + now_.work.contacts.constraints().count();
  const bool several = constraints > (hand_.grip() ? 3 : 1);
  const double error = course::without_rounding(position_error(now_).max, 1);
  return (given_.says ? given_.says(now_) + " " : "") +
         say("Time @ s: energy @ J, @|C| @ @, @impulse λ|l₂| @ N·s.", Value(now_.time, 4),
             Value(energy(now_.scene), 4), several ? "largest " : "", Value(error, 3), given_.unit_of_C,
             several ? "largest " : "", Value(largest_impulse(now_), 3));
}

template class HeldScene<PlaneParticle>;
template class HeldScene<PlaneBody>;
template class HeldScene<SpaceBody>;

}  // namespace byhand::pictures
