#include "solver/direct/direct.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace byhand {
namespace {

// A pivot below this share of its row's own diagonal is rounding, not physics.
constexpr double smallest_pivot = 1e-13;
constexpr int largest_size = 6;  // of any model's rows or degrees of freedom

[[noreturn]] void refuse_singular() {
  throw SingularSystem(
      "the direct solve met a row that repeats or contradicts other rows, so that its impulses have no "
      "single answer; "
      "remove what repeats, or set a regularisation above 0 (1e-9 is a good start)");
}

/// A block's size, known to the compiler where it can be: all edges have S rows, all hubs dof; S = 0 asks the
/// node.
template <int S, int dof, class F>
inline void with_size(const Elimination::Node& node, F&& f) {
  if constexpr (S == 0)
    f(node.size);
  else if (S == dof || node.edge >= 0)
    f(std::integral_constant<int, S>());
  else
    f(std::integral_constant<int, dof>());
}

/// Inverse of a symmetric n × n matrix in place, by symmetric sweeps without pivoting: the order of
/// elimination makes every pivot definite, positive for edges and negative for hubs. A row that has no effect
/// to begin with (zero on its `diagonal`) gets zeros, and so no impulse. Returns whether every pivot stands
/// out from rounding.
template <class Size>
inline bool invert(double* A, const double* diagonal, Size n) {
  if constexpr (std::is_same_v<Size, std::integral_constant<int, 2>>) {
    const double determinant = A[0] * A[3] - A[1] * A[1];
    if (std::abs(determinant) > smallest_pivot * std::abs(diagonal[0] * diagonal[1])) {
      // One division instead of two that wait for each other.
      const double inverse = 1 / determinant, first = A[0];
      A[0] = A[3] * inverse;
      A[3] = first * inverse;
      A[1] = A[2] = -A[1] * inverse;
      return true;
    }
  }
  if constexpr (std::is_same_v<Size, std::integral_constant<int, 3>>) {
    const double c00 = A[4] * A[8] - A[5] * A[5], c01 = A[5] * A[2] - A[1] * A[8], c02 = A[1] * A[5] - A[4] * A[2];
    const double determinant = A[0] * c00 + A[1] * c01 + A[2] * c02;
    if (std::abs(determinant) > smallest_pivot * std::abs(diagonal[0] * diagonal[1] * diagonal[2])) {
      const double inverse = 1 / determinant;
      const double c11 = A[0] * A[8] - A[2] * A[2], c12 = A[1] * A[2] - A[0] * A[5],
                   c22 = A[0] * A[4] - A[1] * A[1];
      A[0] = c00 * inverse;
      A[4] = c11 * inverse;
      A[8] = c22 * inverse;
      A[1] = A[3] = c01 * inverse;
      A[2] = A[6] = c02 * inverse;
      A[5] = A[7] = c12 * inverse;
      return true;
    }
  }
  bool regular = true;
  for (int p = 0; p < n; ++p) {
    double* row = A + p * n;
    const double pivot = row[p];
    regular = regular && (std::abs(pivot) > smallest_pivot * std::abs(diagonal[p]) || diagonal[p] == 0);
    const double inverse = diagonal[p] == 0 ? 0.0 : 1 / pivot;
    for (int i = 0; i < n; ++i)
      if (i != p) {
        const double scale = A[i * n + p] * inverse;
        for (int j = 0; j < n; ++j)
          if (j != p) A[i * n + j] -= scale * row[j];
      }
    for (int i = 0; i < n; ++i)
      if (i != p) A[i * n + p] = row[i] = -row[i] * inverse;
    row[p] = -inverse;
  }
  for (int i = 0; i < n * n; ++i) A[i] = -A[i];
  return regular;
}

/// -M of a hub, which is where its unknown ΔV enters: Jᵀλ - M ΔV = 0.
template <class M>
void write_minus_mass(const InverseMass<M>& inverse_mass, const Pose<M>& pose, double* D) {
  Eigen::Map<Eigen::Matrix<double, M::dof, M::dof, Eigen::RowMajor>> mass(D);
  mass.setZero();
  mass.diagonal().template head<M::linear>().setConstant(-1 / inverse_mass.linear);
  if constexpr (M::angular > 0)
    mass.template bottomRightCorner<M::angular, M::angular>() = -inertia(inverse_mass, pose);
}

/// Fills the blocks with the matrix and the unknowns with the right-hand side.
template <int S, class M>
void assemble(const Direct& solver, const System<M>& system, const double* offset, const Bodies<M>& bodies,
              DirectWork<M>& work) {
  constexpr int dof = M::dof;
  // Held here, for all the compiler knows each number that is written might move the vectors.
  const std::span nodes(work.plan.nodes);
  const auto* views = work.views.data();
  double *values = work.values.data(), *unknowns = work.unknowns.data(), *diagonals = work.diagonal.data();
  const double *V = bodies.velocity.front().data(), *gamma = system.gamma.data();
  const double regularisation = solver.regularisation;
  for (const auto& [first, count] : work.plan.fill_in) std::fill_n(values + first, count, 0.0);
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    const auto& node = nodes[p];
    double *D = values + node.diagonal, *b = unknowns + node.row, *diagonal = diagonals + node.row;
    if (node.edge < 0) {
      write_minus_mass<M>(bodies.inverse_mass[node.hub], bodies.pose[node.hub], D);
      for (int i = 0; i < dof; ++i) {
        diagonal[i] = D[i * (dof + 1)];
        b[i] = 0;
      }
      continue;
    }
    const auto view = views[p];
    const double *v1 = V + dof * view.body1, *v2 = V + dof * view.body2;
    const bool folded = view.folded1 && view.folded2;
    with_size<S, dof>(node, [&](auto n) {
      for (int k = 0; k < n; ++k) {
        const double* J = view.J + 2 * dof * k;
        double rate = 0, late = offset[view.row + k];
        for (int i = 0; i < dof; ++i) {
          rate += J[i] * v1[i];
          late += J[dof + i] * v2[i];
        }
        b[k] = -(rate + late);
        for (int l = 0; l <= k; ++l) {
          const double* W = view.W + 2 * dof * l;
          double by_body1 = J[0] * W[0], by_body2 = J[dof] * W[dof];
          for (int i = 1; i < dof; ++i) {
            by_body1 += J[i] * W[i];
            by_body2 += J[dof + i] * W[dof + i];
          }
          const double whole = by_body1 + by_body2;
          double entry = folded ? whole : (view.folded1 ? by_body1 : 0.0) + (view.folded2 ? by_body2 : 0.0);
          if (k == l) {
            const double soft = regularisation * whole + gamma[view.row + k];
            diagonal[k] = whole + soft;
            entry += soft;
          }
          D[k * n + l] = D[l * n + k] = entry;
        }
      }
    });
  }
  for (const auto& coupling : work.plan.couplings) {
    const auto &earlier = nodes[coupling.earlier], &later = nodes[coupling.later];
    double* block = values + coupling.block;
    const double* J = (earlier.edge < 0 ? views[coupling.later].J + dof * coupling.later_side
                                        : views[coupling.earlier].J + dof * coupling.earlier_side);
    if (later.edge < 0) {
      with_size<S, dof>(earlier, [&](auto n) {
        for (int i = 0; i < dof; ++i)
          for (int k = 0; k < n; ++k) block[i * n + k] = J[2 * dof * k + i];
      });
    } else if (earlier.edge < 0) {
      with_size<S, dof>(later, [&](auto n) {
        for (int k = 0; k < n; ++k)
          for (int i = 0; i < dof; ++i) block[k * dof + i] = J[2 * dof * k + i];
      });
    } else {
      const double* W = views[coupling.later].W + dof * coupling.later_side;
      with_size<S, dof>(earlier, [&](auto n) {
        with_size<S, dof>(later, [&](auto m) {
          for (int l = 0; l < m; ++l)
            for (int k = 0; k < n; ++k) {
              double sum = W[2 * dof * l] * J[2 * dof * k];
              for (int i = 1; i < dof; ++i) sum += W[2 * dof * l + i] * J[2 * dof * k + i];
              block[l * n + k] = coupling.adds ? block[l * n + k] + sum : sum;
            }
        });
      });
    }
  }
}

