#include "solver/direct/semismooth_newton.hpp"

#include <array>

#include "solver/direct/newton_work.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// One solve of Newton's method.
template <class M>
class NewtonSolve {
 public:
  NewtonSolve(const SemismoothNewton& solver, System<M>& system, Bodies<M>& bodies, NewtonWork<M>& work)
      : solver_(solver), system_(system), velocity_(bodies.velocity), bodies_(bodies), work_(work) {}

  Solution run() {
    speed_ = fastest(system_, velocity_);
    look();
    if (!solved()) sweep_on();
    if (solved()) return reached();
    keep_best();
    begin_from_here();
    while (solution_.rounds < solver_.rounds && !solved_within_bounds()) {
      ++solution_.rounds;
      find_step();
      const bool fell = take_step();
      if (fell && reached_.largest < best_) keep_best();
      if (fell && (inner_.largest <= 0.1 * outer_ || inner_.within(solver_.tolerance, speed_))) {
        if (inner_rounds_ <= 4) epsilon_ = std::max(1e-10, 0.1 * epsilon_);
        begin_from_here();
      } else if (!fell || inner_rounds_ >= most_inner_rounds) {
        back_to_best();
      }
    }
    if (!solved()) {
      to_best();
      hold();
    }
    return reached();
  }

 private:
  static constexpr int dof = M::dof, most_inner_rounds = 40, most_halvings = 15, memory = 4;
  using Row = Packed<double, 1, 2 * dof>;

  bool solved() const { return reached_.within(solver_.tolerance, speed_); }
  Solution reached() const { return {solution_.passes, solution_.rounds, reached_.largest, solved()}; }

  double damping(int row) const { return system_.gamma[row] + epsilon_ * work_.scales.D[row]; }
  double normal_of(const BlockHeader& block) const {
    return larger(0, (held_radius_ ? work_.centre : system_.lambda)[block.normal_row]);
  }

