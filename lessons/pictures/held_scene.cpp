#include "lessons/pictures/held_scene.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/pictures/acts.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "lessons/tutor/rounding.hpp"
#include "renderer/canvas.hpp"
#include "solver/measure.hpp"

namespace byhand::pictures {
namespace {

using namespace renderer;
using tutor::say;
using tutor::Value;

constexpr double slack = 12;         // how far beside a body it may be taken [points]
constexpr double too_far = 0.5;      // of the picture, in one step: a scene where a body moves so has flown apart
constexpr double hand_rate = 20;     // ω of the hand's springs [rad/s], damped critically
constexpr double hand_weights = 10;  // the hand's strength, over the weight of all bodies

template <class M>
bool has_shapes(const Scene<M>& scene) {
  return !scene.colliders().shapes.empty();
}

template <class M>
void draw_scene(Canvas& canvas, const Scene<M>& scene) {
  if constexpr (M::angular > 0)
    if (has_shapes(scene)) return pictures::draw(canvas, shapes_of(scene));
  pictures::draw(canvas, rods_and_bobs(scene));
}

template <class M>
bool begin_alike(const Bodies<M>& one, const Bodies<M>& other) {
  return std::equal(one.pose.begin(), one.pose.end(), other.pose.begin(), other.pose.end(),
                    [](const Pose<M>& a, const Pose<M>& b) {
                      if constexpr (M::angular > 0)
                        if (a.rotation.cos != b.rotation.cos || a.rotation.sin != b.rotation.sin) return false;
                      return a.position == b.position;
                    });
}

template <class M>
bool is_hand(const Scene<M>& scene, const Run& run) {
  return scene.store(run.kind).kind() == typeid(Pull<M>);
}

/// The largest impulse λ|l₂| of a row that is not the hand's [N s].
template <class M>
double largest_impulse(const Simulation<M>& simulation) {
  double largest = 0;
  const System<M>& system = simulation.work.system;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    if (is_hand(simulation.scene, run)) return;
    for (int k = 0; k < K; ++k) {
      const double impulse = system.lambda[block.row + k] * block.J.l2().row(k).norm();
      if (std::abs(impulse) > std::abs(largest)) largest = impulse;
    }
  });
  return largest;
}

struct Arrow {
  Point from, by;  // [m], [m/s]
  Colour colour;
};

/// What the terms of one step do to the velocities, at the bodies' middles.
struct Terms {
  std::vector<Arrow> before = {}, gravity = {}, rates = {}, changes = {}, after = {};
  double JV = 0, bias = 0, impulse = 0;  // of the row with the largest impulse: [m/s], [m/s], [N s]
};

template <class M>
Terms terms_of(const Simulation<M>& now, const Simulation<M>& next, double h) {
  Terms terms;
  Bodies<M> bodies = now.scene.bodies();
  const auto linear = [](const Velocity<M>& V) { return Point(V.template head<2>()); };
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Point at = bodies.pose[i].position;
    terms.before.push_back({at, linear(bodies.velocity[i]), palette::velocity});
    terms.gravity.push_back({at, h * gravity_on(bodies, i, now.scene.gravity), palette::velocity});
    terms.after.push_back({at, linear(next.scene.bodies().velocity[i]), palette::velocity});
  }
  add_gravity(bodies, now.scene.gravity, h);
  const System<M>& system = next.work.system;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    const Rows<K> JV = dot(block.J, bodies.velocity[block.body1], bodies.velocity[block.body2]);
    const bool hand = is_hand(next.scene, run);
    Linear<M> rate = Linear<M>::Zero(), change1 = Linear<M>::Zero(), change2 = Linear<M>::Zero();
    for (int k = 0; k < K; ++k) {
      const double lambda = system.lambda[block.row + k];
      const Linear<M> l2 = block.J.l2().row(k);
      const double length = l2.norm();
      if (lambda == 0 || length == 0) continue;
      rate += JV[k] / (length * length) * l2;
      change1 += lambda * Linear<M>(block.W.l1().row(k));
      change2 += lambda * Linear<M>(block.W.l2().row(k));
      if (hand || std::abs(lambda) * length <= std::abs(terms.impulse)) continue;
      terms.impulse = lambda * length;
      terms.JV = JV[k] / length;
      terms.bias = system.bias[block.row + k] / length;
    }
    const Point at1 = bodies.pose[block.body1].position, at2 = bodies.pose[block.body2].position;
    if (!hand)
      terms.rates.push_back(block.moves2 ? Arrow{at2, rate, palette::error} : Arrow{at1, -rate, palette::error});
    const Colour colour = hand ? palette::highlight : palette::force;
    if (block.moves1) terms.changes.push_back({at1, change1, colour});
    if (block.moves2) terms.changes.push_back({at2, change2, colour});
  });
  return terms;
}

