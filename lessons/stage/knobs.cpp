#include "lessons/stage/knobs.hpp"

#include <fmt/format.h>

namespace byhand::stage {
namespace {

const std::vector<std::string> solvers(row_solver_names.begin(), row_solver_names.end()),
    others{"rattle", "midpoint", "rk4", "xpbd", "avbd"}, cures(drift_cure_names.begin(), drift_cure_names.end());

std::vector<std::string> all_methods() {
  std::vector<std::string> all = solvers;
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

int sweeps_of(const RowSolver& solver) {
  return std::visit(
      [](const auto& s) {
        if constexpr (requires { s.sweeps; })
          return s.sweeps;
        else
          return 10;
      },
      solver);
}
double beta_of(const DriftCure& cure) {
  return std::visit(
      [](const auto& c) {
        if constexpr (requires { c.beta; })
          return c.beta;
        else
          return 0.2;
      },
      cure);
}
bool has_beta(const DriftCure& cure) {
  return std::visit(
      [](const auto& c) {
        return requires { c.beta; };
      },
      cure);
}
double slop_of(const DriftCure& cure) {
  return std::visit(
      [](const auto& c) {
        if constexpr (requires { c.slop; })
          return c.slop;
        else
          return 0.0;
      },
      cure);
}
double frequency_of(const DriftCure& cure) {
  const auto* soft = std::get_if<SoftConstraints>(&cure);
  return soft ? soft->frequency : SoftConstraints().frequency;
}

/// Makes the variant's alternative of this index, unless it is the present one.
template <class... Choices>
void choose(std::variant<Choices...>& variant, std::size_t index) {
  if (variant.index() == index) return;
  std::size_t i = 0;
  ((index == i++ ? void(variant.template emplace<Choices>()) : void()), ...);
}
std::size_t place(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

Knobs::Knobs(course::Lesson& lesson, SceneFile file)
    : file_(std::move(file)),
      solver_(lesson.parameter("solver", solvers[file_.method.solver.index()], all_methods(),
                               "how the rows are solved")),
      cure_(lesson.parameter("cure", cures[file_.method.drift.index()], cures, "of drift")),
      sweeps_(lesson.parameter("sweeps", sweeps_of(file_.method.solver), "1", {1, 1e6},
                               "over all rows, in a substep")),
      substeps_(lesson.parameter("substeps", file_.method.substeps, "1", {1, 1e4}, "equal parts of a step")),
      beta_(lesson.parameter("beta", beta_of(file_.method.drift), "1", {0, 3},
                             "share of an error that a step corrects")),
      slop_(lesson.parameter("slop", slop_of(file_.method.drift), "m", {0, 1e3}, "overlap that is not corrected")),
      frequency_(lesson.parameter("frequency", frequency_of(file_.method.drift), "rad/s", {1e-6, 1e9},
                                  "ω of soft constraints")),
      h_(lesson.parameter("h", file_.step, "s", {1e-6, 1}, "time step")),
      seconds_(lesson.parameter("seconds", file_.duration, "s", {1e-6, 3600}, "how long the scene is watched")) {}

SceneFile Knobs::file() const {
  SceneFile now = file_;
  const std::size_t solver = place(solvers, solver_());
  if (solver < solvers.size()) choose(now.method.solver, solver);
  choose(now.method.drift, place(cures, cure_()));
  std::visit(
      [&](auto& s) {
        if constexpr (requires { s.sweeps; }) s.sweeps = sweeps_();
      },
      now.method.solver);
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.beta; }) c.beta = beta_();
        if constexpr (requires { c.slop; }) c.slop = slop_();
        if constexpr (requires { c.frequency; }) c.frequency = frequency_();
      },
      now.method.drift);
  now.method.substeps = substeps_();
  now.step = h_();
  now.duration = seconds_();
  if (now.duration / now.step > 1e6)
    throw std::invalid_argument(
        fmt::format("seconds/h asks for {:.3g} steps, but at most 1000000 are allowed", now.duration / now.step));
  return now;
}

Method Knobs::method() const {
  const std::string solver = solver_();
  const int substeps = substeps_();
  if (solver == "rattle") return Rattle{.substeps = substeps};
  if (solver == "midpoint") return Accelerations{.scheme = Scheme::implicit_midpoint, .substeps = substeps};
  if (solver == "rk4") return Accelerations{.scheme = Scheme::rk4, .substeps = substeps};
  if (solver == "xpbd") return Xpbd{.substeps = substeps, .iterations = sweeps_()};
  if (solver == "avbd") return Avbd{.iterations = sweeps_()};
  return any_stepping(file().method);
}

std::string Knobs::described() const {
  const std::string solver = solver_();
  const bool of_rows = place(solvers, solver) < solvers.size();
  std::string words = solver;
  if (solver == "gauss_seidel" || solver == "jacobi" || solver == "conjugate_sweeps" || solver == "xpbd" ||
      solver == "avbd")
    words += fmt::format(", {} sweep{}", sweeps_(), sweeps_() == 1 ? "" : "s");
  if (of_rows) words += ", cure of drift: " + cure_();
  if (of_rows && has_beta(file().method.drift)) words += fmt::format(" with β = {:.3g}", beta_());
  return words +
         fmt::format(", {} substep{} of h = {} s", substeps_(), substeps_() == 1 ? "" : "s", course::typed(h_()));
}

}  // namespace byhand::stage
