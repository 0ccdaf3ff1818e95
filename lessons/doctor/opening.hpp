#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "lessons/doctor/sizes.hpp"

// How far a scene has come apart, beside its own bodies: what the doctor and its tests call a failure.
namespace byhand::doctor {

inline constexpr double share_of_a_body = 0.1;  // a gap of this share of a body is a failure
inline constexpr double visible = 0.05;         // if it lasts as long [s]: an impact's gap of a frame is not seen
inline constexpr double obvious = 0.5;          // or if it is as large, however short

/// The thickness of each body's shape [m]; 0 without one, and of a half space.
template <class M>
std::vector<double> thicknesses(const Scene<M>& scene) {
  return lengths_of_shapes(scene, [](const Linear<M>& sides) { return sides.minCoeff(); });
}

/// Whether something adds energy: motors, servos, springs, and fixed bodies that move.
template <class M>
bool is_driven(const Scene<M>& scene) {
  for (int i = 0; i < scene.bodies().size(); ++i)
    if (!moves(scene.bodies().inverse_mass[i]) && !scene.bodies().velocity[i].isZero(0)) return true;
  if (!scene.template all<Spring<M>>().empty()) return true;
  if constexpr (M::angular > 0)
    return !scene.template all<Motor<M, Turn>>().empty() || !scene.template all<Motor<M, Slide>>().empty() ||
           !scene.template all<Servo<M, Turn>>().empty() || !scene.template all<Servo<M, Slide>>().empty();
  return false;
}

/// What it takes to lift all bodies by the length of the smallest [J]; 0 without gravity.
template <class M>
double energy_of_a_lift(const Scene<M>& scene) {
  double weight = 0;
  for (const InverseMass<M>& mass : scene.bodies().inverse_mass)
    if (moves(mass)) weight += scene.gravity.norm() / mass.linear;
  const double smallest = smallest_of(sizes(scene));
  return weight > 0 && std::isfinite(smallest) ? weight * smallest : 0;
}

using Pair = std::pair<int, int>;  // of bodies

/// What has opened or sunk in the farthest of a scene.
struct Opening {
  double share = 0;  // of the shorter body's length at a joint, of the thinner body's thickness at a contact
  Pair bodies = {};
  bool joint = true;
};

/// Watches a run for joints that open and bodies that sink into each other, more than they did in the beginning.
template <class M>
class Watch {
 public:
  /// Overlaps up to `slop` [m] are a method's intention. `step` [s] is that between looks.
  Watch(const Scene<M>& begun, double slop, double step)
      : lengths_(sizes(begun)),
        thick_(thicknesses(begun)),
        slop_(slop),
        looks_(static_cast<std::size_t>(std::max(1.0, std::ceil(visible / step)))) {
    each_of(begun, [&](const Opening& one) {
      double& share = begun_[one.bodies];
      share = std::max(share, one.share);
    });
  }

  /// Looks at a scene; true if it has failed by now.
  bool look(const Scene<M>& scene) {
    Opening now;
    each_of(scene, [&](const Opening& one) {
      const auto at = begun_.find(one.bodies);
      if (!(one.share <= now.share) && !(at != begun_.end() && one.share <= 1.001 * at->second)) now = one;
    });
    last_.push_back(now.share);
    if (last_.size() > looks_) last_.pop_front();
    const double lasting = last_.size() < looks_ ? 0 : *std::min_element(last_.begin(), last_.end());
    const double share = std::max(lasting, now.share * share_of_a_body / obvious);
    if (!(share <= worst_.share)) worst_ = {share, now.bodies, now.joint};
    return !(worst_.share <= share_of_a_body);
  }
  /// Begins a run anew from another moment.
  void restart() { last_.clear(), worst_ = {}; }

  /// The largest opening that lasted: beyond share_of_a_body is a failure.
  const Opening& worst() const { return worst_; }

 private:
  /// Calls f with each joint and contact. Contacts are looked for where the bodies are now: those of a step were
  /// found where it began.
  template <class F>
  void each_of(const Scene<M>& scene, F&& f) {
    lay_out(scene, RowSolver(GaussSeidel{}), joints_);
    write_rows(scene, 1.0, joints_);
    const System<M>& system = joints_.system;
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      if (run.position_rows == 0) return;
      const double length = size_of_both(lengths_, block.body1, block.body2);
      double sum = 0;
      for (int k = 0; k < std::min(run.position_rows, M::linear); ++k) {
        const double C = system.C[block.row + k];
        const auto J = block.J.matrix.row(k);
        const bool turn =
            J.template segment<M::linear>(0).isZero(0) && J.template segment<M::linear>(M::dof).isZero(0);
        const double way = turn ? 0.5 * length * C : C;  // [m]: of an angle that of the body's end
        if (!one_sided(system, block, k) || C < 0) sum += way * way;
      }
      f(Opening{std::sqrt(sum) / length, std::minmax<int>(block.body1, block.body2), true});
    });
    touching_.find(scene);
    if constexpr (M::angular > 0)
      for (const ContactPair<M>& pair : touching_.pairs())
        for (int k = 0; k < pair.size; ++k) {
          const auto [one, two] = std::pair<int, int>(pair.bodies);
          const double apart = Anchors<M>{one, two, pair.points[static_cast<std::size_t>(k)].arms}
                                   .separation(scene.bodies().pose[one], scene.bodies().pose[two])
                                   .dot(pair.normal);
          if (apart < -slop_)
            f(Opening{(-apart - slop_) / size_of_both(thick_, one, two), std::minmax(one, two), false});
        }
  }

  std::vector<double> lengths_, thick_;  // of the bodies [m]
  double slop_;                          // [m]
  std::size_t looks_;                    // over which an opening has to last
  std::map<Pair, double> begun_;         // shares in the beginning
  std::deque<double> last_;
  Opening worst_;
  Work<M> joints_;              // without contacts
  ContactManager<M> touching_;  // where the bodies are when it looks
};

}  // namespace byhand::doctor