double longest(std::initializer_list<const std::vector<Arrow>*> lists) {
  double most = 0;
  for (const auto* arrows : lists)
    for (const Arrow& arrow : *arrows) most = std::max(most, arrow.by.norm());
  return most;
}

/// Length on the picture [m] of 1 m/s, a power of two so that it rarely changes: the longest arrow gets `wanted`
/// [m] at most and more than half of it.
double arrow_scale(double most, double wanted) {
  int power = 0;
  std::frexp(wanted / std::max(most, 1e-9), &power);
  return std::ldexp(0.5, power);
}

void draw_arrows(Canvas& canvas, const std::vector<Arrow>& arrows, double scale, double share, bool past) {
  for (const Arrow& arrow : arrows)
    if (scale * canvas.camera().scale * arrow.by.norm() > 2)
      draw_growing(canvas, arrow.from, scale * arrow.by, share,
                   {arrow.colour, past ? 1.8 : 4.5, past ? Dash::dashed : Dash::solid});
}

}  // namespace

template <class M>
HeldScene<M>::HeldScene(InHand<M> given)
    : given_(std::move(given)),
      now_(given_.start),
      camera_(fit(given_.view, {page.x, page.y + 40, page.width, page.height - 140}, 20)) {
  Scene<M>& scene = given_.start.scene;
  double mass = 0;
  for (const InverseMass<M>& inverse : scene.bodies().inverse_mass)
    if (moves(inverse)) mass += 1 / inverse.linear;
  strength_ = hand_weights * mass * std::max(scene.gravity.norm(), 1.0);
  hand_ = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  reset();
}

template <class M>
void HeldScene<M>::reset() {
  now_ = given_.start;
  grip_.reset();
  hand_impulse_.setZero();
  stopped_.clear();
}

template <class M>
double HeldScene<M>::reach(int body) const {
  const Scene<M>& scene = now_.scene;
  if constexpr (M::angular > 0) {
    if (has_shapes(scene)) {
      const Shape<M>& shape = scene.colliders().shapes[body];
      if (const auto* box = std::get_if<byhand::Box<M>>(&shape)) return box->half().norm();
      if (const auto* ball = std::get_if<Ball<M>>(&shape)) return ball->radius;
    }
    return 40 / camera_.scale;
  } else {
    const Bodies<M>& bodies = scene.bodies();
    return bob_radius(rods_and_bobs(scene), {bodies.pose[body].position, 1 / bodies.inverse_mass[body].linear}) /
           camera_.scale;
  }
}

template <class M>
std::vector<tutor::Held::Body> HeldScene<M>::bodies() const {
  const Bodies<M>& bodies = now_.scene.bodies();
  std::vector<Body> all;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      all.push_back({given_.body, camera_.to_page(bodies.pose[i].position), reach(i) * camera_.scale});
  if (all.size() > 1)
    for (std::size_t i = 0; i < all.size(); ++i) all[i].name += " " + std::to_string(i + 1);
  return all;
}

template <class M>
int HeldScene<M>::held() const {
  if (!grip_) return -1;
  const auto& mass = now_.scene.bodies().inverse_mass;
  return static_cast<int>(std::count_if(mass.begin(), mass.begin() + grip_->body, moves<M>));
}

