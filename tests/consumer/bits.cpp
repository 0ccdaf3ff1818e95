#include <Eigen/Dense>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "solver/byhand.hpp"

// A program with Eigen settings and a processor of its own. It prints a hash of where bodies go under built-in
// kinds, and no word of it may depend on how this file is compiled.
using namespace byhand;

// No type that the library and a program both touch is aligned, so that Eigen's settings cannot move its members.
template <class M>
constexpr bool unaligned = alignof(Pose<M>) == 8 && alignof(Velocity<M>) == 8 && alignof(InverseMass<M>) == 8 &&
                           alignof(Shape<M>) == 8 && alignof(Distance<M>) == 8 && alignof(Pin<M>) == 8 &&
                           alignof(Reaction<M>) == 8 && alignof(Scene<M>) == 8 &&
                           alignof(Block<M, 1, Bound::none>) == 8 && alignof(Block<M, 2, Bound::none>) == 8;
static_assert(unaligned<PlaneParticle> && unaligned<PlaneBody> && unaligned<SpaceParticle> &&
              unaligned<SpaceBody>);
static_assert(alignof(Block<SpaceBody, 4, Bound::none>) == 8 && alignof(Hinge<SpaceBody>) == 8);

template <class M>
std::uint64_t hash_after(int steps, const Scene<M>& scene) {
  Simulation<M> simulation{scene};
  for (int i = 0; i < steps; ++i) simulation.step(1.0 / 60);
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x100000001b3;
  };
  for (const auto& pose : simulation.scene.bodies().pose)
    for (const double x : pose.position) add(x);
  for (const auto& V : simulation.scene.bodies().velocity)
    for (const double v : V) add(v);
  return hash;
}

template <class M>
Scene<M> particles() {
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  for (int i = 1; i < 8; ++i) {
    scene.add_body(Linear<M>(0.7 * i * Linear<M>::Unit(0) + 0.1 * (i % 3) * Linear<M>::Unit(1)), with_mass<M>(i));
    scene.add(Distance<M>{{i - 1, i}, 0.7});
  }
  return scene;
}

Scene<PlaneBody> plane() {
  using M = PlaneBody;
  Scene<M> scene;
  const int ground = scene.add_body({0, 0}, fixed<M>());
  scene.set_shape(ground, HalfSpace<M>{});
  for (int i = 0; i < 5; ++i) {
    const int crate = scene.add_body({0.03 * i, 0.36 + 0.71 * i}, box<M>(1.3, {0.9, 0.7}));
    scene.set_shape(crate, Box<M>{{0.9, 0.7}});
  }
  int last = scene.add_body({3.1, 4.3}, fixed<M>());
  for (int i = 0; i < 4; ++i) {
    const int link = scene.add_body({{3.4 + 0.6 * i, 4.4}, plane_rotation(0.3)}, box<M>(0.7, {0.6, 0.1}));
    scene.add(pin<M>(scene.bodies(), last, link, {3.1 + 0.6 * i, 4.3}));
    last = link;
  }
  const int wheel = scene.add_body({-3, 0.4}, ball<M>(2, 0.4), {2.7, 0, -3.1});
  scene.set_shape(wheel, Ball<M>{0.4}, {.friction = 0.4, .restitution = 0.3});
  return scene;
}

Scene<SpaceBody> space() {
  using M = SpaceBody;
  Scene<M> scene;
  const int ground = scene.add_body({0, 0, 0}, fixed<M>());
  scene.set_shape(ground, HalfSpace<M>{{0, 1, 0}});
  for (int i = 0; i < 3; ++i) {
    Pose<M> pose{{0.02 * i, 0.36 + 0.71 * i, 0.01 * i}, space_rotation(Angular<M>(0, 0.3 * i, 0))};
    scene.set_shape(scene.add_body(pose, box<M>(1.3, {0.9, 0.7, 0.8})), Box<M>{{0.9, 0.7, 0.8}});
  }
  const int post = scene.add_body({3, 3, 3}, fixed<M>());
  const int door = scene.add_body({3.5, 3, 3.1}, box<M>(2, {1, 0.3, 0.2}), {0, 0, 0, 0.1, 0.2, 3});
  const int sled = scene.add_body({4, 3, 3}, box<M>(1, {0.3, 0.4, 0.2}));
  const int load = scene.add_body({4.1, 3.3, 3.2}, box<M>(0.4, {0.1, 0.2, 0.3}));
  scene.add(hinge<M>(scene.bodies(), post, door, {3, 3, 3}, {0.1, 0.2, 1}));
  scene.add(slider<M>(scene.bodies(), door, sled, {3.7, 3, 3}, {1, 0.1, 0}));
  scene.add(weld<M>(scene.bodies(), sled, load, {4, 3.2, 3}));
  const int top = scene.add_body({0.2, 3.5, 0.1}, ball<M>(1, 0.3), {0, -2, 0, 5, 1, 2});
  scene.set_shape(top, Ball<M>{0.3});
  return scene;
}

int main() {
  // The program's own sums, in whatever vectors its processor has.
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(16, 16);
  const Eigen::Vector4d b = A.topRows<4>() * A.col(0), c = A.topLeftCorner<4, 4>().inverse() * b;
  if (!(A.topLeftCorner<4, 4>() * c).isApprox(b, 1e-9)) return 1;

  std::printf("%016llx %016llx %016llx %016llx\n",
              static_cast<unsigned long long>(hash_after(200, particles<PlaneParticle>())),
              static_cast<unsigned long long>(hash_after(200, plane())),
              static_cast<unsigned long long>(hash_after(200, particles<SpaceParticle>())),
              static_cast<unsigned long long>(hash_after(200, space())));
}
