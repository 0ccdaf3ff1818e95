#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "solver/integrate/jet.hpp"
#include "solver/measure.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/prepared.hpp"

// Numbers of a scene's own rows at one moment of its motion.
namespace byhand::doctor {

/// A scene at one moment, its rows written for a step h [s], and λ that holds it there.
template <class M>
struct Moment {
  Scene<M> scene;
  Work<M> work;     // of a step with ByGraph
  double h = 0;     // of its λ [s]
  double time = 0;  // [s]
};

/// The same moment with its rows in the order of another solver and for another step [s].
template <class M>
Moment<M> laid_out_for(Moment<M> moment, const RowSolver& solver, double h) {
  lay_out(moment.scene, solver, moment.work);
  moment.work.contacts.write_impulses(moment.work.system);
  rescale_impulses(moment.work, h);
  moment.scene.write_rows(moment.work.system, h, moment.work.contacts.constraints());
  moment.h = h;
  return moment;
}

/// ½vᵀMv, doubled and rooted: the size of a motion.
template <class M>
double size_of(const Scene<M>& scene, const std::vector<Velocity<M>>& V) {
  Bodies<M> bodies = scene.bodies();
  bodies.velocity = V;
  return std::sqrt(2 * kinetic_energy(bodies));
}

/// Leaves only the rows that hold the bodies now: a contact or limit that carries nothing, a motor at its strength
/// and friction that slides are held where they are. All others get the bias with which V = 0 solves them. Calls
/// f(row) for each that holds. What pushes less than the share `least` of the largest λ counts as nothing.
template <class M, class F>
void linearise(System<M>& system, double least, F&& f) {
  constexpr double open = 1e9;  // a rate at which no contact closes [m/s]
  double largest = 0;
  for (const double one : system.lambda) largest = std::max(largest, std::abs(one));
  for (double& one : system.lambda)
    if (std::abs(one) < least * largest) one = 0;
  const std::vector<double> lambda = system.lambda;
  const auto hold = [&](int row) {
    system.bias[row] = -system.gamma[row] * lambda[row];
    f(row);
  };
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const int row = block.row;
    double slip = 0;
    for (int k = normals<K, B>; k < K; ++k) slip += lambda[row + k] * lambda[row + k];
    if constexpr (B == Bound::none) {
      for (int k = 0; k < K; ++k) hold(row + k);
    } else if constexpr (B == Bound::interval) {
      if (system.lower[row] < lambda[row] && lambda[row] < system.upper[row])
        hold(row);
      else
        system.lower[row] = system.upper[row] = lambda[row];
    } else {
      double normal = 0;
      if constexpr (B == Bound::friction)
        normal = lambda[block.normal_row];
      else
        for (int k = 0; k < normals<K, B>; ++k) {
          normal += lambda[row + k];
          lambda[row + k] > 0 ? hold(row + k) : void(system.bias[row + k] = open);
        }
      const bool sticks = std::sqrt(slip) < 0.999 * system.upper[row] * normal;
      if (!sticks) system.upper[row] = 0;
      for (int k = normals<K, B>; k < K; ++k)
        if (sticks)
          hold(row + k);
        else
          system.lambda[row + k] = 0;
    }
  });
}

/// The motion that sweeps remove last, with what each row sees of it.
template <class M>
struct Slowest {
  double left_by_a_sweep = 0;  // ρ
  std::vector<double> rates;   // JV of a unit of it, by row [m/s]
  std::vector<double> lambda;  // that makes it
  double load = 0;             // λ of the moment in that unit
};

/// Whether a row that holds has come to its bound: then the sweeps are not linear about these λ.
template <class M>
bool leaves_its_bounds(const System<M>& system, const std::vector<double>& held) {
  bool left = false;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const int row = block.row;
    if constexpr (B == Bound::interval) {
      left = left || (system.lower[row] < system.upper[row] &&
                      (system.lambda[row] <= system.lower[row] || system.lambda[row] >= system.upper[row]));
    } else if constexpr (B != Bound::none) {
      double slip = 0, normal = 0;
      for (int k = normals<K, B>; k < K; ++k) slip += system.lambda[row + k] * system.lambda[row + k];
      if constexpr (B == Bound::friction)
        normal = system.lambda[block.normal_row];
      else
        for (int k = 0; k < normals<K, B>; ++k) {
          normal += system.lambda[row + k];
          left = left || (held[row + k] > 0 && system.lambda[row + k] <= 0);
        }
      left =
          left || (system.upper[row] > 0 && normal > 0 && std::sqrt(slip) >= 0.9999 * system.upper[row] * normal);
    }
  });
  return left;
}

