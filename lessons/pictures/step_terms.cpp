#include "lessons/pictures/step_terms.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/page/rounding.hpp"
#include "lessons/pictures/acts.hpp"
#include "lessons/scenes/pull.hpp"

namespace byhand::pictures {

using namespace renderer;
using course::say;
using course::Value;

namespace {

using Arrows = std::vector<StepTerms::Arrow>;

double longest_of(std::initializer_list<const Arrows*> lists) {
  double most = 0;
  for (const Arrows* arrows : lists)
    for (const StepTerms::Arrow& arrow : *arrows) most = std::max(most, arrow.by.norm());
  return most;
}

/// Length on the picture [m] of 1 m/s, a power of two so that it rarely changes: the longest arrow gets `wanted`
/// [m] at most and more than half of it.
double arrow_scale(double most, double wanted) {
  int power = 0;
  std::frexp(wanted / std::max(most, 1e-9), &power);
  return std::ldexp(0.5, power);
}

void draw_list(Canvas& canvas, const Arrows& arrows, double scale, double share, bool past) {
  for (const StepTerms::Arrow& arrow : arrows)
    if (scale * canvas.camera().scale * arrow.by.norm() > 2)
      draw_growing(canvas, arrow.from, scale * arrow.by, share,
                   {arrow.colour, past ? 2.0 : 6.0, past ? Dash::dashed : Dash::solid});
}

}  // namespace

template <class M>
StepTerms terms_of(const Simulation<M>& now, const Simulation<M>& next, double h, const Seen<M>& seen) {
  StepTerms terms{.gain = h * now.scene.gravity.norm()};
  Bodies<M> bodies = now.scene.bodies();
  const auto picture = [&](const Linear<M>& of) { return Point(seen * of); };
  const auto linear = [&](const Velocity<M>& V) { return picture(V.template head<M::linear>()); };
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Point at = picture(bodies.pose[i].position), after = linear(next.scene.bodies().velocity[i]);
    terms.before.push_back({at, linear(bodies.velocity[i]), palette::velocity});
    terms.gravity.push_back(
        {at, picture(h * Linear<M>(gravity_on(bodies, i, now.scene.gravity))), palette::velocity});
    terms.after.push_back({at, after, palette::velocity});
    terms.way = std::max(terms.way, h * next.scene.bodies().velocity[i].template head<M::linear>().norm());
  }
  add_gravity(bodies, now.scene.gravity, h);
  std::vector<Linear<M>> pushed(bodies.size(), Linear<M>::Zero()), pulled = pushed;
  const System<M>& system = next.work.system;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    const Rows<K> JV = dot(block.J, bodies.velocity[block.body1], bodies.velocity[block.body2]);
    const bool hand = next.scene.store(run, next.work.contacts.constraints()).kind() == typeid(Pull<M>);
    std::vector<Linear<M>>& changed = hand ? pulled : pushed;
    Linear<M> rate = Linear<M>::Zero();
    for (int k = 0; k < K; ++k) {
      const double lambda = system.lambda[block.row + k];
      const Linear<M> l2 = block.J.l2().row(k);
      const double length = l2.norm();
      if (lambda == 0 || length == 0) continue;
      rate += JV[k] / (length * length) * l2;
      changed[block.body1] += lambda * Linear<M>(block.W.l1().row(k));
      changed[block.body2] += lambda * Linear<M>(block.W.l2().row(k));
      if (hand) continue;
      ++terms.rows;
      if (std::abs(lambda) * length <= std::abs(terms.impulse)) continue;
      terms.impulse = lambda * length;
      terms.JV = JV[k] / length;
      terms.bias = system.bias[block.row + k] / length;
    }
    if (hand) return;
    const int moving = block.moves2 ? block.body2 : block.body1;
    terms.rates.push_back(
        {picture(bodies.pose[moving].position), picture(block.moves2 ? rate : -rate), palette::error});
  });
  for (int i = 0; i < bodies.size(); ++i) {
    const Point at = picture(bodies.pose[i].position);
    terms.changes.push_back({at, picture(pushed[i]), palette::force});
    terms.changes.push_back({at, picture(pulled[i]), palette::highlight});
  }
  return terms;
}
template StepTerms terms_of(const Simulation<PlaneParticle>&, const Simulation<PlaneParticle>&, double,
                            const Seen<PlaneParticle>&);
