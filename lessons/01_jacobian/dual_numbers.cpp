#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <random>

#include "lessons/01_jacobian/picture.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"

// Dual numbers differentiate `value` to rounding; every J derived by hand is compared with them.
namespace byhand::lesson01 {
namespace {

/// J without a derivation: a dual number δ moves the bodies in one of the 2 dof ways after the other, and C(x + δ)
/// holds that way's column.
template <class M, class Kind>
auto gradient(const Kind& constraint, const Pose<M>& pose1, const Pose<M>& pose2) {
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  const Dual delta(0.0, 1, 0);
  Eigen::Matrix<double, Kind::rows, 2 * M::dof> J;
  for (int way = 0; way < J.cols(); ++way) {
    Velocity<M, Dual> nudge1 = Velocity<M, Dual>::Zero(), nudge2 = nudge1;
    (way < M::dof ? nudge1[way] : nudge2[way - M::dof]) = delta;
    const auto C = constraint.template value<Dual>(moved<M, Dual>(cast<Dual>(pose1), nudge1, Dual(1.0)),
                                                   moved<M, Dual>(cast<Dual>(pose2), nudge2, Dual(1.0)));
    for (int k = 0; k < J.rows(); ++k) J(k, way) = C[k].derivatives()[0];
  }
  return J;
}

/// Numbers in [−1, 1), the same in every run.
class Random {
 public:
  double operator()() { return static_cast<double>(engine_()) / 0x1p63 - 1; }
  template <class V>
  V vector() {
    V v;
    for (double& x : v) x = (*this)();
    return v;
  }

 private:
  std::mt19937_64 engine_{1992};
};

template <class M>
Pose<M> random_pose(Random& random, double size) {
  Pose<M> pose;
  pose.position = size * random.vector<Linear<M>>();
  if constexpr (M::angular == 1) pose.rotation = plane_rotation(3.0 * random());
  if constexpr (M::angular == 3)
    pose.rotation = space_rotation<double>(Angular<M>(3.0 * random.vector<Angular<M>>()));
  return pose;
}

template <class M>
Anchors<M> random_anchors(Random& random, double size) {
  Anchors<M> at{0, 1};
  if constexpr (M::angular > 0) at.arms = {size * random.vector<Linear<M>>(), size * random.vector<Linear<M>>()};
  return at;
}

/// The largest entry of |J by hand − J by dual numbers| over all kinds of constraint, over the largest of J.
template <class M>
double largest_difference(double size, int draws) {
  Random random;
  double largest = 0;
  for (int i = 0; i < draws; ++i) {
    const Pose<M> pose1 = random_pose<M>(random, size), pose2 = random_pose<M>(random, size);
    const Anchors<M> at = random_anchors<M>(random, size);
    const Linear<M> normal = random.vector<Linear<M>>().normalized();
    const auto compare = [&](const auto& constraint) {
      const auto by_hand = constraint.jacobian(pose1, pose2).matrix;
      const double difference = (by_hand - gradient<M>(constraint, pose1, pose2)).cwiseAbs().maxCoeff();
      largest = std::max(largest, difference / by_hand.cwiseAbs().maxCoeff());
    };
    compare(Distance<M>{at, size});
    compare(NormalisedDistance<M>{at, size});
    compare(Pin<M>{at});
    compare(Contact<M>{at, normal});
    compare(Friction<M>{at, tangents_of<M>(normal), 0.5});
  }
  return largest;
}

/// The error of Ċ by differences, over their step; and by dual numbers.
struct Accuracy {
  renderer::Chart chart;
  double dual = 0, best_one_sided = 1e300, best_centred = 1e300;
};

Accuracy accuracy(const Pair& pair) {
  Eigen::Matrix<double, 6, 1> V;
  V << pair.V1, pair.V2;
  // The reference is (14): it is exact, and the dual numbers are held against it in the same way.
  const double exact = pair.rate();
  const double dual = (gradient<PlaneBody>(pair.rod, pair.pose1, pair.pose2) * V)(0, 0);
  Accuracy all;
  all.dual = std::abs(dual - exact);
  renderer::Curve one{
      .label = "one-sided", .style = renderer::CurveStyle::line_and_markers, .colour = palette::force};
  renderer::Curve two{
      .label = "centred", .style = renderer::CurveStyle::line_and_markers, .colour = palette::error};
  const double still = 1e-16 * std::abs(exact);  // where a lucky difference of zero is drawn
  for (int i = 0; i <= 28; ++i) {
    const double step = std::pow(10, -1 - i / 2.0);
    const double one_sided = std::abs((pair.after(step).value() - pair.value()) / step - exact);
    const double centred = std::abs(difference(pair, step) - exact);
    all.best_one_sided = std::min(all.best_one_sided, one_sided);
    all.best_centred = std::min(all.best_centred, centred);
    one.x.push_back(step);
    one.y.push_back(std::max(one_sided, still));
    two.x.push_back(step);
    two.y.push_back(std::max(centred, still));
  }
  all.chart = {.x = {.label = "step of the difference (s)", .scale = renderer::Scale::logarithmic},
               .y = {.label = "error of Ċ (m²/s)", .scale = renderer::Scale::logarithmic},
               .curves = {one, two},
               .references = {{renderer::Reference::Across::y, std::max(all.dual, still), "dual numbers"}}};
  return all;
}

}  // namespace

void dual_numbers(course::Page& page, const Settings& set) {
  const Pair pair = pair_of(set);
  page.text(
      R"(Differences have two errors: a large step misses the curvature of C, and a small one drowns in rounding. But a
      program can be differentiated to the last digit. Give every number a second part, its derivative, (a, a′), and
      let + and × follow the rules of differentiation: (a, a′)(b, b′) = (ab, a′b + ab′). These are dual numbers. Fed
      with them, the line of code that computes C returns J as well (`gradient` in lessons/01_jacobian/dual_numbers.cpp).)");
  const Accuracy all = accuracy(pair);
  page.figure("accuracy", "The error of differences of C against their step. Dotted: the error of dual numbers.",
              all.chart);
  const bool rounding_only = all.dual <= 1e-12 * (1 + std::abs(pair.rate()));
  page.text(
      R"(With its best step the one-sided difference has an error of @ m²/s and the centred one of @ m²/s. @)",
      course::small_error(all.best_one_sided), course::small_error(all.best_centred),
      rounding_only ? std::string("The dual number's error is rounding alone; it has no step to choose.")
                    : course::say("The error of the dual number is @ m²/s.", course::small_error(all.dual)));
  constexpr int draws = 200;
  page.text(
      R"(So why derive by hand? (14) is four short expressions, cheap to compute, and it shows what no table of numbers
      can: what they mean and when they vanish. Dual numbers are the check. Below they check the J of five kinds of
      constraint at @ random poses, for particles and bodies, in the plane and in space.)",
      draws);
  const double tolerance = 100 * std::numeric_limits<double>::epsilon();
  const auto claim = [&](const char* model, double difference) {
    page.claim(course::say("J by hand against dual numbers, @, relative", model), difference, "1",
               is(tolerance, "a few hundred roundings", course::at_most()));
  };
  claim("particles in the plane", largest_difference<PlaneParticle>(set.length, draws));
  claim("bodies in the plane", largest_difference<PlaneBody>(set.length, draws));
  claim("particles in space", largest_difference<SpaceParticle>(set.length, draws));
  claim("bodies in space", largest_difference<SpaceBody>(set.length, draws));
}

}  // namespace byhand::lesson01
