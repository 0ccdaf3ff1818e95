#pragma once

#include "lessons/methods/row_solvers.hpp"
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
  bool converged = false;
};

double difference(const std::vector<double>& a, const std::vector<double>& b);
double largest(const std::vector<double>& a);

template <class M>
std::vector<double> numbers_of(const std::vector<Velocity<M>>& velocities);

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
Scene<M> bodies_alone(const Scene<M>& scene);

/// λ of every row, constraint by constraint in natural order, then of contacts.
template <class M>
std::vector<double> natural_lambda(const Scene<M>& scene, const StepWork<M>& work);

/// What the rows leave after one step, without the gyroscopic term; the scene itself stays as it is.
template <class M>
Answer<M> solved(Scene<M> scene, const AnyRowSolver& solver, const DriftCure& cure = Baumgarte{});

/// A row solver of the library among those of all.
inline AnyRowSolver any(const RowSolver& solver) {
  return std::visit([](const auto& choice) { return AnyRowSolver(choice); }, solver);
}

template <class M>
Scene<M> with_random_velocities(Scene<M> scene, Random& random);

/// Rods and pins between random bodies, some of them fixed, each row with a softness that keeps the whole
/// regular however the graph came out.
template <class M>
Scene<M> random_graph(Random& random, int bodies, int constraints);

/// A sheet of n × n free particles or balls, each held by rods to its neighbours: hubs of four next to each
/// other. The points are off the lattice, so that no row of rods is straight.
template <class M>
Scene<M> grid(Random& random, int n);

/// A closed ring of pinned bodies, or of particles on rods.
template <class M>
Scene<M> ring(Random& random, int n);

/// Pins and rods in turn along a chain.
template <class M>
Scene<M> mixed_chain(Random& random, int links);

}  // namespace byhand