//! [factor]
/// Eliminates node after node: the blocks become L and the inverses of the pivots D, A = L D Lᵀ, and the
/// unknowns become L⁻¹ times the right-hand side.
template <int S, int dof>
void eliminate(const Elimination& plan, double* values, double* unknowns, const double* diagonal) {
  bool regular = true;
  for (const auto& node : plan.nodes)
    with_size<S, dof>(node, [&](auto n) {
      double* D = values + node.diagonal;
      const double* x = unknowns + node.row;
      regular = invert(D, diagonal + node.row, n) && regular;
      for (int a = node.first; a < node.last; ++a) {
        const auto& neighbour = plan.neighbours[a];
        with_size<S, dof>(plan.nodes[neighbour.node], [&](auto m) {
          double* A = values + neighbour.block;
          double L[largest_size * largest_size];
          for (int i = 0; i < m; ++i)
            for (int k = 0; k < n; ++k) {
              double sum = A[i * n] * D[k];
              for (int l = 1; l < n; ++l) sum += A[i * n + l] * D[l * n + k];
              L[i * n + k] = sum;
            }
          const int* target = &plan.targets[neighbour.targets];
          for (int b = a; b < node.last; ++b, ++target) {
            const double* B = values + plan.neighbours[b].block;
            double* into = values + *target;
            with_size<S, dof>(plan.nodes[plan.neighbours[b].node], [&](auto r) {
              for (int j = 0; j < r; ++j)
                for (int i = 0; i < m; ++i) {
                  double sum = B[j * n] * L[i * n];
                  for (int k = 1; k < n; ++k) sum += B[j * n + k] * L[i * n + k];
                  into[j * m + i] -= sum;
                }
            });
          }
          double* y = unknowns + plan.nodes[neighbour.node].row;
          for (int i = 0; i < m; ++i) {
            double sum = L[i * n] * x[0];
            for (int k = 1; k < n; ++k) sum += L[i * n + k] * x[k];
            y[i] -= sum;
          }
          for (int i = 0; i < m * n; ++i) A[i] = L[i];
        });
      }
    });
  if (!regular) refuse_singular();
}
//! [factor]

