#include "solver/direct/equations.hpp"

#include <algorithm>
#include <cmath>

#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
void refuse_singular(const System<M>& system, const Bodies<M>& bodies) {
  require_finite<M>(bodies.pose, bodies.velocity, "");
  system.for_each_type([]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) {
    for (const auto& block : blocks)
      if (!inverse_effective_mass(block.J, block.W).allFinite())
        throw NotFinite("JM⁻¹Jᵀ between body " + std::to_string(block.body1) + " and body " +
                        std::to_string(block.body2) + " is not a finite number");
  });
  throw SingularSystem(
      "the direct solve met a row that repeats or contradicts other rows, so that its impulses have no single "
      "answer; remove what repeats, or set a regularisation above 0 (1e-9 is a good start)");
}

namespace {

constexpr int largest_size = std::max(most_rows<SpaceBody>, SpaceBody::dof);  // of any model

template <int n>
using Constant = std::integral_constant<int, n>;

/// Calls f(the node's size), as a constant where all edges have S rows; S = 0 where they differ.
template <int S, int dof, class F>
inline void with_size(const Elimination::Node& node, F&& f) {
  if constexpr (S == 0)
    f(node.size);
  else if (S == dof || node.edge >= 0)
    f(Constant<S>());
  else
    f(Constant<dof>());
}

// Products of small row-major matrices. Sums run in ascending order.

/// Σₖ a[k] b[k stride] of n >= 1 terms.
template <class Size>
inline double dot(const double* a, const double* b, Size n, int stride = 1) {
  double sum = a[0] * b[0];
  for (int k = 1; k < n; ++k) sum += a[k] * b[k * stride];
  return sum;
}

/// C -= A Bᵀ, where A is m × n, B is r × n and C is m × r.
template <class Rows, class Columns, class Terms>
inline void subtract_product(double* C, const double* A, const double* B, Rows m, Columns r, Terms n) {
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < r; ++j) C[i * r + j] -= dot(A + i * n, B + j * n, n);
}