  /// Finds e with the term of λ°, the residual of the rows, and that of the rows with the term; returns Σ F², as
  /// squares of speeds.
  double look() {
    errors_of(system_, velocity_, system_.lambda, work_.error);
    reached_ = inner_ = {};
    double sum = 0;
    system_.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
      for (const auto& block : blocks) {
        const int row = block.row;
        const Eigen::Map<const Rows<K>> now(&system_.lambda[row]);
        const double *D = &work_.scales.D[row], *speed = &work_.scales.speed[row];
        const auto natural_map = [&](double normal) {
          Rows<K> next = now;
          for (int k = 0; k < K; ++k)
            if (D[k] != 0) next[k] -= work_.error[row + k] / D[k];
          return Rows<K>(bounded<K, B>(next, system_.lower[row], system_.upper[row], normal) - now);
        };
        const auto note = [&](Residual& residual, int k, double change) {
          residual.largest = larger(residual.largest, speed[k] * std::abs(change));
          residual.largest_lambda = larger(residual.largest_lambda, speed[k] * std::abs(now[k]));
        };
        const Rows<K> whole =
            natural_map(B == Bound::friction ? larger(0, system_.lambda[block.normal_row]) : 0.0);
        for (int k = 0; k < K; ++k) {
          note(reached_, k, whole[k]);
          if (centred_) work_.error[row + k] += epsilon_ * D[k] * (now[k] - work_.centre[row + k]);
        }
        const Rows<K> near = natural_map(B == Bound::friction ? normal_of(block) : 0.0);
        for (int k = 0; k < K; ++k) {
          note(inner_, k, near[k]);
          sum += speed[k] * near[k] * speed[k] * near[k];
        }
      }
    });
    return sum;
  }

  //! [step of Newton's method]
  void press(int row, const auto& J) {
    work_.h[row] = -work_.error[row] / damping(row);
    work_.R[row] = J / damping(row);
  }
  void stop(int row, double change) {
    work_.h[row] = change;
    work_.R[row].setZero();
  }

  template <int K>
  void write_rows(const Block<M, K, Bound::none>& block) {
    for (int k = 0; k < K; ++k) press_or_leave(block.row + k, block.J.matrix.row(k));
  }
  template <int K>
  void write_rows(const Block<M, K, Bound::interval>& block) {
    const int row = block.row;
    const double now = system_.lambda[row], lower = system_.lower[row], upper = system_.upper[row];
    const double wanted = now - scaled_error(row);
    if (lower < wanted && wanted < upper)
      press_or_leave(row, block.J.matrix.row(0));
    else
      stop(row, std::clamp(wanted, lower, upper) - now);
  }
  template <int K>
  void write_rows(const Block<M, K, Bound::friction>& block) {
    const int row = block.row, normal = block.normal_row;
    const double mu = system_.upper[row], radius = mu * normal_of(block), D = work_.scales.D[row];
    const Eigen::Map<const Rows<K>> now(&system_.lambda[row]);
    Rows<K> d;
    for (int k = 0; k < K; ++k) d[k] = now[k] - scaled_error(row + k);
    const double length = d.norm();
    if (length <= radius) {
      for (int k = 0; k < K; ++k) press_or_leave(row + k, block.J.matrix.row(k));
      return;
    }
    d /= length;
    // Along d friction is as large as its normal allows; a normal of other bodies counts as it is now.
    const bool follows = !held_radius_ && work_.bodies_of[normal] == std::pair{block.body1, block.body2};
    const double along = radius - d.dot(now) + (follows ? mu * work_.h[normal] : 0.0);
    for (int k = 0; k < K; ++k) {
      stop(row + k, along * d[k]);
      if (follows) work_.R[row + k] = mu * d[k] * work_.R[normal];
    }
    if constexpr (K == 2) {  // across d it turns with the slip
      const Rows<2> across(-d[1], d[0]);
      const double share = radius / length, rest = 1 - share * (1 - damping(row) / D);
      const Row J = across[0] * block.J.matrix.row(0) + across[1] * block.J.matrix.row(1);
      for (int k = 0; k < 2; ++k) {
        work_.h[row + k] -= across[k] * across.dot(now) / rest;
        work_.R[row + k] += across[k] * share / (D * rest) * J;
      }
    }
  }
  template <int K>
  void write_rows(const Block<M, K, Bound::manifold>& block) {
    const int row = block.row;
    const double* now = &system_.lambda[row];
    for (int k = 0; k < 2; ++k) {
      if (now[k] - scaled_error(row + k) > 0)
        press_or_leave(row + k, block.J.matrix.row(k));
      else
        stop(row + k, -now[k]);
    }
    const double* normals = held_radius_ ? &work_.centre[row] : now;
    const double mu = system_.upper[row], radius = mu * (larger(0, normals[0]) + larger(0, normals[1]));
    const double wanted = now[2] - scaled_error(row + 2);
    if (std::abs(wanted) <= radius) return press_or_leave(row + 2, block.J.matrix.row(2));
    const double d = wanted > 0 ? 1 : -1, follows = held_radius_ ? 0 : mu * d;
    stop(row + 2, radius * d - now[2] + follows * (work_.h[row] + work_.h[row + 1]));
    work_.R[row + 2] = follows * (work_.R[row] + work_.R[row + 1]);
  }

  /// Rows without effect stay as they are.
  void press_or_leave(int row, const auto& J) { work_.scales.D[row] > 0 ? press(row, J) : stop(row, 0); }
  /// The change of λ by which the row alone would lose its error, negated.
  double scaled_error(int row) const {
    return work_.scales.D[row] > 0 ? work_.error[row] / work_.scales.D[row] : 0.0;
  }

  /// h and R of each row, (1 + M⁻¹JᵀR) ΔV = M⁻¹Jᵀh, and x = h - R ΔV, which becomes `change`.
  void find_step() {
    for (const bool frictions : {false, true})  // they read h and R of their normals
      system_.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
        if ((B == Bound::friction) != frictions) return;
        for (const auto& block : blocks) {
          for (int k = 0; k < K; ++k) work_.bodies_of[block.row + k] = {block.body1, block.body2};
          write_rows(block);
        }
      });
    work_.matrix.reset();
    for_each_moving_side([&]<int K, Bound B>(const Block<M, K, B>& block, int body, int side) {
      for (int k = 0; k < K; ++k) {
        const auto W = block.W.matrix.row(k).template segment<dof>(side).transpose();
        const Row& R = work_.R[block.row + k];
        if (block.moves1) work_.matrix.block(body, block.body1) += W.lazyProduct(R.template head<dof>());
        if (block.moves2) work_.matrix.block(body, block.body2) += W.lazyProduct(R.template tail<dof>());
        work_.matrix.unknown(body) += W * work_.h[block.row + k];
      }
    });
    work_.matrix.factor();
    work_.matrix.solve();
    work_.change = work_.h;
    for_each_moving_side([&]<int K, Bound B>(const Block<M, K, B>& block, int body, int side) {
      for (int k = 0; k < K; ++k)
        work_.change[block.row + k] -=
            work_.R[block.row + k].template segment<dof>(side).dot(work_.matrix.unknown(body));
    });
  }
  //! [step of Newton's method]

  void for_each_moving_side(auto&& f) {
    system_.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
      for (const auto& block : blocks) {
        if (block.moves1) f(block, block.body1, 0);
        if (block.moves2) f(block, block.body2, dof);
      }
    });
  }

  /// Goes along `change`, as far as Σ F² is less than the largest of the last few. Returns whether that was
  /// possible.
  bool take_step() {
    ++inner_rounds_;
    const double highest = *std::max_element(last_.begin(), last_.end());
    work_.before = system_.lambda;
    work_.velocity_before = velocity_;
    double share = 1;
    for (int halvings = 0; halvings < most_halvings; ++halvings, share *= 0.5) {
      for (int row = 0; row < system_.rows(); ++row) {
        work_.h[row] = share * work_.change[row];
        system_.lambda[row] = work_.before[row] + work_.h[row];
      }
      velocity_ = work_.velocity_before;
      apply_all(system_, work_.h, velocity_);
      if (const double sum = look(); sum <= (1 - 0.1 * share) * highest) {
        last_[inner_rounds_ % memory] = sum;
        return true;
      }
    }
    return false;
  }

  /// Makes λ the λ° of what follows.
  void begin_from_here() {
    work_.centre = system_.lambda;
    centred_ = true;
    inner_rounds_ = 0;
    last_.fill(0);
    last_[0] = look();
    outer_ = reached_.largest;
  }

  void back_to_best() {
    to_best();
    sweep_on();
    if (reached_.largest < best_) keep_best();
    epsilon_ = std::min(1e-2, 30 * epsilon_);
    held_radius_ = !held_radius_;
    begin_from_here();
  }

  void sweep_on() {
    solution_.passes += sweep_until(solver_.tolerance, solver_.sweeps, 1, system_, work_.prepared, bodies_).passes;
    look();
  }

  void keep_best() {
    best_ = reached_.largest;
    work_.best = system_.lambda;
    work_.velocity_best = velocity_;
  }
  void to_best() {
    system_.lambda = work_.best;
    velocity_ = work_.velocity_best;
  }

  /// Removes what rounding, or a radius that was held, leaves outside the bounds.
  void hold() {
    work_.before = system_.lambda;
    hold_within_bounds(system_, system_.lambda);
    for (int row = 0; row < system_.rows(); ++row) work_.h[row] = system_.lambda[row] - work_.before[row];
    apply_all(system_, work_.h, velocity_);
    look();
  }
  bool solved_within_bounds() {
    if (solved()) hold();
    return solved();
  }

  const SemismoothNewton& solver_;
  System<M>& system_;
  std::vector<Velocity<M>>& velocity_;
  Bodies<M>& bodies_;
  NewtonWork<M>& work_;
  Solution solution_;
  Residual reached_, inner_;           // of the rows, and of the rows with the term of λ°
  double speed_ = 0;                   // of the fastest body when the solve began [m/s]
  double epsilon_ = 1e-6;              // ε
  bool held_radius_ = false;           // friction's radius is μ λ°_n
  bool centred_ = false;               // there is a λ°
  int inner_rounds_ = 0;               // since λ° was set
  double outer_ = 0, best_ = 0;        // the largest residual then, and the smallest of all [m/s]
  std::array<double, memory> last_{};  // Σ F² of the last steps
};

}  // namespace

template <class M>
Solution SemismoothNewton::solve(System<M>& system, Bodies<M>& bodies, NewtonWork<M>& work, Begin begin) const {
  if (system.rows() == 0) return {};
  if (work.matrix.layout() != system.layout) work.matrix.plan(system, bodies.size());
  prepare(system, BlockSolve::whole, 1.0, work.prepared);
  prepare_to_watch(system, 1.0, work.prepared);
  find_scales(system, work.scales);
  for (auto* numbers : {&work.error, &work.h, &work.change}) numbers->resize(system.rows());
  work.R.resize(system.rows());
  work.bodies_of.resize(system.rows());
  begin_sweeps(system, true, begin, bodies);
  Solution solution = NewtonSolve<M>(*this, system, bodies, work).run();
  solution.row_solves = solution.rounds * (work.matrix.multiplications() / (4 * M::dof) + M::dof * system.rows());
  return solution;
}

#define BYHAND_INSTANTIATE(M) \
  template Solution SemismoothNewton::solve(System<M>&, Bodies<M>&, NewtonWork<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