/// Power iteration with the sweep itself: the rows are those that hold now, λ is moved off its place by too little
/// for any to reach a bound. Where one does, rows that push little are left out, and it is tried again.
template <class M>
Slowest<M> slowest_mode(const Moment<M>& moment, const RowSolver& one_sweep, double least = 1e-6) {
  constexpr int sweeps = 60;
  System<M> system = moment.work.system;
  Bodies<M> bodies = moment.scene.bodies();
  for (auto& v : bodies.velocity) v.setZero();
  std::vector<double> off(system.lambda.size(), 0.0);
  std::mt19937 bits(1);
  linearise(system, least, [&](int row) { off[row] = 1 + static_cast<double>(bits() % 1000) / 1000; });
  const std::vector<double> held = system.lambda;
  apply_all(system, held, bodies.velocity);
  const double tiny = 1e-8 * size_of(moment.scene, bodies.velocity);  // of what the rows hold [m/s √kg]
  for (auto& v : bodies.velocity) v.setZero();
  apply_all(system, off, bodies.velocity);
  const auto rescale = [&](double factor) {
    for (auto& v : bodies.velocity) v *= factor;
    for (std::size_t row = 0; row < held.size(); ++row) {
      off[row] *= factor;
      system.lambda[row] = held[row] + off[row];
    }
  };
  Slowest<M> result;
  result.rates.assign(held.size(), 0.0);
  double size = size_of(moment.scene, bodies.velocity);
  if (!(size > 0) || !(tiny > 0)) return result;
  rescale(tiny / size);
  double log_sum = 0;
  int watched = 0;
  std::visit(
      [&]<class Solver>(const Solver& solver) {
        if constexpr (requires { solver.order; } || std::is_same_v<Solver, Jacobi>) {
          Prepared<M> prepared;
          for (int i = 0; i < sweeps; ++i) {
            if (i >= sweeps / 2) {  // the mode, of which the next sweep shows the rate
              rates_of(system, bodies.velocity, result.rates);
              result.lambda = off;
            }
            solver.solve(system, bodies, prepared, Begin::resume);
            for (std::size_t row = 0; row < held.size(); ++row) off[row] = system.lambda[row] - held[row];
            size = size_of(moment.scene, bodies.velocity);
            if (!(size > 1e-12 * tiny) || !std::isfinite(size)) break;
            if (i >= sweeps / 2) log_sum += std::log(size / tiny), ++watched;
            rescale(tiny / size);
          }
        }
      },
      one_sweep);
  if (leaves_its_bounds(system, held))
    return least < 0.01 ? slowest_mode(moment, one_sweep, 10 * least) : Slowest<M>{};
  if (watched > 0) result.left_by_a_sweep = std::exp(log_sum / watched);
  double own = 0, load = 0;
  for (std::size_t row = 0; row < result.lambda.size(); ++row) {
    if (off[row] == 0) continue;
    own += result.rates[row] * result.lambda[row];
    load += result.rates[row] * held[row];
  }
  result.load = own != 0 ? load / own : 0;
  return result;
}

