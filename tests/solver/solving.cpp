#include "tests/solver/solving.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_FALSE(std::isnan(a[i]) || std::isnan(b[i]));
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

double largest(const std::vector<double>& a) { return difference(a, std::vector<double>(a.size())); }

template <class M>
std::vector<double> numbers_of(const std::vector<Velocity<M>>& velocities) {
  std::vector<double> result;
  for (const auto& V : velocities) result.insert(result.end(), V.data(), V.data() + M::dof);
  return result;
}

template <class M>
Scene<M> bodies_alone(const Scene<M>& scene) {
  Scene<M> result;
  for (int i = 0; i < scene.bodies().size(); ++i)
    result.add_body(scene.bodies().pose[i], scene.bodies().inverse_mass[i], scene.bodies().velocity[i]);
  return result;
}

template <class M>
std::vector<double> natural_lambda(const Scene<M>& scene, const StepWork<M>& work) {
  std::vector<double> result;
  auto row = work.system.row_of.begin();
  for_each_constraint(scene, work.contacts, [&](const auto& store, const auto&) {
    const auto first = work.system.lambda.begin() + *row++;
    result.insert(result.end(), first, first + store.rows);
  });
  return result;
}

template <class M>
Answer<M> solved(Scene<M> scene, const AnyRowSolver& solver, const DriftCure& cure) {
  Work<M> work;
  advance(scene, AnyStepping{.solver = solver, .drift = cure, .gyroscopic = Gyroscopic::none}, time_step, work);
  return {numbers_of<M>(scene.bodies().velocity), natural_lambda(scene, work),
          residual(work.system, scene.bodies().velocity), work.solution.converged};
}

template <class M>
Scene<M> with_random_velocities(Scene<M> scene, Random& random) {
  for (int i = 0; i < scene.bodies().size(); ++i)
    if (moves(scene.bodies().inverse_mass[i])) scene.state().velocity[i] = random.velocity<M>();
  return scene;
}

template <class M>
Scene<M> random_graph(Random& random, int bodies, int constraints) {
  Scene<M> scene;
  for (int i = 0; i < bodies; ++i) {
    if (random.uniform(0, 1) < 0.15)
      scene.add_body(random.pose<M>(), fixed<M>());
    else
      scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
  }
  for (int i = 0; i < constraints; ++i) {
    const int body1 = random.index(bodies), body2 = (body1 + 1 + random.index(bodies - 1)) % bodies;
    if (!moves(scene.bodies().inverse_mass[body1]) && !moves(scene.bodies().inverse_mass[body2])) continue;
    const Anchors<M> at{body1, body2, random.arms<M>()};
    const double softness = random.uniform(0.05, 0.5);
    if (random.uniform(0, 1) < 0.5)
      scene.add(Distance<M>{at, random.uniform(0.5, 2), softness});
    else
      scene.add(Pin<M>{at, softness});
  }
  return scene;
}

template <class M>
Scene<M> grid(Random& random, int n) {
  Scene<M> scene;
  for (int i = 0; i < n * n; ++i) {
    Linear<M> at = random.vector<M::linear>(0.3);
    at[0] += i % n;
    at[1] += i / n;
    scene.add_body(at, random.mass<M>(), random.velocity<M>());
  }
  for (int i = 0; i < n * n; ++i) {
    if (i % n + 1 < n) scene.add(Distance<M>{{i, i + 1}});
    if (i + n < n * n) scene.add(Distance<M>{{i, i + n}});
  }
  return scene;
}

template <class M>
Scene<M> ring(Random& random, int n) {
  if constexpr (M::angular == 0) {
    Scene<M> scene;
    for (int i = 0; i < n; ++i) scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
    for (int i = 0; i < n; ++i) scene.add(Distance<M>{{i, (i + 1) % n}});
    return scene;
  } else {
    Scene<M> scene;
    for (int i = 0; i < n; ++i) scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
    for (int i = 0; i < n; ++i)
      scene.add(pin<M>(scene.bodies(), i, (i + 1) % n, Linear<M>(random.vector<M::linear>(2))));
    return scene;
  }
}

template <class M>
Scene<M> mixed_chain(Random& random, int links) {
  Scene<M> scene;
  scene.add_body(random.pose<M>(), fixed<M>());
  for (int i = 0; i < links; ++i) {
    scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
    const Anchors<M> at{i, i + 1, random.arms<M>()};
    if (i % 3 == 0)
      scene.add(Pin<M>{at});
    else
      scene.add(Distance<M>{at});
  }
  return scene;
}

#define INSTANTIATE(M)                                                                 \
  template std::vector<double> numbers_of<M>(const std::vector<Velocity<M>>&);         \
  template Scene<M> bodies_alone<M>(const Scene<M>&);                                  \
  template std::vector<double> natural_lambda<M>(const Scene<M>&, const StepWork<M>&); \
  template Answer<M> solved<M>(Scene<M>, const AnyRowSolver&, const DriftCure&);       \
  template Scene<M> with_random_velocities<M>(Scene<M>, Random&);                      \
  template Scene<M> random_graph<M>(Random&, int, int);                                \
  template Scene<M> grid<M>(Random&, int);                                             \
  template Scene<M> ring<M>(Random&, int);                                             \
  template Scene<M> mixed_chain<M>(Random&, int)

BYHAND_FOR_EACH_MODEL(INSTANTIATE);

}  // namespace byhand