template StepTerms terms_of(const Simulation<PlaneBody>&, const Simulation<PlaneBody>&, double,
                            const Seen<PlaneBody>&);
template StepTerms terms_of(const Simulation<SpaceParticle>&, const Simulation<SpaceParticle>&, double,
                            const Seen<SpaceParticle>&);
template StepTerms terms_of(const Simulation<SpaceBody>&, const Simulation<SpaceBody>&, double,
                            const Seen<SpaceBody>&);

PartInWords in_words(const StepTerms& terms, int part) {
  const auto real = [&](double value) { return Value(course::without_rounding(value, 1e3 * terms.gain), 3); };
  switch (part) {
    case 0:
      return {"V", say("The velocities before the step, @ m/s at most.", real(longest_of({&terms.before}))),
              palette::velocity};
    case 1:
      return {say("V + gh, gh = @ m/s", real(terms.gain)), "Gravity adds gh to each, before anything is solved.",
              palette::velocity};
    case 2:
      return {say("JV/|l₂| = @ m/s, b/|l₂| = @ m/s", real(terms.JV), real(terms.bias)),
              terms.rows > 1 ? "How fast C would change, along J; above for the row with the largest λ."
                             : "How fast C would change, along J.",
              palette::error};
    case 3:
      return {say("λ|l₂| = @ N·s", real(terms.impulse)),
              terms.rows > 1 ? "M⁻¹Jᵀλ: what all impulses change of V; above the largest of them."
                             : "M⁻¹Jᵀλ: what the impulse changes of V, along J.",
              palette::force};
    case 4:
      return {say("V + M⁻¹Jᵀλ, @ m/s at most", real(longest_of({&terms.after}))),
              "What is left: the velocities after the step.", palette::velocity};
    default:
      return {say("hV, @ mm at most", real(1000 * terms.way)), "The poses move along these velocities for h.",
              palette::ink};
  }
}

double share_of(double part) { return eased((part - std::floor(part)) / 0.8); }

void draw_arrows(Canvas& canvas, const StepTerms& terms, double part, double longest) {
  const int present = static_cast<int>(part);
  const double least = 0.2 * terms.gain;  // or rest, which is rounding, would look like motion
  const double speeds = arrow_scale(std::max(longest_of({&terms.before, &terms.after}), least), longest),
               changes = arrow_scale(std::max(longest_of({&terms.gravity, &terms.rates, &terms.changes}), least),
                                     longest);
  // Each comes in with its part and stays for a while, dashed.
  const auto term = [&](int first, int last, const Arrows& arrows, double scale) {
    if (first <= present && present <= last)
      draw_list(canvas, arrows, scale, present == first ? share_of(part) : 1, present > first);
  };
  term(0, 4, terms.before, speeds);
  term(1, 2, terms.gravity, changes);
  term(2, 3, terms.rates, changes);
  term(3, 4, terms.changes, changes);
  term(4, 5, terms.after, speeds);

  canvas.arrow_key({24, 20}, {palette::velocity, speeds, "m/s"}, "V:");
  if (present >= 1 && present <= 4)
    canvas.arrow_key({24, 46}, {in_words(terms, present).colour, changes, "m/s"}, "changes of V:");
}

void draw_part(Canvas& canvas, const StepTerms& terms, double part, double longest) {
  draw_arrows(canvas, terms, part, longest);
  const Camera world = canvas.camera();
  const auto [formula, words, colour] = in_words(terms, static_cast<int>(part));
  canvas.look_at_page();
  const double top = canvas.page().top();
  canvas.text({24, top - 16}, formula,
              {.size = 30, .colour = colour, .anchor = Anchor::top_left, .bold = true, .halo = 5});
  canvas.text({24, top - 62}, words, {.size = 24, .anchor = Anchor::top_left, .halo = 5});
  canvas.look(world);
}

}  // namespace byhand::pictures
