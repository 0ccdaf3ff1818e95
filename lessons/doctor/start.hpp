#pragma once

#include <Eigen/Eigenvalues>
#include <array>

#include "lessons/doctor/motion.hpp"
#include "lessons/doctor/notes.hpp"
#include "lessons/laws/closed_forms.hpp"

// Before anything moves: overlaps, rows that repeat or contradict each other, and what the first step's sweeps
// leave.
namespace byhand::doctor {

/// What sweeps leave of the first step: a bounce, or a rest that begins at λ = 0 in every step.
template <class M>
void first_step(Notes<M>& notes) {
  if (notes.treatment.passes == 0) return;
  const Kick kick = left_by_the_first_step(notes.scene, notes.file.method, notes.file.step, notes.sizes);
  if (kick.body < 0) return;
  notes.kick = kick.speed;
  const double size = notes.sizes[static_cast<std::size_t>(kick.body)],
               way = kick.speed * (notes.treatment.warm_start ? notes.file.step : notes.file.duration);
  notes.keep({.law = 4,
              .quantity = notes.treatment.warm_start ? "way by the first step's sweeps [bodies]"
                                                     : "way by sweeps that begin at λ = 0 [bodies]",
              .number = way / (size > 0 ? size : 1),
              .limit = share_of_a_body,
              .bodies = {kick.body},
              .sentence = fmt::format(
                  "The first step's {} sweep{} it {:.3g} m/s that an exact solve does not "
                  "leave: rows are solved in turn, and what they leave is not symmetric.{}",
                  notes.treatment.passes, notes.treatment.passes == 1 ? " leaves" : "s leave", kick.speed,
                  notes.treatment.warm_start ? "" : " Without a warm start every step does so again."),
              .knobs = {exactly(), notes.more_sweeps(10)}});
  if (notes.treatment.warm_start) return;
  const Kick drift = drift_across_gravity(notes.scene, notes.file.method, notes.file.step);
  if (drift.body < 0) return;
  const double its_size = notes.sizes[static_cast<std::size_t>(drift.body)],
               number = drift.speed * notes.file.duration / (its_size > 0 ? its_size : 1);
  constexpr double limit = 0.5;  // half a body: then it is no longer in its place
  notes.keep({.law = 4,
              .grade = beyond(number, limit),
              .quantity = "drift by sweeps that begin at λ = 0 [bodies]",
              .number = number,
              .limit = limit,
              .bodies = {drift.body},
              .sentence = fmt::format("Sweeps that begin at λ = 0 leave it {:.3g} m/s to one side in every step. "
                                      "No row takes that back: over the run it moves by {:.3g} of a body.",
                                      drift.speed, number),
              .knobs = {exactly(), notes.more_sweeps(10)}});
}

/// Law 2: what begins in each other is thrown apart by the correction.
template <class M>
void overlaps(Notes<M>& notes, const System<M>& system) {
  if (!notes.treatment.adds_velocity || notes.treatment.beta <= 0 || notes.treatment.beta > 1) return;
  const double gravity = notes.scene.gravity.norm();
  if (gravity == 0) return;
  const double limit =
      laws::popping_overlap(notes.treatment.beta, notes.treatment.h, gravity) + notes.treatment.slop;
  Finding deepest{.law = 2, .quantity = "overlap [m]", .limit = limit};
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    for (int k = 0; k < run.position_rows; ++k)
      if (one_sided(system, block, k) && -system.C[block.row + k] > deepest.number) {
        deepest.number = -system.C[block.row + k];
        deepest.bodies = notes.moving(block.body1, block.body2);
      }
  });
  if (deepest.number <= notes.treatment.slop) return;
  const double speed = notes.treatment.beta * deepest.number / notes.treatment.h;
  deepest.grade = beyond(deepest.number, limit);
  deepest.shows = Shows::at_once;
  deepest.sentence = fmt::format(
      "They start {:.3g} m inside each other. The correction drives them apart at βd/h = {:.3g} m/s, and that "
      "speed stays: they part if they overlap by more than {:.3g} m.",
      deepest.number, speed, limit);
  deepest.knobs = {{"cure", 0, "cure = split_impulse"},
                   turn_to("beta", notes.treatment.beta * limit / deepest.number)};
  notes.keep(deepest);
}

/// Law 2 of cures that move poses: the bodies are moved apart at once, and what lies upon others is lifted. The
/// motion is the smallest that obeys all rows, in the metric of the masses.
template <class M>
void lifted(Notes<M>& notes, Scene<M> scene, Work<M> work) {
  if (notes.treatment.adds_velocity || notes.treatment.beta <= 0 || scene.gravity.isZero(0)) return;
  lay_out(scene, RowSolver(ByGraph{}), work);
  write_rows(scene, notes.treatment.h, work);
  System<M>& system = work.system;
  bool any = false;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    if constexpr (B == Bound::friction || B == Bound::manifold) system.upper[block.row] = 0;
    for (int k = 0; k < run.position_rows; ++k) {
      double& bias = system.bias[block.row + k];
      bias = 0;
      if (!one_sided(system, block, k)) continue;
      const double overlap = -system.C[block.row + k] - notes.treatment.slop;
      bias = -overlap;
      any = any || overlap > 0;
    }
  });
  if (!any) return;
  Bodies<M> bodies = scene.bodies();
  for (auto& v : bodies.velocity) v.setZero();
  solve_rows<M>(RowSolver(ByGraph{}), bodies, work);
  double rise = 0, weight = 0, smallest = INFINITY, highest = 0;
  Finding finding{.law = 2, .quantity = "rise by overlaps [bodies]", .limit = 0.25};
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const double up = -bodies.velocity[i].template head<M::linear>().dot(scene.gravity);  // [m · m/s²]
    rise += up / bodies.inverse_mass[i].linear;
    weight += scene.gravity.norm() / bodies.inverse_mass[i].linear;
    if (const double size = notes.sizes[static_cast<std::size_t>(i)]; size > 0)
      smallest = std::min(smallest, size);
    if (up > highest) highest = up, finding.bodies = {i};
  }
  if (!(rise > 0) || std::isinf(smallest)) return;
  finding.number = rise / weight / smallest;
  finding.grade = beyond(finding.number, finding.limit);
  finding.sentence = fmt::format(
      "Bodies start inside each other. The cure moves them apart without a velocity, but lifts what lies above: "
      "{:.3g} J from nowhere.",
      rise);
  finding.knobs = {{"bodies", 0, "bodies that do not overlap"}, turn_to("beta", 0)};
  notes.keep(finding);
}