/// From the last node back to the first: x = D⁻¹y - Lᵀ x_later, of which `change` becomes the edges' part.
template <int S, class M>
void substitute_back(DirectWork<M>& work, double* change) {
  const Elimination& plan = work.plan;
  const double* values = work.values.data();
  double* unknowns = work.unknowns.data();
  for (std::size_t p = plan.nodes.size(); p-- > 0;) {
    const auto& node = plan.nodes[p];
    with_size<S, M::dof>(node, [&](auto n) {
      const double* D = values + node.diagonal;
      double* x = unknowns + node.row;
      double solved[largest_size];
      for (int k = 0; k < n; ++k) {
        double sum = D[k * n] * x[0];
        for (int l = 1; l < n; ++l) sum += D[k * n + l] * x[l];
        solved[k] = sum;
      }
      for (int a = node.first; a < node.last; ++a) {
        const auto& later = plan.nodes[plan.neighbours[a].node];
        const double *L = values + plan.neighbours[a].block, *y = unknowns + later.row;
        with_size<S, M::dof>(later, [&](auto m) {
          for (int i = 0; i < m; ++i)
            for (int k = 0; k < n; ++k) solved[k] -= L[i * n + k] * y[i];
        });
      }
      for (int k = 0; k < n; ++k) x[k] = solved[k];
      if (node.edge < 0) return;
      double* to = change + work.views[p].row;
      for (int k = 0; k < n; ++k) to[k] = solved[k];
    });
  }
}

