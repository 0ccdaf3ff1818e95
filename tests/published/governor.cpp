#include <fmt/format.h>

#include "lessons/exact/certified_integration.hpp"
#include "lessons/scenes/units.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/step.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

using M = SpaceBody;

constexpr double end = 10;                                        // [s]
constexpr double rod_mass = 0.3, ball_mass = 5, slider_mass = 3;  // [kg]
constexpr double half = 0.05, length = 0.5, k = 8e5, c = 4e4;     // of the slider, of a spring [m, N/m, N s/m]
constexpr double thin = rod_mass / 12 * 1e-4;                     // of a rod 1 cm thick, by one thickness [kg m²]
constexpr double first_moment = rod_mass / 2 + ball_mass;         // of rod and ball about the pivot [kg m]
constexpr double second_moment = rod_mass / 3 + thin + ball_mass;  // [kg m²]
constexpr double centre = first_moment / (rod_mass + ball_mass);   // of mass of both, from the pivot [m]
const double start_angle = pi / 6, start_spin = 2 * pi;            // below the horizontal [rad], [rad/s]

/// A shaft of 1 m turns about z. A slider, body 2, rises along it; two rods with balls at their ends hang from
/// pivots at its top, and a stiff spring with a damper joins the middle of each with the slider.
Scene<M> flyballs() {
  Scene<M> scene;
  scene.gravity = Linear<M>(0, 0, -9.81);
  const auto turning = [](const Linear<M>& at) {
    const Angular<M> spin(0, 0, start_spin);
    Velocity<M> V;
    V << spin.cross(at), spin;
    return V;
  };
  const Linear<M> foot(0, 0, 0), middle(0, 0, 0.5), up(0, 0, 1);
  const int ground = scene.add_body(foot, fixed<M>());
  const int shaft = scene.add_body(middle, box<M>(rod_mass, {0.01, 0.01, 1}), turning(middle));
  const int slide = scene.add_body(middle, box<M>(slider_mass, {0.1, 0.1, 0.1}), turning(middle));
  scene.add(hinge<M>(scene.bodies(), ground, shaft, foot, up));
  scene.add(slider<M>(scene.bodies(), shaft, slide, middle, up));
  for (const int side : {1, -1}) {
    const Linear<M> pivot(side * half, 0, 1), along(side * std::cos(start_angle), 0, -std::sin(start_angle));
    Pose<M> pose;
    pose.position = pivot + centre * along;
    pose.rotation = space_rotation(Angular<M>(0, side * start_angle, 0));
    const double across = second_moment - centre * first_moment;
    const int rod = scene.add_body(pose, with_mass<M>(rod_mass + ball_mass, Angular<M>(2 * thin, across, across)),
                                   turning(pose.position));
    scene.add(hinge<M>(scene.bodies(), shaft, rod, pivot, Linear<M>::UnitY()));
    const Linear<M> edge(side * half, 0, 0.5), waist = pivot + 0.5 * along;
    scene.add(Spring<M>{between<M>(scene.bodies(), slide, edge, rod, waist), length, {k, c}});
  }
  return scene;
}

/// Where the slider is in the end [m]. Both rods hang at the angle θ, and the spin about the shaft follows from
/// the angular momentum L = I(θ) ω:
///   J θ̈ = ¼ I′ ω² + m g r cos θ - F ∂d/∂θ,   m_s s̈ = -m_s g - 2F ∂d/∂s,   F = k (d - ½) + c ḋ.
Certified exact() {
  const long double J = second_moment, mr = first_moment, g = 9.81L;
  const auto inertia = [&](long double cos, long double sin) {
    const long double rods =
        (rod_mass + ball_mass) * half * half + 2 * half * mr * cos + J * cos * cos + 2 * thin * sin * sin;
    return 2 * thin + slider_mass / 600 + 2 * rods;
  };
  const long double L = inertia(std::cos(start_angle), std::sin(start_angle)) * start_spin;
  const auto rate = [&](const ExtendedState& state, ExtendedState& slope) {
    const long double cos = std::cos(state[0]), sin = std::sin(state[0]), turn = state[2], rise = state[3];
    const long double x = cos / 2, z = 1 - sin / 2 - state[1], d = std::sqrt(x * x + z * z);
    const long double by_angle = -(x * sin + z * cos) / (2 * d), by_place = -z / d;
    const long double F = k * (d - length) + c * (by_angle * turn + by_place * rise);
    const long double spin = L / inertia(cos, sin), steeper = 4 * sin * (-half * mr - (J - 2 * thin) * cos);
    slope = {turn, rise, (steeper * spin * spin / 4 + mr * g * cos - F * by_angle) / J,
             -g - 2 * F * by_place / slider_mass};
  };
  return certified_integration(rate, {start_angle, 0.5, 0, 0}, end, 1e-12);
}

Entry risen(double h) {
  Simulation<M> governor{flyballs()};
  const double time = seconds([&] {
    for (int i = std::lround(end / h); i > 0; --i) governor.step(h);
  });
  return {"ours", governor.scene.bodies().pose[2].position.z(), fmt::format("default method, {:g} s", h), time,
          4 * h};
}

}  // namespace

// Bounds: the default method is of order 1, from 3.1 m/s × h with 10 ms down to 0.34 m/s × h. The dampers' rate is
// 2c (∂d/∂s)²/m_s + c (∂d/∂θ)²/J = 8100/s at first, for which an explicit step has to be below 0.25 ms.
Figure governor() {
  const Certified reference = exact();
  return {
      "Stiff flyball governor (IFToMM benchmark A05)",
      "Springs of 8e5 N/m and 4e4 N s/m join two balls of 5 kg with a slider of 3 kg; the spin is 2π rad/s first.",
      "github.com/RehabEngGroup/MBSbenchmarksInOpenSim, src/A05-FlyballGovernor, OpenSim 3.2.",
      {{"slider at 10 s [m]",
        reference.state[1],
        fmt::format("three equations of motion, certified to {:.0e}", reference.uncertainty),
        {risen(1e-2), risen(1e-3), risen(1e-4), {"OpenSim", none, "i5-4570, 3.2 GHz", 0.233}}}}};
}

}  // namespace byhand::published