/// The largest ω [rad/s] at which the forces of the rows make the bodies swing across them: of the operator
/// -∂(M⁻¹Jᵀf)/∂x on motions that the rows allow. J that stands still over a step makes it an explicit spring.
template <class M>
double largest_transverse_frequency(const Moment<M>& moment, int iterations = 16) {
  const int count = moment.scene.bodies().size();
  System<M> rows = moment.work.system;
  std::vector<double> force(rows.lambda.size(), 0.0);
  bool any = false;
  for_each_block(rows, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    if (B != Bound::none) return;
    for (int k = 0; k < K; ++k) {
      force[block.row + k] = rows.lambda[block.row + k] / moment.h;
      any = any || force[block.row + k] != 0;
    }
  });
  if (!any) return 0;
  const auto accelerations = [&](const std::vector<Velocity<M>>& u, double by) {
    Scene<M> scene = moment.scene;
    for (int i = 0; i < count; ++i)
      if (moves(scene.bodies().inverse_mass[i])) move(scene.state().pose[i], u[i], by);
    scene.write_rows(rows, moment.h, moment.work.contacts.constraints());
    std::vector<Velocity<M>> a(static_cast<std::size_t>(count), Velocity<M>::Zero());
    apply_all(rows, force, a);
    return a;
  };
  Bodies<M> bodies = moment.scene.bodies();
  Work<M> solving = moment.work;
  for (int row = 0; row < rows.rows(); ++row) solving.system.bias[row] = 0;
  for_each_block(solving.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    for (int k = 0; k < K; ++k)
      if (B != Bound::none) solving.system.bias[block.row + k] = 1e9;
  });
  const System<M> at_rest = solving.system;
  const auto allowed = [&](const std::vector<Velocity<M>>& u) {
    solving.system.lambda.assign(at_rest.lambda.size(), 0.0);
    bodies.velocity = u;
    solve_rows<M>(RowSolver(ByGraph{}), bodies, solving);
    return bodies.velocity;
  };
  std::mt19937 bits(2);
  std::vector<Velocity<M>> u(static_cast<std::size_t>(count), Velocity<M>::Zero());
  for (int i = 0; i < count; ++i)
    if (moves(moment.scene.bodies().inverse_mass[i]))
      for (double& x : u[static_cast<std::size_t>(i)]) x = static_cast<double>(bits() % 2001) / 1000 - 1;
  double shift = 0, largest = 0;
  for (int i = 0; i < 2 * iterations; ++i) {
    u = allowed(u);
    const double size = size_of(moment.scene, u);
    if (!(size > 0) || !std::isfinite(size)) return 0;
    for (auto& v : u) v /= size;
    double reach = 0;
    for (const auto& v : u) reach = std::max(reach, v.template lpNorm<Eigen::Infinity>());
    const double by = 1e-5 / reach;
    const auto there = accelerations(u, by), back = accelerations(u, -by);
    std::vector<Velocity<M>> next(u.size());
    for (std::size_t b = 0; b < u.size(); ++b) next[b] = (back[b] - there[b]) / (2 * by);
    next = allowed(next);
    double along = 0;  // <u, Ku> in the metric of the masses
    for (int b = 0; b < count; ++b) {
      const InverseMass<M>& mass = moment.scene.bodies().inverse_mass[b];
      const auto at = static_cast<std::size_t>(b);
      if (!moves(mass)) continue;
      along += u[at].template head<M::linear>().dot(next[at].template head<M::linear>()) / mass.linear;
      if constexpr (M::angular > 0)
        along += u[at].template tail<M::angular>().dot(inertia<M>(mass, moment.scene.bodies().pose[b]) *
                                                       next[at].template tail<M::angular>());
    }
    largest = along;
    if (i + 1 == iterations && along < 0) shift = -along;  // what pushes is larger: look for what pulls
    for (std::size_t b = 0; b < u.size(); ++b) next[b] += shift * u[b];
    u = next;
  }
  return largest > 0 ? std::sqrt(largest) : 0;
}

/// J̇V by row of the system [units of C per s²].
template <class M>
std::vector<double> bends(const Scene<M>& scene, const StepWork<M>& work) {
  std::vector<Pose<M, Jet>> paths;
  const Bodies<M>& bodies = scene.bodies();
  for (int i = 0; i < bodies.size(); ++i) paths.push_back(on_its_way<M>(bodies.pose[i], bodies.velocity[i]));
  std::vector<double> result(work.system.lambda.size(), 0.0);
  scene.write_bias_accelerations(work.system, paths, result, work.contacts.constraints());
  return result;
}

}  // namespace byhand::doctor