template <int S, class M>
void solve_structured(const Direct& solver, const System<M>& system, const double* offset, const Bodies<M>& bodies,
                      DirectWork<M>& work, double* change) {
  assemble<S>(solver, system, offset, bodies, work);
  eliminate<S, M::dof>(work.plan, work.values.data(), work.unknowns.data(), work.diagonal.data());
  substitute_back<S>(work, change);
}

/// Copies the blocks that have bounds, without their inactive rows.
template <class M>
void mask_blocks(const System<M>& system, DirectWork<M>& work) {
  system.for_each_type([&]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) {
    if constexpr (B != Bound::none) {
      auto& masked = std::get<block_type<M, K, B>()>(work.masked);
      masked = blocks;
      for (auto& block : masked)
        for (int k = 0; k < K; ++k)
          if (!work.active[block.row + k]) {
            block.J.matrix.row(k).setZero();
            block.W.matrix.row(k).setZero();
          }
    }
  });
}

/// Where each node finds its J and M⁻¹Jᵀ. That changes only with the layout, or where the blocks stand.
template <class M>
void view_blocks(const System<M>& system, DirectWork<M>& work) {
  const Elimination& plan = work.plan;
  const auto seen = [&]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) -> const auto& {
    return B == Bound::none || work.active.empty() ? blocks : std::get<block_type<M, K, B>()>(work.masked);
  };
  typename DirectWork<M>::FirstJ first{};
  system.for_each_type([&]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) {
    if (!blocks.empty()) first[block_type<M, K, B>()] = seen(blocks).front().J.matrix.data();
  });
  if (work.layout == system.layout && work.viewed == first) return;
  work.layout = system.layout;
  work.viewed = first;
  work.views.resize(plan.nodes.size());
  work.size = -1;
  work.answered = 0;
  std::size_t p = 0;
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (const auto& block : part(seen(std::get<type>(system.blocks)), run)) {
        while (p < plan.nodes.size() && plan.nodes[p].edge < 0) ++p;
        if (p == plan.nodes.size()) return;  // edges between fixed bodies follow
        const int rows = plan.nodes[p].size;
        work.size = work.size == -1 || work.size == rows ? rows : 0;
        work.answered = block.row + rows;
        work.views[p++] = {
            block.J.matrix.data(),         block.W.matrix.data(),        block.row, block.body1, block.body2,
            plan.folded[block.body1] != 0, plan.folded[block.body2] != 0};
      }
    });
}

template <class M>
void solve_dense(const Direct& solver, const System<M>& system, const double* offset, const Bodies<M>& bodies,
                 const std::vector<char>& active, double* change) {
  constexpr int dof = M::dof;
  const int rows = system.rows();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, dof * bodies.size()), W = J;
  Eigen::VectorXd V(dof * bodies.size());
  for (int body = 0; body < bodies.size(); ++body) V.segment<dof>(dof * body) = bodies.velocity[body];
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks)
      for (int k = 0; k < K; ++k)
        for (int i = 0; i < dof; ++i) {
          J(block.row + k, dof * block.body1 + i) = block.J.matrix(k, i);
          J(block.row + k, dof * block.body2 + i) = block.J.matrix(k, dof + i);
          W(block.row + k, dof * block.body1 + i) = block.W.matrix(k, i);
          W(block.row + k, dof * block.body2 + i) = block.W.matrix(k, dof + i);
        }
  });
  Eigen::MatrixXd A = J * W.transpose();
  Eigen::VectorXd right = -(J * V + Eigen::Map<const Eigen::VectorXd>(offset, rows));
  for (int i = 0; i < rows; ++i) {
    if (!active.empty() && !active[i]) {
      A.row(i).setZero();
      A.col(i).setZero();
      right[i] = 0;
      A(i, i) = 1;
      continue;
    }
    A(i, i) += solver.regularisation * A(i, i) + system.gamma[i];
    if (A(i, i) == 0) A(i, i) = 1, right[i] = 0;  // a row without effect gets no impulse
  }
  const Eigen::LDLT<Eigen::MatrixXd> factor(A);
  const Eigen::VectorXd pivots = factor.vectorD(), diagonal = factor.transpositionsP() * A.diagonal();
  if ((pivots.array().abs() <= smallest_pivot * diagonal.array()).any()) refuse_singular();
  Eigen::Map<Eigen::VectorXd>(change, rows) = factor.solve(right);
}

}  // namespace

