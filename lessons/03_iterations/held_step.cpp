#include "lessons/03_iterations/held_step.hpp"

#include "lessons/03_iterations/textbook.hpp"
#include "solver/rows/operators.hpp"

namespace byhand::iterations {

HeldStep::HeldStep(const ChainOptions& chain, double h, const RowSolver& solver)
    : chain_(chain), h_(h), solver_(solver), scene_(rod_chain<PlaneParticle>(chain)) {
  lay_out(scene_, solver_, work_);
  scene_.write_rows(work_.system, h);
  add_gravity(scene_.state(), scene_.gravity, h);
  prepare(work_.system, BlockSolve::whole, 1.0, prepared_);
}

//! [row]
void HeldStep::solve_row() {
  const auto& rows = std::get<block_type<PlaneParticle, 1, Bound::none>()>(prepared_.blocks);
  const auto& row = rows[next_];
  double *lambda = work_.system.lambda.data(), *V = numbers<PlaneParticle>(scene_.state().velocity);
  const Rows<1> change = byhand::solve<false>(row, V, lambda);  // (17)
  lambda[row.row] += change[0];
  apply<PlaneParticle, 1>(row, change, V);  // (20)
  next_ = (next_ + 1) % rows.size();
}
//! [row]

void HeldStep::solve_sweep() {
  for (int i = 0; i < chain_.links; ++i) solve_row();
}

void HeldStep::solve() { solve_rows(solver_, scene_.state(), work_); }

std::vector<double> HeldStep::lambda() const {
  std::vector<double> by_joint;
  for (const int row : work_.system.row_of) by_joint.push_back(work_.system.lambda[row]);
  return by_joint;
}

void HeldStep::start_from(const std::vector<double>& lambda) {
  for (int joint = 0; joint < chain_.links; ++joint)
    work_.system.lambda[work_.system.row_of[joint]] = lambda[joint];
}

std::vector<double> HeldStep::shares() const {
  const double weight = -scene_.gravity.y() * ((chain_.links - 1) * chain_.mass + chain_.end_mass);
  std::vector<double> shares = lambda();
  for (double& share : shares) share *= -chain_.length / (h_ * weight);
  return shares;
}

std::vector<double> HeldStep::errors() const {
  std::vector<double> errors;
  const auto& pose = scene_.bodies().pose;
  const auto& velocity = scene_.bodies().velocity;
  for (const auto& rod : scene_.all<Distance>()) {
    const auto J = rod.jacobian(pose[rod.at.body1], pose[rod.at.body2]);
    errors.push_back(dot(J, velocity[rod.at.body1], velocity[rod.at.body2])[0] / rod.length);
  }
  return errors;
}

double HeldStep::error() const { return residual(work_.system, scene_.bodies().velocity); }

std::vector<double> HeldStep::speeds() const {
  std::vector<double> speeds;
  for (int bob = 1; bob <= chain_.links; ++bob) speeds.push_back(-scene_.bodies().velocity[bob].y());
  return speeds;
}

double measured_digit(const ChainOptions& chain, double h) {
  return sweeps_per_digit(measured_factor(GaussSeidel{.warm_start = false}, chain, h));
}

}  // namespace byhand::iterations
