#include "tests/fuzz/draw.hpp"

#include <cmath>
#include <random>

namespace byhand::fuzz {
namespace {

template <class M>
class Draw {
 public:
  using Part = Recipe<M>::Part;

  explicit Draw(std::uint64_t draw) : bits_(draw) {}

  Recipe<M> run() {
    decades_ = uniform(0, 6);
    friction_ = coin(0.5) ? 0 : uniform(0.1, 0.8);
    if (coin(0.3))
      chain();
    else if (coin(0.5))
      column();
    else
      pile();
    return recipe_;
  }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  bool coin(double chance) { return uniform(0, 1) < chance; }
  int count(int least, int most) { return least + static_cast<int>(uniform(0, most - least + 1)); }
  template <int n>
  Eigen::Matrix<double, n, 1> any(double size) {
    Eigen::Matrix<double, n, 1> v;
    for (double& x : v) x = uniform(-size, size);
    return v;
  }
  Rotation<M> turn(double angle) {
    if constexpr (M::linear == 2)
      return plane_rotation(uniform(-angle, angle));
    else
      return space_rotation<double>(any<3>(angle));
  }

  void ground() { recipe_.parts.push_back({.shape = HalfSpace<M>{Linear<M>::Unit(1)}, .friction = friction_}); }
  Part body(double size) {
    Part part{.mass = std::exp(std::log(10.0) * uniform(-0.5, 0.5) * decades_), .friction = friction_};
    if (coin(0.3))
      part.shape = Ball<M>{0.5 * size};
    else
      part.shape = Box<M>{Linear<M>((Linear<M>::Ones() + any<M::linear>(0.3)) * size / 1.3)};
    return part;
  }

  /// Each in a cell of its own, turned and moving anyhow.
  void pile() {
    ground();
    const int bodies = count(1, 12), across = count(1, 4);
    const double cell = 1.8, speed = coin(0.3) ? 0 : uniform(0, 3);
    for (int i = 0; i < bodies; ++i) {
      Part part = body(1);
      part.pose.position = cell * (i % across) * Linear<M>::Unit(0) +
                           (cell * (i / across) + 1) * Linear<M>::Unit(1) + any<M::linear>(0.05);
      part.pose.rotation = turn(2);
      part.velocity.template head<M::linear>() = any<M::linear>(speed);
      part.velocity.template tail<M::angular>() = any<M::angular>(0.5 * speed);
      recipe_.parts.push_back(part);
    }
  }

  /// One upon the other, each a little aside.
  void column() {
    ground();
    double top = 0;
    for (int i = count(1, 6); i > 0; --i) {
      Part part = body(1);
      Linear<M> sides = Linear<M>::Ones();
      if (const auto* box = std::get_if<Box<M>>(&part.shape))
        sides = box->sides;
      else
        part.shape = Box<M>{sides};
      part.pose.position = (top + 0.5 * sides.y()) * Linear<M>::Unit(1) + uniform(-0.1, 0.1) * Linear<M>::Unit(0);
      top += sides.y();
      recipe_.parts.push_back(part);
    }
  }

  /// From a nail, each pinned to the one before or held by a rod, at rest and held up level.
  void chain() {
    recipe_.parts.push_back({.shape = Ball<M>{0.1}});
    const int links = count(1, 10);
    for (int i = 0; i < links; ++i) {
      Part part = body(0.6);
      part.pose.position = (i + 1) * Linear<M>::Unit(0);
      recipe_.parts.push_back(part);
      const auto joint = static_cast<typename Recipe<M>::Joint>(count(0, 2));
      recipe_.links.push_back({joint, i, i + 1, (i + 0.5) * Linear<M>::Unit(0)});
    }
  }

  std::mt19937_64 bits_;
  Recipe<M> recipe_;
  double decades_ = 0, friction_ = 0;
};

}  // namespace

template <class M>
Recipe<M> drawn(std::uint64_t draw) {
  return Draw<M>(draw).run();
}

template Recipe<PlaneBody> drawn(std::uint64_t);
template Recipe<SpaceBody> drawn(std::uint64_t);

}  // namespace byhand::fuzz
