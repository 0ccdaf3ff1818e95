#include "lessons/04_baumgarte/warm_chain.hpp"

#include <random>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::baumgarte {
namespace {

using Chain = Simulation<PlaneParticle>;

Chain chain(const Sweeping& sweeping, double length, double mass) {
  return {rod_chain<PlaneParticle, NormalisedDistance>(
              {.links = sweeping.links, .length = length, .mass = mass, .end_mass = mass}),
          {GaussSeidel{.sweeps = sweeping.sweeps, .warm_start = sweeping.warm}, Baumgarte{sweeping.beta}}};
}

/// Size of all that is wrong, and of what is remembered, in metres: errors, ways of a step, and what λ would move.
double size(const Chain& straight, double h) {
  double sum = 0;
  const auto& bodies = straight.scene.bodies();
  for (int i = 1; i < bodies.size(); ++i)
    sum += std::pow(bodies.pose[i].position.y() + i, 2) + bodies.velocity[i].squaredNorm() * h * h;
  for (const double lambda : straight.work.system.lambda) sum += lambda * lambda * h * h;
  return std::sqrt(sum);
}

void scale(Chain& straight, double by) {
  auto& bodies = straight.scene.state();
  for (int i = 1; i < bodies.size(); ++i) {
    double& y = bodies.pose[i].position.y();
    y = -i + by * (y + i);
    bodies.velocity[i] *= by;
  }
  for (double& lambda : straight.work.system.lambda) lambda *= by;
}

/// The largest size of an eigenvalue, by Gelfand's formula: the limit of |Mⁿ|^(1/n). (Eigen's solver takes ten
/// seconds to compile.)
double spectral_radius(Eigen::Matrix3d M) {
  double log_radius = 0;
  for (double share = 1; share > 1e-18; share /= 2) {  // M is squared: n doubles
    const double size = M.norm();
    if (size == 0) return 0;
    log_radius += share * std::log(size);
    M /= size;
    M = (M * M).eval();
  }
  return std::exp(log_radius);
}

double cold_growth(double q, double beta) {
  Eigen::Matrix3d companion;
  companion << 1 + q - (1 - q) * beta, -q, 0, 1, 0, 0, 0, 1, 0;
  return spectral_radius(companion);
}

}  // namespace

double growth_of_wave(double q, double beta) {
  Eigen::Matrix3d companion;
  companion << 1 + 2 * q - (1 - q) * beta, -3 * q, q, 1, 0, 0, 0, 1, 0;
  return spectral_radius(companion);
}

double measured_growth(const Sweeping& sweeping, double h, int steps) {
  constexpr double usual = 1e-4;  // small beside a link of 1 m, large beside its rounding
  Chain straight = chain(sweeping, 1, 1);
  straight.scene.gravity.setZero();
  std::mt19937 random(20261121);
  for (int i = 1; i <= sweeping.links; ++i)
    straight.scene.set_position(
        i, straight.scene.bodies().pose[i].position +
               usual * (static_cast<double>(random()) / 4294967296.0 - 0.5) * Linear<PlaneParticle>::UnitY());
  double log_size = 0, means[2] = {};
  for (int i = 0; i < 3 * steps; ++i) {
    const double before = size(straight, h);
    if (before < 1e-11) return 0;  // nothing but rounding is left within one step
    if (before > 10 * usual || before < usual / 10) scale(straight, usual / before);
    const double from = size(straight, h);
    straight.step(h);
    log_size += std::log(size(straight, h) / from);
    if (i >= steps) means[i / steps - 1] += log_size / steps;
  }
  return std::exp((means[1] - means[0]) / steps);
}

double growth_law(const Sweeping& sweeping) {
  const int n = sweeping.links;
  double largest = std::abs(1 - sweeping.beta);  // q = 0: the waves that a sweep removes at once
  for (int j = 1; 2 * j - 1 <= n; ++j) {
    const double q = laws::left_by_sweeps(n, sweeping.sweeps, j);
    largest = std::max(largest, sweeping.warm ? growth_of_wave(q, sweeping.beta) : cold_growth(q, sweeping.beta));
  }
  return largest;
}

struct HangingChain::State {
  Chain chain;
  double length, h;
};

HangingChain::HangingChain(const Sweeping& sweeping, double length, double mass, double h)
    : state_(new State{chain(sweeping, length, mass), length, h}) {
  const Linear<PlaneParticle>& last = state_->chain.scene.bodies().pose.back().position;
  state_->chain.scene.set_position(sweeping.links, {last.x(), last.y() - start_error * length});
}
HangingChain::HangingChain(const HangingChain& other) : state_(new State(*other.state_)) {}
HangingChain& HangingChain::operator=(const HangingChain& other) {
  *state_ = *other.state_;
  return *this;
}
HangingChain::~HangingChain() = default;

void HangingChain::step() {
  if (broken_up())
    state_->chain.time += state_->h;
  else
    state_->chain.step(state_->h);
}
bool HangingChain::broken_up() const { return !(largest_error() < 100 * state_->length); }
double HangingChain::time() const { return state_->chain.time; }
double HangingChain::largest_error() const { return position_error(state_->chain).max; }
pictures::Linkage HangingChain::linkage() const { return pictures::rods_and_bobs(state_->chain.scene); }

}  // namespace byhand::baumgarte
