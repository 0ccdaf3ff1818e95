#pragma once

#include "solver/integrate/euler.hpp"
#include "solver/scene.hpp"

// Bodies that meet faster than a threshold part with a share e of their speed. Where several contacts meet,
// Moreau's law holds for all of them at once:
//
//   0 <= λ ⟂ JV⁺ + eJV⁻ >= 0,   that is (21) with b = eJV⁻, for each contact that pressed or was parting.
//
// With one e for all and without friction V⁺ is V⁻ reflected, by e, in the cone of velocities that part: energy
// does not grow. (Newton's law for those that approach alone, JV⁺ = -eJV⁻, with JV⁺ >= 0 for the others, gained
// energy in piles, up to 36 times of it.)
//
// Bodies meet within the step, after a fall through the gap C. Steps of h under an acceleration a of the row, g
// for a ball, pass through the points of a parabola that begins with the rate JV⁻ + ah/2. They meet at the rate
// -w, and what parts at e w begins another parabola:
//
//   w² = (JV⁻ + ah/2)² - 2aC,     JV⁺ + ah/2 = e w,
//
// so that the n-th peak of a ball is e²ⁿ times as high as it fell, at any h. (Derived here.) The rows are solved a
// second time once the positions have moved: an open contact closes its gap first, so that a ball bounces on the
// ground and not above it. The second solve continues from the accumulated λ, so that a contact that opens can
// take back its whole impulse.
//
// With friction, or where surfaces differ in e, the second solve can make energy: 2.6 times of it was seen. What
// it makes is taken back, by moving V back towards what it was without the bounce. Between parabolas the energy is
//
//   E(V⁺ + ah/2) <= E(V - M⁻¹Jᵀλ - ah/2) + ma·(x⁺ - x) - λᵀ(target rate + J of fixed bodies that move),
//
// V - M⁻¹Jᵀλ being the velocities that the step would have without contacts.
//
// In space the inertia of a body turns with it from the pose of the rows to that of the bounce, and with W of the
// one and ω of the other a slender bar gained 30 times its energy within a second. So the second solve has ω as
// the body turns it back, R⁻¹ω, and what comes of it is turned on: its energy is the same in both.
//
// Source: J. J. Moreau, Unilateral contact and dry friction in finite freedom dynamics, CISM 302, 1988.
namespace byhand {

/// How many rows of a block, the first, may bounce.
template <int K, Bound B>
constexpr int bouncing = B == Bound::interval ? 1 : normals<K, B>;

//! [parting]
/// The least JV⁺ of a contact that approaches at `rate` [m/s], and by `fall` = ah more at the step's end, with
/// `gap` = C/h: positive if it bounces, negative if it was parting and may turn back, 0 if it meets at no more
/// than `threshold`.
inline double parting_rate(double e, double rate, double fall, double gap, double threshold) {
  const double begins = rate + fall / 2, meets = std::sqrt(begins * begins - 2 * fall * std::max(0.0, gap));
  if (begins > 0) return -e * begins;
  return meets > threshold ? e * meets - fall / 2 : 0;
}
//! [parting]

/// Sets `parting` to that rate for the rows of contacts, before forces act, and to 0 for others; empties it if no
/// surface bounces.
template <class M>
void note_parting(const Scene<M>& scene, double h, double threshold, const System<M>& system,
                  std::vector<double>& parting) {
  parting.clear();
  if (!system.bounded || std::ranges::all_of(system.restitution, [](double e) { return e == 0; })) return;
  parting.assign(system.rows(), 0.0);
  const std::vector<Velocity<M>>& V = scene.bodies().velocity;
  const auto fall = [&](int body, bool moves) {
    Velocity<M> gain = h * applied_acceleration(scene.bodies(), body);
    if (moves) gain.template head<M::linear>() += h * gravity_on(scene.bodies(), body, scene.gravity);
    return gain;
  };
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    if constexpr (constexpr int count = bouncing<K, B>; count > 0)
      for (const auto& block : blocks) {
        const int row = block.row;
        if (system.restitution[row] == 0) continue;
        const Rows<K> rate = dot(block.J, V[block.body1], V[block.body2]),
                      gain = dot(block.J, fall(block.body1, block.moves1), fall(block.body2, block.moves2));
        for (int k = 0; k < count; ++k)
          parting[row + k] =
              parting_rate(system.restitution[row], rate[k], gain[k], system.C[row + k] / h, threshold);
      }
  });
}

/// Sets the bias of the rows that pressed and bounce, if there are any, and of those that were parting. Returns
/// whether any bounces.
//! [bounce]
template <class M>
bool set_bounce(const std::vector<double>& parting, System<M>& system) {
  bool any = false;
  for (std::size_t row = 0; row < parting.size(); ++row)
    if (parting[row] > 0 && system.lambda[row] > 0)
      system.bias[row] = -parting[row], any = true;
    else if (parting[row] < 0)
      system.bias[row] = std::max(system.bias[row], -parting[row]);
  return any;
}
//! [bounce]

/// Takes back what a bounce within h [s] has made of energy. `lambda` and `velocity` are those before it.
template <class M>
void limit_bounce(const Scene<M>& scene, double h, const std::vector<double>& lambda,
                  const std::vector<Velocity<M>>& velocity, System<M>& system, Bodies<M>& bodies);

/// Clears λ of those rows: they part, so that the next step must not start with their impulse.
template <class M>
void forget_bounce(const std::vector<double>& parting, System<M>& system) {
  for (std::size_t row = 0; row < parting.size(); ++row)
    if (parting[row] > 0) system.lambda[row] = 0;
}

}  // namespace byhand