/// Inverts a symmetric n × n matrix in place, by symmetric sweeps without pivoting: in the order of elimination
/// every pivot is definite, positive for edges and negative for hubs. A row without effect, whose `diagonal` was
/// zero before elimination, becomes zero and so gets no impulse. Returns whether every pivot is larger than this
/// share of its diagonal.
template <class Size>
inline bool invert(double* A, const double* diagonal, double smallest_pivot, Size n) {
  if constexpr (std::is_same_v<Size, Constant<2>>) {
    const double determinant = A[0] * A[3] - A[1] * A[1];
    if (std::abs(determinant) > smallest_pivot * std::abs(diagonal[0] * diagonal[1])) {
      const double inverse = 1 / determinant, first = A[0];  // one division instead of two in sequence
      A[0] = A[3] * inverse;
      A[3] = first * inverse;
      A[1] = A[2] = -A[1] * inverse;
      return true;
    }
  }
  if constexpr (std::is_same_v<Size, Constant<3>>) {
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

/// -M of a hub: its unknown ΔV obeys Jᵀλ - M ΔV = 0.
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
  // Local copies: the compiler cannot know that no write changes the originals.
  const auto* nodes = work.plan.nodes.data();
  const auto* views = work.views.data();
  const char* is_folded = work.plan.folded.data();
  double *values = work.values.data(), *unknowns = work.unknowns.data(), *diagonals = work.diagonal.data(),
         *right = work.right.data();
  const double *V = bodies.velocity.front().data(), *gamma = system.gamma.data(),
               regularisation = solver.regularisation;
  for (const auto& [first, count] : work.plan.fill_in) std::fill_n(values + first, count, 0.0);
  for (const auto& node : work.plan.nodes) {
    double *D = values + node.diagonal, *b = unknowns + node.row, *diagonal = diagonals + node.row;
    if (node.edge < 0) {
      write_minus_mass<M>(bodies.inverse_mass[node.hub], bodies.pose[node.hub], D);
      for (int i = 0; i < dof; ++i) {
        diagonal[i] = D[i * (dof + 1)];
        b[i] = 0;
      }
      continue;
    }
    const auto view = views[node.edge];
    const double *v1 = V + dof * view.body1, *v2 = V + dof * view.body2;
    const bool folded1 = is_folded[view.body1], folded2 = is_folded[view.body2], folded = folded1 && folded2;
    with_size<S, dof>(node, [&](auto n) {
      for (int k = 0; k < n; ++k) {
        const double* J = view.J + 2 * dof * k;
        double rate = 0, late = offset[node.lambda + k];
        for (int i = 0; i < dof; ++i) {
          rate += J[i] * v1[i];
          late += J[dof + i] * v2[i];
        }
        b[k] = right[node.lambda + k] = -(rate + late);
        for (int l = 0; l <= k; ++l) {
          const double* W = view.W + 2 * dof * l;
          const double by_body1 = dot(J, W, Constant<dof>()), by_body2 = dot(J + dof, W + dof, Constant<dof>());
          const double whole = by_body1 + by_body2;
          double entry = folded ? whole : (folded1 ? by_body1 : 0.0) + (folded2 ? by_body2 : 0.0);
          if (k == l) {
            const double soft = regularisation * whole + gamma[node.lambda + k];
            diagonal[k] = whole + soft;
            entry += soft;
          }
          D[k * n + l] = D[l * n + k] = entry;
        }
      }
    });
  }
  for (const auto& coupling : work.plan.couplings) {
    const auto &earlier = nodes[coupling.earlier.node], &later = nodes[coupling.later.node];
    const double* J = earlier.edge < 0 ? views[later.edge].J + dof * coupling.later.side
                                       : views[earlier.edge].J + dof * coupling.earlier.side;
    double* block = values + coupling.block;
    with_size<S, dof>(earlier, [&](auto n) {
      with_size<S, dof>(later, [&](auto m) {
        for (int i = 0; i < m; ++i)
          for (int k = 0; k < n; ++k) {
            double& entry = block[i * n + k];
            if (later.edge < 0) {
              entry = J[2 * dof * k + i];
            } else if (earlier.edge < 0) {
              entry = J[2 * dof * i + k];
            } else {
              const double* W = views[later.edge].W + dof * coupling.later.side;
              const double term = dot(W + 2 * dof * i, J + 2 * dof * k, Constant<dof>());
              entry = coupling.adds ? entry + term : term;
            }
          }
      });
    });
  }
}

//! [factor]
/// Eliminates node after node: the blocks become L and the inverses of the pivots D, A = L D Lᵀ, and the unknowns
/// become L⁻¹ times the right-hand side. Returns whether every pivot is larger than rounding.
template <int S, int dof>
bool eliminate(const Elimination& plan, double smallest_pivot, double* values, double* unknowns,
               const double* diagonal) {
  bool regular = true;
  for (const auto& node : plan.nodes)
    with_size<S, dof>(node, [&](auto n) {
      double* D = values + node.diagonal;
      regular = invert(D, diagonal + node.row, smallest_pivot, n) && regular;
      for (int a = node.first; a < node.last; ++a) {
        const auto& neighbour = plan.neighbours[a];
        const auto& later = plan.nodes[neighbour.node];
        with_size<S, dof>(later, [&](auto m) {
          double *A = values + neighbour.block, L[largest_size * largest_size];
          for (int i = 0; i < m; ++i)
            for (int k = 0; k < n; ++k) L[i * n + k] = dot(A + i * n, D + k, n, n);
          const int* target = &plan.targets[neighbour.targets];
          for (int b = a; b < node.last; ++b, ++target)
            with_size<S, dof>(plan.nodes[plan.neighbours[b].node], [&](auto r) {
              subtract_product(values + *target, values + plan.neighbours[b].block, L, r, m, n);
            });
          subtract_product(unknowns + later.row, L, unknowns + node.row, m, Constant<1>(), n);
          std::copy_n(L, m * n, A);
        });
      }
    });
  return regular;
}
//! [factor]

/// From the last node back to the first: x = D⁻¹y - Lᵀ x_later. `change` becomes the x of the edges.
template <int S, class M>
void substitute_back(DirectWork<M>& work, double* change) {
  const Elimination& plan = work.plan;
  const double* values = work.values.data();
  double* unknowns = work.unknowns.data();
  for (auto node = plan.nodes.rbegin(); node != plan.nodes.rend(); ++node)
    with_size<S, M::dof>(*node, [&](auto n) {
      double *x = unknowns + node->row, solved[largest_size];
      for (int k = 0; k < n; ++k) solved[k] = dot(values + node->diagonal + k * n, x, n);
      for (int a = node->first; a < node->last; ++a) {
        const auto& later = plan.nodes[plan.neighbours[a].node];
        const double *L = values + plan.neighbours[a].block, *y = unknowns + later.row;
        with_size<S, M::dof>(later, [&](auto m) {
          for (int i = 0; i < m; ++i)
            for (int k = 0; k < n; ++k) solved[k] -= L[i * n + k] * y[i];
        });
      }
      std::copy_n(solved, +n, x);
      if (node->edge >= 0) std::copy_n(solved, +n, change + node->lambda);
    });
}

/// Finds J and M⁻¹Jᵀ of every edge. Of bounded blocks these are copies, with zeros in inactive rows.
template <class M>
void view_blocks(const System<M>& system, DirectWork<M>& work) {
  const bool all_active = work.active.empty();
  if (!all_active)
    system.for_each_type([&]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) {
      if constexpr (B != Bound::none) {
        auto& masked = std::get<block_type<M, K, B>()>(work.masked);
        masked = blocks;
        for (auto& block : masked)
          for (int k = 0; k < K; ++k)
            if (!work.active[block.row + k])
              for (auto* matrix : {&block.J.matrix, &block.W.matrix}) matrix->row(k).setZero();
      }
    });
  const auto viewed = [&]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) -> const auto& {
    return B == Bound::none || all_active ? blocks : std::get<block_type<M, K, B>()>(work.masked);
  };
  work.views.resize(work.plan.order.size());
  auto* view = work.views.data();
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (const auto& block : part(viewed(std::get<type>(system.blocks)), run))
        *view++ = {block.J.matrix.data(), block.W.matrix.data(), block.body1, block.body2};
    });
}

}  // namespace

