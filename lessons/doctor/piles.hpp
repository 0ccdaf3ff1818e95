#pragma once

#include <fmt/format.h>

#include <numbers>

#include "lessons/doctor/notes.hpp"
#include "lessons/doctor/rows.hpp"
#include "lessons/doctor/slow_mode.hpp"
#include "lessons/laws/buckling.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/numbers.hpp"

// What lies upon each other: heavy on light, height, columns that tip over.
namespace byhand::doctor {

/// Law 9: the heaviest body above a lighter one, along the paths of pushes. A warm start settles up to about
/// three times the sweeps, at β = 0.2.
template <class M>
void mass_ratios(Notes<M>& notes, const std::vector<std::vector<int>>& above, const Bodies<M>& bodies) {
  Finding worst{.law = 9, .quantity = "mass ratio along a path of pushes", .limit = 3.0 * notes.treatment.passes};
  for (int low = 0; low < bodies.size(); ++low) {
    if (!moves(bodies.inverse_mass[low])) continue;
    std::vector<int> path{low};
    std::vector<char> seen(above.size(), 0);
    for (std::size_t i = 0; i < path.size(); ++i)
      for (const int high : above[static_cast<std::size_t>(path[i])]) {
        if (std::exchange(seen[static_cast<std::size_t>(high)], 1)) continue;
        path.push_back(high);
        const double ratio = bodies.inverse_mass[low].linear / bodies.inverse_mass[high].linear;
        if (ratio > worst.number) worst.number = ratio, worst.bodies = {low, high};
      }
  }
  if (worst.number < 2) return;
  worst.grade = beyond(worst.excess(), 1.5);  // the limit holds within a factor: it depends on β and the load
  worst.shows = Shows::in_time;
  worst.sentence = fmt::format(
      "The upper body is {:.3g} times as heavy as one that carries it; at β = 0.2, {} warm sweeps settle up to "
      "about {:.3g}.",
      worst.number, notes.treatment.passes, worst.limit);
  worst.knobs = {exactly(), notes.more_sweeps(worst.excess())};
  notes.keep(worst);
}

/// Law 4 from λ = 0: a sweep passes a weight down by one contact, so that the foot of a pile as high as this
/// needs as many sweeps in every step.
template <class M>
void cold_height(Notes<M>& notes, const std::vector<std::vector<int>>& above, const Bodies<M>& bodies) {
  std::vector<int> level(above.size(), 0);
  int highest = 0, top = 0;
  for (std::size_t round = 0; round < above.size(); ++round) {
    bool changed = false;
    for (std::size_t low = 0; low < above.size(); ++low)
      for (const int high : above[low])
        if (auto& of_high = level[static_cast<std::size_t>(high)]; of_high <= level[low] && level[low] < 1000) {
          of_high = level[low] + 1;
          changed = true;
          if (of_high > highest) highest = of_high, top = high;
        }
    if (!changed) break;
  }
  const double number = static_cast<double>(highest) / notes.treatment.passes, limit = 2.5;
  if (highest < 2 || !moves(bodies.inverse_mass[top])) return;
  notes.keep({.law = 4,
              .grade = beyond(number, limit),
              .quantity = "contacts below the top by cold sweeps",
              .number = number,
              .limit = limit,
              .bodies = {top},
              .sentence = fmt::format("{} contacts lie between the ground and the top of the pile, but in {} "
                                      "sweep{} from λ = 0 its "
                                      "weight is passed down by only as many.",
                                      highest, notes.treatment.passes, notes.treatment.passes == 1 ? "" : "s"),
              .knobs = {exactly(), notes.more_sweeps(static_cast<double>(highest) / notes.treatment.passes)}});
}

/// Law 17: a column on soft contacts buckles, whatever its sweeps and substeps.
template <class M>
void buckling(Notes<M>& notes, const std::vector<int>& column, double height, double gravity) {
  const double frequency = notes.treatment.frequency;
  if (frequency == 0) return;
  const double softest = 2 * std::numbers::pi * std::sqrt(gravity / laws::g) *
                         laws::softest_contacts(static_cast<int>(column.size()), {height, height}),
               number = softest / frequency;
  notes.keep({.law = 17,
              .grade = beyond(number, 1),
              .quantity = "softest contacts over these",
              .number = number,
              .limit = 1,
              .bodies = column,
              .sentence = fmt::format(
                  "A column of {} buckles on contacts softer than ω = {:.3g} /s, and these have {:.3g} "
                  "/s. Sweeps and substeps do not move that limit.",
                  column.size(), softest, frequency),
              .knobs = {turn_to("frequency", 1.3 * softest), {"cure", 0, "cure = split_impulse"}}});
}

/// Law 18: bodies that stand one upon the other, each on one and under one.
template <class M>
void columns(Notes<M>& notes, const Moment<M>& moment, double pressed) {
  if constexpr (M::angular > 0) {
    const Bodies<M>& bodies = moment.scene.bodies();
    const Linear<M> up = -moment.scene.gravity.normalized();
    if (moment.scene.gravity.isZero(0)) return;
    const auto count = static_cast<std::size_t>(bodies.size());
    std::vector<std::vector<int>> above(count), below(count);
    for (const ContactPair<M>& pair : moment.work.contacts.pairs()) {
      if (!pair.presses()) continue;
      const double lift = pair.normal.dot(up);
      if (std::abs(lift) < 0.9) continue;
      const int low = lift > 0 ? pair.bodies.first : pair.bodies.second,
                high = lift > 0 ? pair.bodies.second : pair.bodies.first;
      above[static_cast<std::size_t>(low)].push_back(high);
      below[static_cast<std::size_t>(high)].push_back(low);
    }
    if (!notes.treatment.warm_start) cold_height(notes, above, bodies);
    mass_ratios(notes, above, bodies);
    for (int first = 0; first < bodies.size(); ++first) {
      const auto at = static_cast<std::size_t>(first);
      if (!moves(bodies.inverse_mass[first]) || below[at].size() != 1 || moves(bodies.inverse_mass[below[at][0]]))
        continue;
      std::vector<int> column{first};
      while (above[static_cast<std::size_t>(column.back())].size() == 1 && column.size() <= count) {
        const int next = above[static_cast<std::size_t>(column.back())][0];
        if (below[static_cast<std::size_t>(next)].size() != 1) break;  // it leans on another, too
        column.push_back(next);
      }
      if (column.size() < 3 || !above[static_cast<std::size_t>(column.back())].empty()) continue;
      const double height = (bodies.pose[column.back()].position - bodies.pose[first].position).dot(up) /
                            static_cast<double>(column.size() - 1);
      const double tipping2 = laws::tipping_rate_squared(static_cast<int>(column.size()),
                                                         moment.scene.gravity.norm(), {height, height});
      buckling(notes, column, height, moment.scene.gravity.norm());
      // Bending fades so slowly that a power iteration from a load does not see it.
      const double rho =
          std::max(pressed, laws::bending_left_by_a_sweep(static_cast<int>(column.size()), {height, height}));
      const double q = std::pow(rho, notes.treatment.passes), h = notes.treatment.h;
      const double number = tipping2 * h * h * q / std::max(1 - q, 1e-12);
      const SlowMode lean{
          .left = q, .tipping = std::sqrt(tipping2), .step = h, .warm_start = notes.treatment.warm_start};
      const double growth = lean.growth();
      double push = std::max(1e-9, notes.kick * h);  // the sweeps' own, too: they are not symmetric
      for (const int body : column)
        push = std::max(push, bodies.velocity[body].template head<M::linear>().norm() * h);
      const double falls = growth > 1 + 1e-9 ? std::log(0.5 * height / push) / std::log(growth) * h : INFINITY;
      notes.keep(
          {.law = 18,
           .grade = falls < notes.file.duration ? Grade::fails : Grade::fine,
           .quantity = "(σh)² q/(1 − q)",
           .number = number,
           .limit = 1,
           .bodies = column,
           .sentence = fmt::format(
               "A column of {} tips over by itself at σ = {:.3g} /s, and {} sweep{} q = {:.4g} of its "
               "bending. {}",
               column.size(), std::sqrt(tipping2), notes.treatment.passes,
               notes.treatment.passes == 1 ? " leaves" : "s leave", q,
               std::isfinite(falls)
                   ? fmt::format("A push grows by {:.4g} a substep: it falls about {:.2g} s later.", growth, falls)
                   : "A push dies out."),
           .knobs = {exactly(),
                     notes.more_sweeps(1.5 * laws::sweeps_to_stand(tipping2, rho, h) / notes.treatment.passes),
                     notes.more_substeps(1.3 * std::sqrt(number))}});
    }
  }
}

}  // namespace byhand::doctor