template <class M>
void solve_equations(const Direct& solver, const System<M>& system, const std::vector<double>& offset,
                     const Bodies<M>& bodies, DirectWork<M>& work, std::vector<double>& change) {
  const double* b = offset.data();
  double* x = change.data();
  if (solver.factorisation == Factorisation::dense) {
    solve_dense(solver, system, b, bodies, work.active, x);
    return;
  }
  work.values.resize(work.plan.values);
  work.unknowns.resize(work.plan.unknowns);
  work.diagonal.resize(work.plan.unknowns);
  if (!work.active.empty()) mask_blocks(system, work);
  view_blocks(system, work);
  if (work.size == 1)
    solve_structured<1>(solver, system, b, bodies, work, x);
  else if (work.size == M::linear)
    solve_structured<M::linear>(solver, system, b, bodies, work, x);
  else if (M::dof == 3 && work.size == 3)  // welds and faces
    solve_structured<3>(solver, system, b, bodies, work, x);
  else
    solve_structured<0>(solver, system, b, bodies, work, x);
  // Between fixed bodies a row's own softness alone can answer.
  for (int row = work.answered; row < system.rows(); ++row)
    x[row] = system.gamma[row] > 0 ? -b[row] / system.gamma[row] : 0.0;
}

template <class M>
void solve_again(const std::vector<double>& offset, DirectWork<M>& work, std::vector<double>& change) {
  const Elimination& plan = work.plan;
  std::fill(work.unknowns.begin(), work.unknowns.end(), 0.0);
  std::fill(change.begin(), change.end(), 0.0);
  for (std::size_t p = 0; p < plan.nodes.size(); ++p)
    for (int k = 0; plan.nodes[p].edge >= 0 && k < plan.nodes[p].size; ++k)
      work.unknowns[plan.nodes[p].row + k] = -offset[work.views[p].row + k];
  for (const auto& node : plan.nodes)  // L⁻¹ times the right-hand side
    for (int a = node.first; a < node.last; ++a) {
      const auto& later = plan.nodes[plan.neighbours[a].node];
      const double* L = &work.values[plan.neighbours[a].block];
      for (int i = 0; i < later.size; ++i)
        for (int k = 0; k < node.size; ++k)
          work.unknowns[later.row + i] -= L[i * node.size + k] * work.unknowns[node.row + k];
    }
  substitute_back<0>(work, change.data());
}

long long direct_row_solves(const Direct& solver, const Elimination& plan, long long rows, int dof) {
  const long long dense = rows * rows * rows / 6 + rows * rows;
  return (solver.factorisation == Factorisation::dense ? dense : plan.multiplications) / (4 * dof) + 1;
}

long long row_solves_again(const Elimination& plan, int dof) {
  long long multiplications = 0;
  for (const auto& node : plan.nodes) {
    multiplications += node.size * node.size;
    for (int a = node.first; a < node.last; ++a)
      multiplications += 2 * node.size * plan.nodes[plan.neighbours[a].node].size;
  }
  return multiplications / (4 * dof) + 1;
}

#define BYHAND_INSTANTIATE(M)                                                                                  \
  template void solve_again(const std::vector<double>&, DirectWork<M>&, std::vector<double>&);                 \
  template void solve_equations(const Direct&, const System<M>&, const std::vector<double>&, const Bodies<M>&, \
                                DirectWork<M>&, std::vector<double>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