/// Two stops of one freedom, of which no motion reaches both sides.
template <class M>
void contradicting_limits(Notes<M>& notes, const System<M>& system) {
  struct Stop {
    int body1, body2;
    double C;
    Eigen::Matrix<double, 1, 2 * M::dof> J;
  };
  std::vector<Stop> stops;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    if constexpr (B == Bound::interval)
      if (run.position_rows == 1 && system.lower[block.row] == 0)
        stops.push_back({block.body1, block.body2, system.C[block.row], block.J.matrix});
  });
  Finding worst{.law = 8, .quantity = "stops that contradict each other [m or rad]", .limit = 1e-9};
  for (std::size_t i = 0; i < stops.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Stop &one = stops[i], &other = stops[j];
      if (one.body1 != other.body1 || one.body2 != other.body2 || !(one.J + other.J).isZero(1e-9) ||
          one.J.isZero(1e-9))
        continue;
      if (const double apart = -(one.C + other.C); apart > worst.number)
        worst.number = apart, worst.bodies = notes.moving(one.body1, one.body2);
    }
  if (worst.number <= worst.limit) return;
  worst.grade = Grade::fails;
  worst.sentence =
      fmt::format("The lower stop lies {:.3g} above the upper one: no motion obeys both, and λ grows without end.",
                  worst.number);
  worst.knobs = {{"constraints", 0, "exchange at_least and at_most"}};
  notes.keep(worst);
}

/// Rows without bounds that depend on each other, by the eigenvalues of D^-½ A D^-½.
template <class M>
void repeated(Notes<M>& notes, const System<M>& system) {
  std::vector<int> rows;
  std::vector<std::array<int, 2>> bodies;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
    for (int k = 0; k < run.position_rows && B == Bound::none; ++k) {
      rows.push_back(block.row + k);
      bodies.push_back({block.body1, block.body2});
    }
  });
  const int count = static_cast<int>(rows.size());
  if (count < 2 || count > 240) return;
  Eigen::MatrixXd A(count, count);
  for (int j = 0; j < count; ++j) {
    std::vector<double> unit(system.lambda.size(), 0.0), rates(system.lambda.size());
    unit[static_cast<std::size_t>(rows[j])] = 1;
    std::vector<Velocity<M>> V(static_cast<std::size_t>(notes.scene.bodies().size()), Velocity<M>::Zero());
    apply_all(system, unit, V);
    rates_of(system, V, rates);
    for (int i = 0; i < count; ++i) A(i, j) = rates[static_cast<std::size_t>(rows[i])];
  }
  const Eigen::VectorXd scale = A.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * A * scale.asDiagonal());
  int repeats = 0;
  double gap = 0;
  Finding finding{.law = 8, .quantity = "rows that repeat others", .limit = 1};
  for (int m = 0; m < count && modes.eigenvalues()[m] < 1e-9; ++m) {
    ++repeats;
    const Eigen::VectorXd y = (scale.asDiagonal() * modes.eigenvectors().col(m)).normalized();
    double conflict = 0;
    int place = 0;
    for (int i = 0; i < count; ++i) conflict += y[i] * system.C[static_cast<std::size_t>(rows[i])];
    y.cwiseAbs().maxCoeff(&place);
    const auto& pair = bodies[static_cast<std::size_t>(place)];
    if (std::abs(conflict) / notes.size_of_pair(pair[0], pair[1]) >= gap) {
      gap = std::abs(conflict) / notes.size_of_pair(pair[0], pair[1]);
      finding.bodies = notes.moving(pair[0], pair[1]);
    }
  }
  if (repeats == 0) return;
  const bool has_no_answer = !notes.treatment.regularised, contradicts = gap > share_of_a_body;
  finding.number = repeats;
  finding.grade = has_no_answer || contradicts ? Grade::fails : Grade::fine;
  finding.limit = finding.grade == Grade::fails ? 1 : 10.0 * repeats;
  finding.sentence =
      contradicts
          ? fmt::format(
                "{} of {} rows repeat what others say, and contradict them by {:.2g} of a body: no motion obeys "
                "all, and λ grows without end.",
                repeats, count, gap)
          : fmt::format("{} of {} rows repeat what others say: only the sum of their λ is known.", repeats, count);
  finding.knobs = {contradicts ? Knob{"constraints", 0, "take out or lengthen the rod that contradicts"}
                               : turn_to("regularisation", 1e-7),
                   exactly()};
  notes.keep(finding);
}

}  // namespace byhand::doctor
