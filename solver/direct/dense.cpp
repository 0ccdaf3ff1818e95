#include <Eigen/Cholesky>

#include "solver/direct/equations.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
void solve_dense(const Direct& solver, const System<M>& system, const std::vector<double>& offset,
                 const Bodies<M>& bodies, const std::vector<char>& active, std::vector<double>& change) {
  constexpr int dof = M::dof;
  const int rows = system.rows(), columns = dof * bodies.size();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, columns), W = J;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks)
      for (auto [whole, part] : {std::pair(&J, &block.J), std::pair(&W, &block.W)}) {
        whole->template block<K, dof>(block.row, dof * block.body1) = part->side1();
        whole->template block<K, dof>(block.row, dof * block.body2) = part->side2();
      }
  });
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const Vector V(bodies.velocity.front().data(), columns);
  Eigen::MatrixXd A = J * W.transpose();
  Eigen::VectorXd right = -(J * V + Vector(offset.data(), rows));
  for (int i = 0; i < rows; ++i) {
    if (active.empty() || active[i]) {
      A(i, i) += solver.regularisation * A(i, i) + system.gamma[i];
    } else {
      A.row(i).setZero();
      A.col(i).setZero();
    }
    if (A(i, i) == 0) A(i, i) = 1, right[i] = 0;  // an inactive row or one without effect gets no impulse
  }
  const Eigen::LDLT<Eigen::MatrixXd> factor(A);
  const Eigen::VectorXd pivots = factor.vectorD(), diagonal = factor.transpositionsP() * A.diagonal();
  if (!(pivots.array().abs() > solver.smallest_pivot * diagonal.array()).all()) refuse_singular(system, bodies);
  Eigen::Map<Eigen::VectorXd>(change.data(), rows) = factor.solve(right);
}

#define BYHAND_INSTANTIATE(M)                                                                              \
  template void solve_dense(const Direct&, const System<M>&, const std::vector<double>&, const Bodies<M>&, \
                            const std::vector<char>&, std::vector<double>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