template <class M>
bool HeldScene<M>::covers(int body, const Linear<M>& point) const {
  const Pose<M>& pose = now_.scene.bodies().pose[body];
  const double beside = slack / camera_.scale;
  if constexpr (M::angular > 0)
    if (has_shapes(now_.scene))
      if (const auto* box = std::get_if<byhand::Box<M>>(&now_.scene.colliders().shapes[body]))
        return ((arm_to<M>(pose, point).cwiseAbs() - box->half()).array() <= beside).all();
  return (point - pose.position).norm() <= reach(body) + beside;
}

template <class M>
int HeldScene<M>::body_at(const Linear<M>& point) const {
  const Bodies<M>& bodies = now_.scene.bodies();
  int nearest = -1;
  const auto distance = [&](int body) { return (point - bodies.pose[body].position).norm(); };
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]) && covers(i, point) && (nearest < 0 || distance(i) < distance(nearest)))
      nearest = i;
  return nearest;
}

template <class M>
void HeldScene<M>::grab(const Point& at) {
  release();
  const Linear<M> point = camera_.to_world(at);
  const int body = body_at(point);
  if (body < 0) return;
  if constexpr (M::angular > 0)
    hold(body, has_shapes(now_.scene) ? arm_to<M>(now_.scene.bodies().pose[body], point) : Arm<M>(Arm<M>::Zero()),
         point);
  else
    hold(body, {}, point);
}

template <class M>
void HeldScene<M>::hold(int body, const Arm<M>& arm, const Linear<M>& hand) {
  now_.scene.set_position(hand_, hand);
  grip_ = Grip{body, arm, {}};
  for (int axis = 0; axis < 2; ++axis) {
    Pull<M> pull{.at = {hand_, body}, .along = Linear<M>::Unit(axis), .strength = strength_ / std::sqrt(2.0)};
    if constexpr (M::angular > 0) pull.at.arms.second = arm;
    pull.elastic = tuned(now_.scene.bodies(), pull, hand_rate, 1);
    grip_->rows[axis] = now_.scene.add(pull);
  }
}

template <class M>
void HeldScene<M>::move(const Point& to) {
  if (grip_) now_.scene.set_position(hand_, camera_.to_world(to));
}

template <class M>
void HeldScene<M>::release() {
  if (!grip_) return;
  for (const auto& row : grip_->rows) now_.scene.remove(row);
  grip_.reset();
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
  if (grip_)
    for (int axis = 0; axis < 2; ++axis)
      hand_impulse_[axis] += now_.work.system.lambda[now_.work.system.row_of[now_.scene.place(grip_->rows[axis])]];
  double moved = 0;
  for (const Velocity<M>& V : bodies.velocity) moved = std::max(moved, given_.h * V.template head<2>().norm());
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
  if (that->grip_) hold(that->grip_->body, that->grip_->arm, now_.scene.bodies().pose[hand_].position);
}

template <class M>
void HeldScene<M>::draw_hand(Canvas& canvas) const {
  if (!grip_) return;
  const Pose<M>& pose = now_.scene.bodies().pose[grip_->body];
  const Point hand = now_.scene.bodies().pose[hand_].position,
              point = anchor<M, double>(pose, in_world<M, double>(pose, grip_->arm));
  canvas.line(point, hand, {palette::highlight, 3, Dash::dashed});
  canvas.disc(hand, 9 / canvas.camera().scale, {fade(palette::highlight, 0.5), {palette::ink, 1.8}});
}

template <class M>
void HeldScene<M>::draw(Canvas& canvas, std::optional<double> part) const {
  canvas.clip(page);
  canvas.look(camera_);
  if (part && stopped_.empty()) return draw_within(canvas, *part);
  draw_scene(canvas, now_.scene);
  draw_hand(canvas);
}