template <class M>
void solve_equations(const Direct& solver, const System<M>& system, const std::vector<double>& offset,
                     const Bodies<M>& bodies, DirectWork<M>& work, std::vector<double>& change) {
  if (solver.factorisation == Factorisation::dense)
    return solve_dense(solver, system, offset, bodies, work.active, change);
  const Elimination& plan = work.plan;
  work.values.resize(plan.values);
  work.unknowns.resize(plan.unknowns);
  work.diagonal.resize(plan.unknowns);
  work.right.resize(system.rows());
  view_blocks(system, work);
  const auto structured = [&]<int S>(Constant<S>) {
    assemble<S>(solver, system, offset.data(), bodies, work);
    if (!eliminate<S, M::dof>(plan, solver.smallest_pivot, work.values.data(), work.unknowns.data(),
                              work.diagonal.data()))
      refuse_singular(system, bodies);
    substitute_back<S>(work, change.data());
  };
  if (plan.edge_size == 1)
    structured(Constant<1>());
  else if (plan.edge_size == M::linear)
    structured(Constant<M::linear>());
  else if (M::dof == 3 && plan.edge_size == 3)  // welds and faces
    structured(Constant<3>());
  else
    structured(Constant<0>());
  for (int row = plan.edge_rows; row < system.rows(); ++row) {  // between fixed bodies only softness can give way
    change[row] = system.gamma[row] > 0 ? -offset[row] / system.gamma[row] : 0.0;
    work.right[row] = 0;
  }
}

template <class M>
void solve_again(const std::vector<double>& offset, DirectWork<M>& work, std::vector<double>& change) {
  const Elimination& plan = work.plan;
  std::fill(change.begin(), change.end(), 0.0);
  for (const auto& node : plan.nodes)
    for (int k = 0; k < node.size; ++k)
      work.unknowns[node.row + k] = node.edge < 0 ? 0.0 : -offset[node.lambda + k];
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

#define BYHAND_INSTANTIATE(M)                                                                                  \
  template void refuse_singular(const System<M>&, const Bodies<M>&);                                           \
  template void solve_again(const std::vector<double>&, DirectWork<M>&, std::vector<double>&);                 \
  template void solve_equations(const Direct&, const System<M>&, const std::vector<double>&, const Bodies<M>&, \
                                DirectWork<M>&, std::vector<double>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
