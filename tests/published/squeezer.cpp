#include <fmt/format.h>

#include <array>

#include "lessons/methods/rattle.hpp"
#include "lessons/scenes/units.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/measure.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

using M = PlaneBody;

/// The direction of an angle from x.
Linear<M> along(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// A quarter turn clockwise from there.
Linear<M> across(double angle) { return along(angle - pi / 2); }

/// The angles β, Θ, γ, φ, δ, Ω, ε of the test set [rad].
struct Angles {
  double beta, theta, gamma, phi, delta, omega, epsilon;

  /// Of the seven bodies, K1 to K7.
  std::array<double, 7> bodies() const {
    return {beta, beta + theta, gamma, phi + delta, delta, omega + epsilon, epsilon};
  }
};
constexpr Angles start = {-0.0617138900142764496, 0,
                          0.455279819163070380,   0.222668390165885885,
                          0.487364979543842550,   -0.222668390165885885,
                          1.23054744454982119};
constexpr Angles at_30_ms = {15.81077119629904,  -15.75637105984298, 0.04082224013073101, -0.5347301163226948,
                             0.5244099658805304, 0.5347301163226948, 1.048080741042263};

constexpr double torque = 0.033, stiffness = 4530, length = 0.07785;  // [N m], [N/m], [m]

/// Andrews' squeezing mechanism, which lies flat: a motor turns the crank K1, whose rod K2 works three levers at
/// E. The spring from C to D of K3 is left out.
struct Squeezer {
  Scene<M> scene;
  Linear<M> C{0.014, 0.072};
  Arm<M> D;

  Squeezer() {
    const auto& [beta, theta, gamma, phi, delta, omega, epsilon] = start;
    const Linear<M> O(0, 0), A(-0.06934, -0.00227), B(-0.03635, 0.03273);
    const Linear<M> F = 0.007 * along(beta), E = F - 0.028 * along(beta + theta), G = A + 0.04 * along(delta),
                    H = A + 0.04 * across(epsilon);
    const auto add = [&](const Linear<M>& centre, double angle, double mass, double inertia) {
      Pose<M> pose;
      pose.position = centre;
      pose.rotation = plane_rotation(angle);
      scene.add_body(pose, with_mass<M>(mass, Angular<M>(inertia)));
    };
    scene.gravity.setZero();
    scene.add_body(O, fixed<M>());
    add(0.00092 * along(beta), beta, 0.04325, 2.194e-6);
    add(F - 0.0115 * along(beta + theta), beta + theta, 0.00365, 4.410e-7);
    add(B + 0.01043 * along(gamma) + 0.01874 * across(gamma), gamma, 0.02373, 5.255e-6);
    add(G + 0.00579 * across(phi + delta), phi + delta, 0.00706, 5.667e-7);
    add(A + 0.02308 * along(delta) - 0.00916 * across(delta), delta, 0.07050, 1.169e-5);
    add(H + 0.00579 * along(omega + epsilon), omega + epsilon, 0.00706, 5.667e-7);
    add(A + 0.01228 * across(epsilon) + 0.00449 * along(epsilon), epsilon, 0.05498, 1.912e-5);
    const auto join = [&](int body1, int body2, const Linear<M>& at) {
      scene.add(pin<M>(scene.bodies(), body1, body2, at));
    };
    join(0, 1, O), join(1, 2, F), join(0, 3, B), join(2, 3, E), join(2, 4, E), join(2, 6, E);
    join(4, 5, G), join(0, 5, A), join(6, 7, H), join(0, 7, A);
    D = arm_to<M>(scene.bodies().pose[3], Linear<M>(B + 0.02 * along(gamma) + 0.018 * across(gamma)));
  }
};

/// From C to D [m].
Linear<M> stretch(const Scene<M>& scene, const Squeezer& squeezer) {
  const Pose<M>& pose = scene.bodies().pose[3];
  return pose.position + rotate(pose.rotation, squeezer.D) - squeezer.C;
}

struct Run {
  Entry beta, worst, balance;  // β [rad], the largest error of the seven angles [rad], of the energy [J]
};

/// RATTLE with the spring's impulse half before and half after each step, which leaves its order at 2.
Run kicked(double h, double end, double angles, double energies) {
  const Squeezer squeezer;
  Simulation<M, Rattle> run{squeezer.scene};
  const auto kick = [&] {
    const Linear<M> d = stretch(run.scene, squeezer);
    run.scene.apply_impulse(3, Linear<M>(-h / 2 * stiffness * (1 - length / d.norm()) * d), squeezer.C + d);
  };
  const auto energy = [&] {
    const double longer = stretch(run.scene, squeezer).norm() - length;
    return kinetic_energy(run.scene.bodies()) + stiffness * longer * longer / 2;
  };
  const double before = energy();
  double turned = 0, worst = 0;
  const double time = seconds([&] {
    for (int i = std::lround(end / h); i > 0; --i) {
      const PlaneRotation<double> was = run.scene.bodies().pose[1].rotation;
      run.scene.add_torque(1, Angular<M>(torque));
      kick();
      run.step(h);
      kick();
      turned += principal_angle(run.scene.bodies().pose[1].rotation * inverse(was));
      worst = std::max(worst, std::abs(energy() - before - torque * turned));
    }
  });
  double largest = 0;
  for (int i = 0; i < 7; ++i) {
    const PlaneRotation<double> exact = plane_rotation(at_30_ms.bodies()[i]);
    largest =
        std::max(largest, std::abs(principal_angle(run.scene.bodies().pose[1 + i].rotation * inverse(exact))));
  }
  const std::string how = fmt::format("RATTLE, {:g} s", h);
  return {{"ours", start.beta + turned, how, time, angles},
          {"ours", largest, how, time, angles},
          {"ours", worst, how, time, energies}};
}

}  // namespace

// Bounds: RATTLE is of order 2, 4.3e5 rad/s² × h² and 2.1e5 J/s² × h².
Figure squeezer() {
  const Run coarse = kicked(1e-5, 0.03, 5e-5, none), fine = kicked(1e-6, 0.03, 5e-7, none);
  return {"Andrews' squeezing mechanism (IFToMM benchmark A03)",
          "Seven bodies of centimetres and grams, a motor of 0.033 N m and a spring.",
          "Test set for IVP solvers, andrews.f (data, and the reference at 0.03 s: PSIDE, Cray C90, tolerance "
          "1e-14);\n  OpenSim 3.2: github.com/RehabEngGroup/MBSbenchmarksInOpenSim.",
          {{"β at 0.03 s [rad]",
            at_30_ms.beta,
            "reference of the test set",
            {coarse.beta, fine.beta, {"PSIDE", none, "Cray C90: the reference itself", 56.74}}},
           {"angles at 0.03 s [rad]",
            0,
            "largest error of the seven, from the test set's reference",
            {coarse.worst, fine.worst}},
           {"energy, 0.05 s [J]",
            0,
            "largest |T + V - E0 - τ (β - β0)|",
            {kicked(1e-5, 0.05, none, 2.4e-5).balance,
             kicked(1e-6, 0.05, none, 2.4e-7).balance,
             {"OpenSim", none, "i5-4570, 3.2 GHz", 0.384}}}}};
}

}  // namespace byhand::published
