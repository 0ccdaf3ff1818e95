#include "lessons/catalogue/code.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace byhand {
namespace {

/// A struct with those of its members that are not as they are by default.
class Struct {
 public:
  explicit Struct(std::string name) : name_(std::move(name)) {}

  template <class T>
  Struct& with(const char* member, const T& value, const T& usual) {
    if (value == usual) return *this;
    return with(member, fmt::format("{}", value));
  }
  Struct& with(const char* member, const std::string& value) {
    members_ += fmt::format("{}.{} = {}", members_.empty() ? "" : ", ", member, value);
    return *this;
  }
  std::string text() const { return name_ + "{" + members_ + "}"; }

 private:
  std::string name_, members_;
};

std::string text_of(const GaussSeidel& solver) {
  Struct text("GaussSeidel");
  text.with("sweeps", solver.sweeps, GaussSeidel{}.sweeps);
  if (solver.order == SweepOrder::symmetric) text.with("order", "SweepOrder::symmetric");
  return text.with("relaxation", solver.relaxation, GaussSeidel{}.relaxation).text();
}
std::string text_of(const Jacobi& solver) {
  return Struct("Jacobi")
      .with("sweeps", solver.sweeps, Jacobi{}.sweeps)
      .with("relaxation", solver.relaxation, Jacobi{}.relaxation)
      .text();
}
std::string text_of(const Direct& solver) {
  return Struct("Direct").with("regularisation", solver.regularisation, Direct{}.regularisation).text();
}
std::string text_of(const ConjugateSweeps& solver) {
  return Struct("ConjugateSweeps")
      .with("sweeps", solver.sweeps, ConjugateSweeps{}.sweeps)
      .with("tolerance", solver.tolerance, ConjugateSweeps{}.tolerance)
      .text();
}
std::string text_of(const SemismoothNewton& solver) {
  return Struct("SemismoothNewton").with("rounds", solver.rounds, SemismoothNewton{}.rounds).text();
}
std::string text_of(const ByGraph&) { return "ByGraph{}"; }
template <class Iterative>
std::string text_of_iterative(const char* name, const Iterative& solver) {
  return Struct(name)
      .with("iterations", solver.iterations, Iterative{}.iterations)
      .with("tolerance", solver.tolerance, Iterative{}.tolerance)
      .text();
}
std::string text_of(const ConjugateGradients& solver) { return text_of_iterative("ConjugateGradients", solver); }
std::string text_of(const AcceleratedGradient& solver) { return text_of_iterative("AcceleratedGradient", solver); }

std::string text_of(const NoDriftCure&) { return "NoDriftCure{}"; }
std::string text_of(const Baumgarte& cure) { return fmt::format("Baumgarte{{{}}}", cure.beta); }
std::string text_of(const SplitImpulse& cure) { return fmt::format("SplitImpulse{{{}}}", cure.beta); }
std::string text_of(const Projection& cure) { return fmt::format("Projection{{{}}}", cure.sweeps); }
std::string text_of(const SoftConstraints& cure) {
  return fmt::format("SoftConstraints{{.frequency = {:.12g}}}", cure.frequency);
}

std::string text_of(const AnyStepping& method) {
  const auto solver = std::visit([](const auto&one) { return text_of(one); }, method.solver),
             cure = std::visit([](const auto&one) { return text_of(one); }, method.drift);
  return Struct("AnyStepping")
      .with("solver", solver)
      .with("drift", cure)
      .with("substeps", method.substeps, 1)
      .text();
}
std::string text_of(const Accelerations& method) {
  constexpr const char* schemes[] = {"explicit_euler", "rk4", "implicit_midpoint"};
  static_assert(Scheme::explicit_euler == Scheme{0} && Scheme::rk4 == Scheme{1} &&
                Scheme::implicit_midpoint == Scheme{2});
  return Struct("Accelerations")
      .with("scheme", fmt::format("Scheme::{}", schemes[static_cast<int>(method.scheme)]))
      .with("substeps", method.substeps, Accelerations{}.substeps)
      .text();
}
std::string text_of(const Rattle& method) {
  return Struct("Rattle").with("substeps", method.substeps, Rattle{}.substeps).text();
}
std::string text_of(const Xpbd& method) {
  return Struct("Xpbd")
      .with("substeps", method.substeps, Xpbd{}.substeps)
      .with("iterations", method.iterations, Xpbd{}.iterations)
      .text();
}
std::string text_of(const Avbd& method) {
  return Struct("Avbd")
      .with("iterations", method.iterations, Avbd{}.iterations)
      .with("alpha", method.alpha, Avbd{}.alpha)
      .text();
}

std::string text_of(const Generalised& method) {
  Struct text("Generalised");
  if (method.rule == JointRule::semi_implicit_euler) text.with("rule", "JointRule::semi_implicit_euler");
  return text.with("substeps", method.substeps, Generalised{}.substeps).text();
}

template <class Base>
std::string text_of_controlled(const char* name, const Controlled<Base>& method) {
  return Struct(name).with("tolerance", fmt::format("{}", method.tolerance)).text();
}
std::string text_of(const Controlled<Rattle>& method) { return text_of_controlled("Controlled<Rattle>", method); }
std::string text_of(const Controlled<Generalised>& method) {
  return text_of_controlled("Controlled<Generalised>", method);
}

}  // namespace

std::string code_of(const Setting& setting) {
  const std::string method = std::visit([](const auto& one) { return text_of(one); }, setting.method);
  std::string step = "simulation.step(1.0 / 60);";
  if (setting.steps > 1)
    step = fmt::format("for (int i = 0; i < {0}; ++i) simulation.step(1.0 / 60 / {0});", setting.steps);
  return fmt::format(R"(#include "lessons/methods/method.hpp"

using namespace byhand;
Simulation simulation{{scene, {}}};
{}
)",
                     method, step);
}

}  // namespace byhand
