#include "lessons/doctor/treatment.hpp"

namespace byhand::doctor {
namespace {

void add(Treatment& treatment, const NoDriftCure&) { treatment.stale = true; }
void add(Treatment& treatment, const Baumgarte& cure) {
  treatment.beta = cure.beta, treatment.slop = cure.slop;
  treatment.adds_velocity = true;
}
void add(Treatment& treatment, const SplitImpulse& cure) {
  treatment.beta = cure.beta, treatment.slop = cure.slop;
}
void add(Treatment& treatment, const Projection& cure) { treatment.beta = cure.share, treatment.slop = cure.slop; }
void add(Treatment& treatment, const SoftConstraints& cure) {
  const double turn = treatment.h * cure.frequency;
  treatment.beta = turn / (2 * cure.damping_ratio + turn);
  treatment.frequency = cure.frequency;
  treatment.stale = cure.relax && !cure.refresh;
}

}  // namespace

Treatment treatment_of(const SceneFile& file) {
  Treatment treatment;
  treatment.h = file.step / file.method.substeps;
  if (const auto* sweeps = std::get_if<GaussSeidel>(&file.method.solver)) {
    treatment.passes = sweeps->sweeps * passes(sweeps->order);
    treatment.warm_start = sweeps->warm_start;
  }
  if (const auto* jacobi = std::get_if<Jacobi>(&file.method.solver)) {
    treatment.passes = jacobi->sweeps;
    treatment.warm_start = jacobi->warm_start;
  }
  if (const auto* direct = std::get_if<Direct>(&file.method.solver))
    treatment.regularised = direct->regularisation > 0;
  std::visit([&](const auto& cure) { add(treatment, cure); }, file.method.drift);
  return treatment;
}

RowSolver one_sweep_of(const RowSolver& solver) {
  RowSolver one = solver;
  if (auto* sweeps = std::get_if<GaussSeidel>(&one)) sweeps->sweeps = 1, sweeps->tolerance = 0;
  if (auto* jacobi = std::get_if<Jacobi>(&one)) jacobi->sweeps = 1;
  return one;
}

}  // namespace byhand::doctor