template <class M>
void HeldScene<M>::draw_within(Canvas& canvas, double part) const {
  Simulation<M> next = now_;
  try {
    next.step(given_.h);
  } catch (const std::runtime_error&) {
    return draw(canvas);
  }
  const Terms terms = terms_of(now_, next, given_.h);
  const double wanted = 0.3 * std::min(given_.view.width, given_.view.height);
  const double speeds = arrow_scale(longest({&terms.before, &terms.after}), wanted),
               changes = arrow_scale(longest({&terms.gravity, &terms.rates, &terms.changes}), wanted);
  const int present = std::clamp(static_cast<int>(part), 0, parts - 1);
  const double share = eased((part - present) / 0.8);  // moves, then holds

  Simulation<M> seen = now_;
  if (present == parts - 1) {
    seen.scene.state().velocity = next.scene.bodies().velocity;
    advance_poses(seen.scene.state(), share * given_.h);
  }
  draw_scene(canvas, seen.scene);
  draw_hand(canvas);
  const auto term = [&](int from, int until, const std::vector<Arrow>& arrows, double scale) {
    if (present >= from && present <= until)
      draw_arrows(canvas, arrows, scale, present == from ? share : 1, present > from);
  };
  term(0, 4, terms.before, speeds);
  term(1, 2, terms.gravity, changes);
  term(2, 3, terms.rates, changes);
  term(3, 4, terms.changes, changes);
  term(4, 5, terms.after, speeds);

  const double h = given_.h, gain = h * now_.scene.gravity.norm();
  const auto real = [&](double value) { return Value(tutor::without_rounding(value, 1e3 * gain), 3); };
  double far = 0;
  for (const Arrow& arrow : terms.after) far = std::max(far, 1000 * h * arrow.by.norm());
  const std::string largest = now_.scene.count() > 1 ? " Here that of the largest λ." : "";
  struct Said {
    std::string formula, words;
    Colour colour;
  };
  const Said said[] = {
      {"V", say("The velocities before the step, @ m/s at most.", real(longest({&terms.before}))),
       palette::velocity},
      {say("V + gh,  gh = @ m/s", real(gain)), "Gravity adds gh to each, before anything is solved.",
       palette::velocity},
      {say("JV/|l_2| = @ m/s,  b/|l_2| = @ m/s", real(terms.JV), real(terms.bias)),
       "How fast C would change, for each row along its J." + largest, palette::error},
      {say("λ|l_2| = @ N·s", real(terms.impulse)), "M⁻¹J^Tλ: what each impulse changes of V, along J." + largest,
       palette::force},
      {say("V + M⁻¹J^Tλ,  @ m/s at most", real(longest({&terms.after}))),
       "What is left: the velocities after the step.", palette::velocity},
      {say("hV,  @ mm at most", real(far)), "The poses move along these velocities for h.", palette::ink}};
  canvas.look_at_page();
  const Said& now = said[present];
  canvas.text({24, page.top() - 16}, now.formula,
              {.size = 27, .colour = now.colour, .anchor = Anchor::top_left, .bold = true});
  canvas.text({24, page.top() - 58}, now.words, {.size = 21, .anchor = Anchor::top_left});
  canvas.look(camera_);
  canvas.arrow_key({24, 20}, {palette::velocity, speeds, "m/s"}, "V:");
  if (present >= 1 && present <= 4)
    canvas.arrow_key({page.width / 2, 20}, {now.colour, changes, "m/s"}, "changes of V:");
}

template <class M>
std::string HeldScene<M>::words() const {
  const double error = position_error(now_.scene).max;
  return say("Time @ s: energy @ J, |C| @@ @, impulse λ|l₂| @@ N·s.", Value(now_.time, 4),
             Value(energy(now_.scene), 4), now_.scene.count() > 1 ? "at most " : "",
             Value(tutor::without_rounding(error, 1), 3), given_.unit_of_C,
             now_.scene.count() > 1 ? "at most " : "", Value(largest_impulse(now_), 3));
}

template class HeldScene<PlaneParticle>;
template class HeldScene<PlaneBody>;

}  // namespace byhand::pictures
