#include "tests/solver/random.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
Linear<M> Random::direction() {
  for (;;) {
    const Linear<M> v = vector<M::linear>(1);
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}

template <class M>
Pose<M> Random::pose() {
  Pose<M> result;
  result.position = vector<M::linear>(2);
  if constexpr (M::angular == 1) result.rotation = plane_rotation(uniform(-4, 4));
  if constexpr (M::angular == 3) result.rotation = Eigen::Quaterniond(vector<4>(1)).normalized();
  return result;
}

template <class M>
Velocity<M> Random::velocity() {
  return vector<M::dof>(3);
}

template <class M>
InverseMass<M> Random::mass() {
  const double m = uniform(0.2, 5);
  if constexpr (M::angular == 0)
    return with_mass<M>(m);
  else
    return box<M>(m, Linear<M>(Linear<M>::Constant(1.1) + vector<M::linear>(0.8)));
}

template <class M>
Arms<M> Random::arms() {
  if constexpr (M::angular == 0)
    return {};
  else
    return {vector<M::linear>(1), vector<M::linear>(1)};
}

template <class M>
Arm<M> Pair<M>::r1() const {
  return in_world<M, double>(pose1, at.arms.first);
}
template <class M>
Arm<M> Pair<M>::r2() const {
  return in_world<M, double>(pose2, at.arms.second);
}
template <class M>
Linear<M> Pair<M>::P1() const {
  return anchor<M, double>(pose1, r1());
}
template <class M>
Linear<M> Pair<M>::P2() const {
  return anchor<M, double>(pose2, r2());
}
template <class M>
Scene<M> Pair<M>::scene() const {
  Scene<M> scene;
  scene.add_body(pose1, m1, V1);
  scene.add_body(pose2, m2, V2);
  return scene;
}

template <class M>
Pair<M> random_pair(Random& random) {
  return {random.pose<M>(), random.pose<M>(), random.velocity<M>(),    random.velocity<M>(),
          random.mass<M>(), random.mass<M>(), {0, 1, random.arms<M>()}};
}

#define INSTANTIATE(M)                        \
  template Linear<M> Random::direction<M>();  \
  template Pose<M> Random::pose<M>();         \
  template Velocity<M> Random::velocity<M>(); \
  template InverseMass<M> Random::mass<M>();  \
  template Arms<M> Random::arms<M>();         \
  template struct Pair<M>;                    \
  template Pair<M> random_pair<M>(Random & random)

BYHAND_FOR_EACH_MODEL(INSTANTIATE);

}  // namespace byhand
