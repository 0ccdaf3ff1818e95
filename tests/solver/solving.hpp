#pragma once

#include "solver/constraints/contact.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/measure.hpp"
#include "tests/solver/random.hpp"

// One step of any scene by any solver, with its answer in an order that does not depend on the solver.
namespace byhand {

inline constexpr double time_step = 1.0 / 60;

template <class M>
struct Answer {
  std::vector<double> velocity;  // dof numbers a body
  std::vector<double> lambda;    // rows of the constraints in natural order
  double residual = 0;
};

inline double difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_FALSE(std::isnan(a[i]) || std::isnan(b[i]));
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}
inline double largest(const std::vector<double>& a) { return difference(a, std::vector<double>(a.size())); }

template <class M>
std::vector<double> numbers_of(const std::vector<Velocity<M>>& velocities) {
  std::vector<double> result;
  for (const auto& V : velocities) result.insert(result.end(), V.data(), V.data() + M::dof);
  return result;
}

/// Calls f(constraint, place) for each constraint of these kinds, in natural order.
template <template <class> class... Kinds, class M, class F>
void for_each_of(const Scene<M>& scene, F&& f) {
  for (int place = 0; place < scene.count(); ++place) {
    const auto& entry = scene.entries()[place];
    const auto call_if = [&]<class Kind>(std::span<const Kind> all) {
      if (scene.store(entry.kind).kind() == typeid(Kind)) f(all[entry.index], place);
    };
    (call_if(scene.template all<Kinds>()), ...);
  }
}

/// The same bodies without constraints.
template <class M>
Scene<M> bodies_alone(const Scene<M>& scene) {
  Scene<M> result;
  for (int i = 0; i < scene.bodies().size(); ++i)
    result.add_body(scene.bodies().pose[i], scene.bodies().inverse_mass[i], scene.bodies().velocity[i]);
  return result;
}

/// λ of every row, constraint by constraint in natural order.
template <class M>
std::vector<double> natural_lambda(const Scene<M>& scene, const System<M>& system) {
  std::vector<double> result;
  for (int place = 0; place < scene.count(); ++place)
    for (int k = 0; k < scene.store(scene.entries()[place].kind).rows; ++k)
      result.push_back(system.lambda[system.row_of[place] + k]);
  return result;
}

/// What one step leaves; the scene itself stays as it is.
template <class M>
Answer<M> solved(Scene<M> scene, const RowSolver& solver, const DriftCure& cure = Baumgarte{}) {
  Work<M> work;
  advance(scene, {solver, cure}, time_step, work);
  return {numbers_of<M>(scene.bodies().velocity), natural_lambda(scene, work.system),
          residual(work.system, scene.bodies().velocity)};
}

template <class M>
Scene<M> with_random_velocities(Scene<M> scene, Random& random) {
  for (int i = 0; i < scene.bodies().size(); ++i)
    if (moves(scene.bodies().inverse_mass[i])) scene.state().velocity[i] = random.velocity<M>();
  return scene;
}

/// Rods and pins between random bodies, some of them fixed, each row with a softness that keeps the whole
/// regular however the graph came out.
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

/// A sheet of n × n free particles or balls, each held by rods to its neighbours: hubs of four next to each
/// other. The points are off the lattice, so that no row of rods is straight.
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

/// A closed ring of pinned bodies, or of particles on rods.
template <class M>
auto ring(Random& random, int n) {
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

/// Pins and rods in turn along a chain.
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

}  // namespace byhand
