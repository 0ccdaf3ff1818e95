#include "lessons/07_space/pucks.hpp"

#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"

namespace byhand::space {
namespace {

template <class F>
std::vector<Way> slide(const Setting& setting, const std::vector<double>& headings, F&& add_friction) {
  Simulation<SpaceParticle> pucks{{}, {GaussSeidel{4}}};
  auto& scene = pucks.scene;
  const int ground = scene.add_body(Linear<SpaceParticle>(0, 0, 0), fixed<SpaceParticle>());
  for (const double heading : headings) {
    const Eigen::Vector3d along(std::cos(heading), 0, std::sin(heading));
    const int puck = scene.add_body(Linear<SpaceParticle>(0, 0, 0), with_mass<SpaceParticle>(setting.mass),
                                    setting.speed * along);
    const auto pressing = scene.add(Contact<SpaceParticle>{{ground, puck}, Eigen::Vector3d::UnitY()});
    add_friction(scene, Anchors<SpaceParticle>{ground, puck}, pressing);
  }
  std::vector<Way> ways(headings.size());
  bool moving = true;
  while (moving) {
    moving = false;
    for (std::size_t i = 0; i < headings.size(); ++i) {
      const Eigen::Vector3d x = scene.bodies().pose[i + 1].position;
      ways[i].emplace_back(x.x(), x.z());
      moving = moving || scene.bodies().velocity[i + 1].norm() > 1e-9;
    }
    pucks.step(setting.h);
  }
  return ways;
}

}  // namespace

std::vector<Way> slide(const Setting& setting, const std::vector<double>& headings, Bounds bounds,
                       double axes_turned) {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << std::cos(axes_turned), -std::sin(axes_turned), 0, 0, std::sin(axes_turned), std::cos(axes_turned);
  const double mu = setting.friction;
  if (bounds == Bounds::disc)
    return slide(setting, headings, [&](auto& scene, const Anchors<SpaceParticle>& at, int pressing) {
      scene.add(Friction<SpaceParticle>{at, tangents, mu, pressing});
    });
  return slide(setting, headings, [&](auto& scene, const Anchors<SpaceParticle>& at, int pressing) {
    //! [pyramid]
    for (int k = 0; k < 2; ++k) scene.add(AxisFriction<SpaceParticle>{at, tangents.col(k), mu, pressing});
    //! [pyramid]
  });
}

// After k steps the speed is v - kah while that is positive, and each step moves by its new speed.
double stopping_distance(double speed, double deceleration, double h) {
  const double steps = std::floor(speed / (deceleration * h));
  return h * (steps * speed - deceleration * h * steps * (steps + 1) / 2);
}

}  // namespace byhand::space
