#include "lessons/exact/swinging_chain.hpp"

#include <cmath>

#include "lessons/exact/certified_integration.hpp"
#include "solver/support/require.hpp"

namespace byhand {
namespace {

using Number = long double;

struct Vector {
  Number x = 0, y = 0;
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
Vector operator*(Number s, Vector a) { return {s * a.x, s * a.y}; }
Number dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

/// A symmetric matrix.
struct Symmetric {
  Number xx = 0, xy = 0, yy = 0;
};
Vector operator*(const Symmetric& K, Vector a) { return {K.xx * a.x + K.xy * a.y, K.xy * a.x + K.yy * a.y}; }

/// What the joint above a link tells it of all below: the force on the link is K A + k for an acceleration A of
/// the joint, and its angular acceleration is (s - u·A)/D.
struct Articulated {
  Vector e, n, u;  // along the link, and the way in which it turns
  Number s = 0, D = 1;
};

}  // namespace

SwingingChain::SwingingChain(std::vector<Link> links, double angle, double gravity)
    : links_(std::move(links)), angle_(angle), gravity_(gravity) {
  require(!links_.empty(), "number of links", links_.size(), "at least 1");
  require_finite("angle of the chain", angle, "rad");
  require_positive("gravity", gravity, "m/s²");
  for (const Link& link : links_) {
    require_positive("length of a link", link.length, "m");
    require_positive("distance of a link's centre", link.centre, "m");
    require_positive("mass of a link", link.mass, "kg");
    require_in("inertia of a link", link.inertia, 0, 1e300, "kg m²");
  }
}

// With A the acceleration of its upper joint, a the way to its centre and l to its lower joint, a link has
//   its centre at       A + a (n θ̈ - e θ̇²),        its lower joint at A' = A + l (n θ̈ - e θ̇²)
//   forces              f = m (A + a (n θ̈ - e θ̇²) - g) + f',        f' = K' A' + k'
//   moments             I θ̈ = -a n·f - (l - a) n·f'
// from which f' and f go: D θ̈ = s - u·A and f = K A + k. From the free end, where K' = k' = 0, to the origin,
// where A = 0; then back with A.
SwingingChain::State SwingingChain::at(double time, double tolerance) const {
  const std::size_t count = links_.size();
  const Vector g{0, -static_cast<Number>(gravity_)};
  std::vector<Articulated> parts(count);
  const auto rate = [&](const ExtendedState& x, ExtendedState& dxdt) {
    Symmetric K;
    Vector k;
    for (std::size_t i = count; i-- > 0;) {
      const Number a = links_[i].centre, l = links_[i].length, m = links_[i].mass;
      const Number sine = std::sin(x[i]), cosine = std::cos(x[i]), square = x[count + i] * x[count + i];
      const Vector e{sine, -cosine}, n{cosine, sine}, Kn = K * n;
      const Vector u = a * m * n + l * Kn;
      const Number D = links_[i].inertia + m * a * a + l * l * dot(n, Kn);
      const Number s = a * m * dot(n, g) + l * l * square * dot(e, Kn) - l * dot(n, k);
      k = (s / D) * u + (-square) * (m * a * e + l * (K * e)) + (-m) * g + k;
      K = {K.xx + m - u.x * u.x / D, K.xy - u.x * u.y / D, K.yy + m - u.y * u.y / D};
      parts[i] = {e, n, u, s, D};
    }
    Vector A;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [e, n, u, s, D] = parts[i];
      const Number turn = (s - dot(u, A)) / D, square = x[count + i] * x[count + i];
      dxdt[i] = x[count + i];
      dxdt[count + i] = turn;
      A = A + static_cast<Number>(links_[i].length) * (turn * n + (-square) * e);
    }
  };
  std::vector<double> start(2 * count, 0.0);
  std::fill_n(start.begin(), count, angle_);
  const Certified end = certified_integration(rate, start, time, tolerance);

  State state;
  state.uncertainty = end.uncertainty;
  Eigen::Vector2d joint(0, 0), moving(0, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = end.state[i], spin = end.state[count + i];
    const Eigen::Vector2d e(std::sin(angle), -std::cos(angle)), turning = spin * Eigen::Vector2d(-e.y(), e.x());
    state.positions.push_back(joint + links_[i].centre * e);
    state.velocities.push_back(moving + links_[i].centre * turning);
    joint += links_[i].length * e;
    moving += links_[i].length * turning;
  }
  return state;
}

}  // namespace byhand
