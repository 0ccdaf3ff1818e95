#pragma once

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "lessons/doctor/notes.hpp"
#include "lessons/doctor/rows.hpp"

// Steps of the file's own method, a few from moments of the exact motion: what a step does at once, such as at an
// impact, no law of a slow mode foresees. And what laws foresee is tried before it is said.
namespace byhand::doctor {

struct Trial {
  Opening worst;
  double when = 0;    // since it began [s]
  double gained = 0;  // energy, by that which lifts all bodies by the smallest one; 0 of a scene that is driven
};

/// What `steps` steps of `step` [s] do to a simulation. It ends where it fails, and goes on for as long again
/// where it grows.
template <class M>
Trial tried(Simulation<M>& own, double step, int steps, Watch<M> watch) {
  watch.restart();
  Trial trial;
  const double unit = is_driven(own.scene) ? 0 : energy_of_a_lift(own.scene), begun = energy(own.scene);
  double early = 0;  // the worst at half of the steps
  const int planned = steps;
  for (int i = 1; i <= steps; ++i) {
    try {
      own.step(step);
    } catch (const std::runtime_error&) {
      trial.worst.share = INFINITY, trial.when = i * step;
      break;
    }
    const bool failed = watch.look(own.scene);
    if (watch.worst().share > trial.worst.share) trial.worst = watch.worst(), trial.when = i * step;
    if (unit > 0) trial.gained = larger(trial.gained, (energy(own.scene) - begun) / unit);
    if (failed) break;
    if (2 * i == planned) early = trial.worst.share;
    const bool grows = trial.worst.share > 2 * early && trial.worst.share > 0.3 * share_of_a_body;
    if (i == planned && grows) steps = 2 * planned;
  }
  return trial;
}

/// The trials of an examination.
template <class M>
class Trials {
 public:
  static constexpr int steps = 20;  // of the file

  explicit Trials(const Notes<M>& notes)
      : notes_(notes),
        watch_(notes.scene, notes.treatment.slop, notes.file.step),
        every_(notes.is_large() ? steps : steps / 2),
        half_(half_of(notes.file)) {}

  /// From the beginning of the scene.
  void begin() {
    const auto from = [&](const VelocityStepping& method) { return Simulation<M>{notes_.scene, method}; };
    try_from(from, 0);
  }
  /// Whether a trial begins after `frame` steps of the file.
  bool due(long frame) const { return frame % every_ == 0 || frame == half_; }
  /// From where the exact motion is then, with the λ that hold it there.
  void at(const Moment<M>& moment, long frame) {
    if (frame == half_) exact_at_half_ = moment.scene.bodies().pose;
    const auto from = [&](const VelocityStepping& method) {
      Moment<M> laid = laid_out_for(moment, method.solver, notes_.treatment.h);
      return Simulation<M>{std::move(laid.scene), method, std::move(laid.work)};
    };
    try_from(from, moment.time);
  }
  /// The exact motion rests from here on.
  void rest(const Scene<M>& scene) {
    if (exact_at_half_.empty()) exact_at_half_ = scene.bodies().pose;
  }

  /// Whether the file's own steps do not do what a law foresees: at once in any trial, or in time by half of the
  /// run.
  bool refute(const Finding& finding) {
    if (finding.shows == Shows::at_once)
      return worst_.worst.share <= 0.7 * share_of_a_body && worst_.gained <= 0.25;
    if (finding.shows != Shows::in_time || finding.by_half < 0.3 * share_of_a_body) return false;
    if (!by_half_) try_half();
    return by_half_->worst.share < 0.7 * std::min(finding.by_half, share_of_a_body) && by_half_->gained < 0.2 &&
           left_by_half_ < share_of_a_body;
  }
  /// What an at-once or an in-time trial has shown, in words.
  std::string shown(const Finding& finding) const {
    const bool at_once = finding.shows == Shows::at_once;
    return fmt::format(" Tried, it does not: {} steps of this method open by at most {:.2g} of a body.",
                       at_once ? steps : half_, at_once ? worst_.worst.share : by_half_->worst.share);
  }

  /// The worst of the trials.
  Finding finding(double transverse) const {
    const Opening& worst = worst_.worst;
    const bool by_exact_steps = with_exact_solves_ > share_of_a_body, soft = notes_.treatment.frequency > 0;
    const int law = !by_exact_steps ? 4 : transverse > 1.4 ? 7 : soft && worst.joint ? 11 : 13;
    return {.law = law,
            .grade = beyond(worst.share, share_of_a_body),
            .quantity = "opening in a trial [bodies]",
            .number = std::min(worst.share, 1e3),
            .limit = share_of_a_body,
            .bodies = notes_.moving(worst.bodies.first, worst.bodies.second),
            .sentence = fmt::format(
                "From the exact motion at {:.2f} s, {} steps of this method {} by {:.3g} of a body{}.", from_,
                steps, worst.joint ? "open a joint" : "let bodies into each other", std::min(worst.share, 1e3),
                worst.share <= share_of_a_body ? ""
                : by_exact_steps
                    ? fmt::format(", and with exact solves by {:.3g}: the step is too long for what happens in it",
                                  std::min(with_exact_solves_, 1e3))
                    : fmt::format(", and with exact solves by {:.3g}: the sweeps are too few for it",
                                  with_exact_solves_)),
            .knobs = {by_exact_steps ? notes_.more_substeps(4) : exactly(),
                      by_exact_steps ? exactly() : notes_.more_sweeps(10)}};
  }
  double time() const { return from_ + worst_.when; }

 private:
  static long half_of(const SceneFile& file) { return std::lround(0.5 * file.duration / file.step); }

  template <class From>
  void try_from(From&& from, double time) {
    const VelocityStepping& method = notes_.file.method;
    Simulation<M> own = from(method);
    const Trial trial = tried(own, notes_.file.step, steps, watch_);
    const double gained = std::max(worst_.gained, trial.gained);
    if (!(trial.worst.share <= worst_.worst.share)) {
      if (trial.worst.share > share_of_a_body && worst_.worst.share <= share_of_a_body) {
        VelocityStepping exact = method;
        exact.solver = ByGraph{};
        Simulation<M> exactly_solved = from(exact);
        with_exact_solves_ = tried(exactly_solved, notes_.file.step, steps, watch_).worst.share;
      }
      worst_ = trial, from_ = time;
    }
    worst_.gained = gained;
  }

  void try_half() {
    Simulation<M> own{notes_.scene, notes_.file.method};
    by_half_ = tried(own, notes_.file.step, static_cast<int>(half_), watch_);
    // Bodies that the exact motion leaves where they are should be left there.
    const double smallest = smallest_of(notes_.sizes);
    double moved = 0, apart = 0;
    for (std::size_t i = 0; i < exact_at_half_.size(); ++i) {
      const int body = static_cast<int>(i);
      moved = std::max(moved, (exact_at_half_[body].position - notes_.scene.bodies().pose[body].position).norm());
      apart = std::max(apart, (exact_at_half_[body].position - own.scene.bodies().pose[body].position).norm());
    }
    left_by_half_ = moved < 0.25 * smallest ? apart / smallest : 0;
  }

  const Notes<M>& notes_;
  Watch<M> watch_;
  int every_;  // steps between trials: in large scenes they do not overlap
  long half_;  // of the run [steps]
  Trial worst_;
  double from_ = 0, with_exact_solves_ = 0;  // where the worst began [s], and its opening with exact solves
  std::optional<Trial> by_half_;
  double left_by_half_ = 0;  // how far a body that should rest has gone by then [bodies]
  decltype(Bodies<M>::pose) exact_at_half_;
};

}  // namespace byhand::doctor
