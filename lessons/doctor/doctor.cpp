#include "lessons/doctor/doctor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "lessons/doctor/motion.hpp"
#include "lessons/doctor/notes.hpp"
#include "lessons/doctor/piles.hpp"
#include "lessons/doctor/rows.hpp"
#include "lessons/doctor/slow_mode.hpp"
#include "lessons/doctor/start.hpp"
#include "lessons/doctor/trial.hpp"

// The scene is first moved by a method that solves each step exactly, with short steps. At moments of that motion
// the laws ask the rows what the file's own method and step would make of them, and trials take a few of its
// steps.
namespace byhand::doctor {
namespace {

constexpr double pilot_beta = 0.2;

template <class M>
class Examination {
 public:
  /// Its pilot takes `parts` steps in one of the file. Its joints give way by the share `give` of a body where
  /// law 7 ends.
  Examination(const SceneFile& file, const Scene<M>& scene, double give, int parts)
      : file_(file),
        notes_{file, scene},
        trials_(notes_),
        pilot_{scene, {ByGraph{}, Baumgarte{.beta = pilot_beta, .slop = 0.001}}},
        parts_(parts) {
    auto& solver = std::get<ByGraph>(pilot_.method.solver);
    solver.loops.tolerance = 1e-5;  // of the draws to which the verdicts are fitted
    if (notes_.is_large()) solver.stalled.tolerance = 1e-6;
    give_way(give);
  }

  /// Empty as soon as the rows swing faster than `most_transverse` [1/s].
  Diagnosis findings(double most_transverse) {
    at_the_start();
    trials_.begin();
    const long steps = std::max(1L, std::lround(file_.duration / file_.step));
    const long every = every_ = std::max(1L, steps / 24);
    bool moving = true;
    for (long i = 1; i <= steps && moving; ++i) {
      double impulse = 0;  // |λ| of all rows, over the step
      try {
        for (int part = 0; part < parts_; ++part) {
          pilot_.step(file_.step / parts_);
          double sum = 0;
          for (const double lambda : pilot_.work.system.lambda) sum += lambda * lambda;
          impulse += std::sqrt(sum);
        }
      } catch (const std::runtime_error&) {
        moving = false;
      }
      if (!moving) break;
      notes_.time = pilot_.time;
      loads_.push_back(impulse / file_.step);
      note_pressing();
      if (!pilot_.work.system.lambda.empty()) follow_bends();
      if (i % every == 0 || i == 3) at_a_moment();
      if (transverse_ > most_transverse) return {};
      if (trials_.due(i)) trials_.at(now(), i);
      if (notes_.is_large() && rests()) {
        trials_.rest(pilot_.scene);
        break;
      }
    }
    if (!lags_.empty()) lag();
    try_findings();
    Diagnosis diagnosis;
    for (auto& [key, finding] : notes_.worst) diagnosis.findings.push_back(std::move(finding));
    std::stable_sort(diagnosis.findings.begin(), diagnosis.findings.end(), [](const Finding& a, const Finding& b) {
      if (a.grade != b.grade) return a.grade > b.grade;
      return a.grade == Grade::fails && a.time != b.time ? a.time < b.time : a.excess() > b.excess();
    });
    return diagnosis;
  }

  /// The largest transverse ω [1/s] that it has met.
  double transverse() const { return transverse_; }

 private:
  /// The slowest mode of the sweeps at one moment.
  struct Lag {
    double time = 0, left = 0, left_by_a_sweep = 0;  // [s]; q of a substep, ρ of a sweep
    double load_share = 0;  // the rate that the load gives the worst row in a substep, by |λ|/h of all rows
    double size = 1;        // of its bodies [m]
    bool joint = true;
    std::pair<int, int> pair = {};  // of bodies, the smaller number first
    std::vector<int> bodies = {};
  };

  // Before anything moves: β, overlaps, rows that repeat or contradict each other.
  void at_the_start() {
    if (notes_.treatment.adds_velocity && notes_.treatment.beta > 0) {
      const double limit = 2;
      notes_.keep({.law = 1,
                   .grade = beyond(notes_.treatment.beta, limit),
                   .quantity = "β",
                   .number = notes_.treatment.beta,
                   .limit = limit,
                   .sentence = fmt::format("A step corrects β = {:.3g} of an error. Above 2 the error grows, by a "
                                           "factor of |1 − β| = {:.3g} in each step.",
                                           notes_.treatment.beta, std::abs(1 - notes_.treatment.beta)),
                   .knobs = {turn_to("beta", 0.2)}});
    }
    Scene<M> scene = pilot_.scene;
    Work<M> work;
    work.contacts.find(scene, notes_.treatment.h);
    lay_out(scene, RowSolver(GaussSeidel{}), work);
    write_rows(scene, notes_.treatment.h, work);
    overlaps(notes_, work.system);
    lifted(notes_, scene, work);
    first_step(notes_);
    repeated(notes_, work.system);
    contradicting_limits(notes_, work.system);
  }

  /// A straight bridge between two walls would pull without end. No step bears that, nor has to: a give that
  /// nobody sees lets it sag, and leaves the forces that carry loads. So joints give way by this share of a body
  /// of mass m and length l under ml/h², which is law 7's limit: by γ that β balances, γF(step/parts)²/β.
  void give_way(double give) {
    const double both = give * pilot_beta * std::pow(static_cast<double>(parts_) / file_.method.substeps, 2);
    const auto soften = [&](auto& one) {
      const Bodies<M>& bodies = pilot_.scene.bodies();
      if (one.softness == 0)
        one.softness =
            both / 2 * (bodies.inverse_mass[one.at.body1].linear + bodies.inverse_mass[one.at.body2].linear);
    };
    pilot_.scene.template change_all<Pin>(soften);
    pilot_.scene.template change_all<NormalisedDistance>(soften);
    if constexpr (M::angular > 0) pilot_.scene.template change_all<Weld>(soften);
    if constexpr (M::angular == 3) pilot_.scene.template change_all<Hinge>(soften);
  }

  /// Whether nothing has gone anywhere for half a second: no body as fast as a hundredth of its size in a second.
  bool rests() {
    const Bodies<M>& bodies = pilot_.scene.bodies();
    bool moving = is_driven(pilot_.scene);
    for (int i = 0; i < bodies.size() && !moving; ++i)
      moving = moves(bodies.inverse_mass[i]) && !(bodies.velocity[i].template head<M::linear>().norm() <=
                                                  0.01 * notes_.sizes[static_cast<std::size_t>(i)]);
    if (moving) moved_at_ = pilot_.time;
    return pilot_.time - moved_at_ > 0.5;
  }

  /// The pilot's moment with the file's own rows, which do not give way.
  Moment<M> now() const {
    Moment<M> moment{notes_.scene, pilot_.work, file_.step / parts_, pilot_.time};
    moment.scene.state() = pilot_.scene.bodies();
    moment.scene.write_rows(moment.work.system, moment.h, moment.work.contacts.constraints());
    return moment;
  }

  void at_a_moment() {
    const Moment<M> moment = now();
    turns(moment);
    speeds(moment);
    if (moment.work.system.rows() == 0) return;
    transverse(moment);
    cones(moment);
    softness(moment);
    if (notes_.treatment.stale) turning(moment);
    if (notes_.treatment.passes > 0) sweeps(moment);
  }

  /// Hooke's law of soft rows, C = T·JM⁻¹Jᵀ/ω² by their frequency or γFh²/β by their softness, and the creep γ·W·h
  /// of a soft friction row that sticks.
  void softness(const Moment<M>& moment) {
    const System<M>& system = moment.work.system;
    Finding gap{.law = 11, .quantity = "gap of a soft joint [bodies]", .limit = share_of_a_body},
        creep{.law = 10, .quantity = "creep of soft friction [bodies]", .limit = share_of_a_body};
    Finding sag{.law = 11, .quantity = "give of a soft row [bodies]", .limit = share_of_a_body};
    double pull = 0, speed = 0, weight = 0;
    const double beta = notes_.treatment.beta, h = notes_.treatment.h;
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      const double size = notes_.size_of_pair(block.body1, block.body2);
      if (beta > 0)
        for (int k = 0; k < run.position_rows; ++k) {
          const double force = std::abs(system.lambda[block.row + k]) / moment.h,
                       give = force * system.gamma[block.row + k] * h * h / beta;
          if (give / size > sag.number)
            sag.number = give / size, sag.bodies = notes_.moving(block.body1, block.body2), weight = force;
        }
      if constexpr (B == Bound::none) {
        for (int k = 0; k < run.position_rows && notes_.treatment.frequency > 0; ++k) {
          const double force = std::abs(system.lambda[block.row + k]) / moment.h,
                       give = force * inverse_effective_mass(block.J, block.W, k) /
                              std::pow(notes_.treatment.frequency, 2);
          if (give / size > gap.number)
            gap.number = give / size, gap.bodies = notes_.moving(block.body1, block.body2), pull = force;
        }
      } else if constexpr (B == Bound::friction) {
        double slip = 0;
        for (int k = 0; k < K; ++k)
          slip += std::pow(system.gamma[block.row + k] * system.lambda[block.row + k], 2);
        const double now = std::sqrt(slip) * file_.step / moment.h, way = now * file_.duration / size;
        if (way > creep.number)
          creep.number = way, creep.bodies = notes_.moving(block.body1, block.body2), speed = now;
      }
    });
    if (gap.number > 0) {
      gap.grade = beyond(gap.number, gap.limit);
      gap.shows = Shows::at_once;
      gap.sentence = fmt::format(
          "A soft row of ω = {:.3g} /s gives way by T·JM⁻¹Jᵀ/ω²: under {:.3g} N by {:.3g} of a body, however many "
          "substeps there are.",
          notes_.treatment.frequency, pull, gap.number);
      gap.knobs = {turn_to("frequency", notes_.treatment.frequency * std::sqrt(std::max(2.0, 2 * gap.excess()))),
                   exactly()};
      notes_.keep(gap);
    }
    if (sag.number > 0) {
      sag.grade = beyond(sag.number, sag.limit);
      sag.shows = Shows::at_once;
      sag.sentence = fmt::format(
          "A row with a softness γ is a spring: under {:.3g} N it gives way by γFh²/β, {:.3g} of a body, however "
          "many sweeps there are.",
          weight, sag.number);
      sag.knobs = {{"constraints", 0, "softness = 0 of the row"}};
      notes_.keep(sag);
    }
    if (creep.number > 0) {
      creep.sentence = fmt::format(
          "A friction row with a softness γ creeps at γ·W·h = {:.3g} m/s while it sticks, whatever μ is.", speed);
      creep.knobs = {{"constraints", 0, "softness = 0 of the friction"}};
      notes_.keep(creep);
    }
  }

  /// Laws 3 and 14: the velocities end along the rows as they were when the step began.
  void turning(const Moment<M>& moment) {
    const double power = power_of_turning_rows(moment, bends(pilot_.scene, pilot_.work), notes_.treatment.h);
    taken_ += power * file_.step * static_cast<double>(every_);
    most_motion_ = std::max(most_motion_, kinetic_energy(moment.scene.bodies()));
    if (!(most_motion_ > 0) || taken_ == 0) return;
    const double share = taken_ / most_motion_;
    notes_.keep(
        {.law = notes_.treatment.frequency > 0 ? 14 : 3,
         .quantity = "energy that turning rows take, by that of the motion",
         .number = share,
         .limit = 0.2,
         .bodies = hardest_,
         .sentence = fmt::format(
             "A step makes the velocities fit the rows as they were before the bodies moved. The next step takes "
             "away what does not fit the turned rows: over the run, {:.3g} of the motion's energy.",
             1 - std::exp(-share)),
         .knobs = {notes_.more_substeps(share / 0.02)}});
  }

  void try_findings() {
    for (auto& [key, finding] : notes_.worst)
      if (finding.grade == Grade::fails && trials_.refute(finding)) {
        finding.grade = Grade::near_the_limit;
        finding.sentence += trials_.shown(finding);
      }
    notes_.time = trials_.time();
    notes_.keep(trials_.finding(transverse_ * notes_.treatment.h));
  }

  void transverse(const Moment<M>& moment) {
    const double frequency = largest_transverse_frequency(moment);
    if (frequency == 0) return;
    transverse_ = std::max(transverse_, frequency);
    const double number = frequency * notes_.treatment.h, limit = 2;
    const double hardest = strongest(moment);
    notes_.keep({.law = 7,
                 .grade = beyond(number, limit),
                 .quantity = "ω·h",
                 .number = number,
                 .limit = limit,
                 .bodies = hardest_,
                 .sentence = fmt::format(
                     "At {:.2f} s a joint pulls with {:.3g} N, so light bodies swing across it at ω = {:.3g} /s. "
                     "ω·h = {:.3g}, and with a J held over a step 2 is the limit. More sweeps cannot help.",
                     pilot_.time, hardest, frequency, number),
                 .knobs = {notes_.more_substeps(1.25 * number / limit)}});
  }
  /// The largest force of a row without bounds [N], and its bodies.
  double strongest(const Moment<M>& moment) {
    double largest = 0;
    for_each_block(moment.work.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
      if (B != Bound::none) return;
      double sum = 0;
      for (int k = 0; k < K; ++k) sum += std::pow(moment.work.system.lambda[block.row + k] / moment.h, 2);
      if (std::sqrt(sum) > largest) {
        largest = std::sqrt(sum);
        hardest_ = notes_.moving(block.body1, block.body2);
      }
    });
    return largest;
  }

  /// Law 13: each substep adds ½h²|J̇V| to a joint's gap, and β takes back a share.
  void follow_bends() {
    const System<M>& system = pilot_.work.system;
    const std::vector<double> bend = bends(pilot_.scene, pilot_.work);
    if (openings_.size() != bend.size()) openings_.assign(bend.size(), 0.0);
    const int count = file_.method.substeps;
    const double kept = std::pow(1 - std::min(1.0, notes_.treatment.beta), count);
    Finding worst{.law = 13, .quantity = "gap of a turning joint [bodies]", .limit = share_of_a_body};
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      if (B != Bound::none) return;
      double sum = 0;
      for (int k = 0; k < std::min(run.position_rows, M::linear); ++k)
        sum += std::pow(bend[static_cast<std::size_t>(block.row + k)], 2);
      const double step = 0.5 * notes_.treatment.h * notes_.treatment.h * std::sqrt(sum);
      double& opening = openings_[static_cast<std::size_t>(block.row)];
      // The sum of a geometric series: what each of the substeps leaves of the step before.
      const double added =
          notes_.treatment.beta > 0 ? step * (1 - kept) / std::min(1.0, notes_.treatment.beta) : step * count;
      opening = opening * kept + added;
      const double number = opening / notes_.size_of_pair(block.body1, block.body2);
      if (number > worst.number) worst.number = number, worst.bodies = notes_.moving(block.body1, block.body2);
    });
    if (worst.number == 0) return;
    worst.grade = beyond(worst.number, worst.limit);
    worst.shows = Shows::at_once;
    worst.sentence = fmt::format(
        "At {:.2f} s the path of a joint bends so fast that the joint is open by {:.3g} of a body: a substep adds "
        "½h²|J̇V|, and β takes back a share.",
        pilot_.time, worst.number);
    worst.knobs = {notes_.more_substeps(1.2 * std::sqrt(worst.excess()))};
    notes_.keep(worst);
  }

  /// Law 10: contacts that hold by friction and are about to slip.
  void cones(const Moment<M>& moment) {
    const System<M>& system = moment.work.system;
    Finding worst{.law = 10, .quantity = "share of the friction cone", .number = 0.9, .limit = 1};
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
      if constexpr (B == Bound::friction || B == Bound::manifold) {
        double slip = 0, normal = 0;
        for (int k = normals<K, B>; k < K; ++k) slip += std::pow(system.lambda[block.row + k], 2);
        if constexpr (B == Bound::friction)
          normal = system.lambda[block.normal_row];
        else
          normal = system.lambda[block.row] + system.lambda[block.row + 1];
        const double bound = system.upper[block.row] * normal, share = bound > 0 ? std::sqrt(slip) / bound : 0;
        if (share > worst.number && share < 0.999)
          worst.number = share, worst.bodies = notes_.moving(block.body1, block.body2);
      }
    });
    if (worst.bodies.empty()) return;
    worst.sentence = fmt::format(
        "At {:.2f} s friction carries {:.3g} of what its cone allows: with a little less μ or a little more load, "
        "it slips.",
        pilot_.time, worst.number);
    worst.knobs = {{"friction", 0, "a larger μ of these bodies"}};
    notes_.keep(worst);
  }

  /// Law 13: how far a body in space turns in a substep. Its axes are taken as they are at the beginning.
  void turns(const Moment<M>& moment) {
    if constexpr (M::angular == 3) {
      const Bodies<M>& bodies = moment.scene.bodies();
      Finding worst{.law = 13, .quantity = "turn in a substep [rad]", .limit = 0.5};
      for (int i = 0; i < bodies.size(); ++i)
        if (const double turn = bodies.velocity[i].template tail<3>().norm() * notes_.treatment.h;
            moves(bodies.inverse_mass[i]) && turn > worst.number)
          worst.number = turn, worst.bodies = {i};
      if (worst.number == 0) return;
      worst.sentence = fmt::format(
          "At {:.2f} s it turns by θ = {:.3g} rad in a substep: a point held off its axis is off by 1 − cos θ = "
          "{:.3g} of its arm, and spin and precession have the wrong rate.",
          pilot_.time, worst.number, 1 - std::cos(worst.number));
      worst.knobs = {notes_.more_substeps(worst.number / 0.1)};
      notes_.keep(worst);
    }
  }

  /// Law 16: where contacts are not looked for ahead, what moves by more than half a body's thickness in a substep
  /// may pass it unseen.
  void speeds(const Moment<M>& moment) {
    if constexpr (M::angular > 0) {
      const Colliders<M>& colliders = moment.scene.colliders();
      if (colliders.lookahead >= 1) return;
      double thinnest = INFINITY, fastest = 0;
      int body = 0;
      for (std::size_t i = 0; i < colliders.shapes.size(); ++i) {
        if (const auto* block = std::get_if<Box<M>>(&colliders.shapes[i]))
          thinnest = std::min(thinnest, block->sides.minCoeff());
        if (const auto* round = std::get_if<Ball<M>>(&colliders.shapes[i]))
          thinnest = std::min(thinnest, 2 * round->radius);
        const double speed = moment.scene.bodies().velocity[i].template head<M::linear>().norm();
        if (speed > fastest && !std::holds_alternative<std::monostate>(colliders.shapes[i]))
          fastest = speed, body = static_cast<int>(i);
      }
      const double way = fastest * notes_.treatment.h * (1 - colliders.lookahead);
      if (std::isinf(thinnest) || way == 0) return;
      notes_.keep(
          {.law = 16,
           .quantity = "way in a substep [m]",
           .number = way,
           .limit = thinnest / 2 + colliders.margin,
           .bodies = {body},
           .sentence = fmt::format("At {:.2f} s it moves {:.3g} m in a substep, and the thinnest shape is {:.3g} "
                                   "m thick: beyond half of that plus the margin, it may pass through unseen.",
                                   pilot_.time, way, thinnest),
           .knobs = {{"contact_lookahead", 1, "contact_lookahead = 1"},
                     notes_.more_substeps(way / (thinnest / 2))}});
    }
  }

  void sweeps(const Moment<M>& moment) {
    const Moment<M> own = laid_out_for(moment, file_.method.solver, notes_.treatment.h);
    const Slowest<M> slowest = slowest_mode(own, one_sweep_of(file_.method.solver));
    const double rho = slowest.left_by_a_sweep;
    if (rho == 0) return;
    // Sweeps of Gauss–Seidel over rows that hold always remove something. Where they seem not to, a row has come
    // to its bound, and nothing is known of its rate.
    if (rho >= 1 && !std::holds_alternative<Jacobi>(file_.method.solver)) return;
    const double q = std::pow(rho, notes_.treatment.passes);
    if (std::holds_alternative<Jacobi>(file_.method.solver))
      notes_.keep({.law = 5,
                   .grade = beyond(rho, 1),
                   .quantity = "rate of a Jacobi sweep",
                   .number = rho,
                   .limit = 1,
                   .sentence = fmt::format(
                       "A sweep of Jacobi multiplies the slowest error by {:.3g}: rows that share a body all "
                       "answer at once.",
                       rho),
                   .knobs = {turn_to("relaxation", 1.8 / (1 + rho)), {"solver", 0, "solver = gauss_seidel"}}});
    columns(notes_, own, rho);
    // The row that the mode moves most.
    Lag lag{.time = moment.time, .left = q, .left_by_a_sweep = rho};
    double largest = 0;
    for_each_block(own.work.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      for (int k = 0; k < std::min(run.position_rows, M::linear); ++k) {
        const double rate = std::abs(slowest.rates[static_cast<std::size_t>(block.row + k)]);
        if (rate <= largest) continue;
        largest = rate;
        lag.joint = B == Bound::none;
        lag.pair = std::minmax<int>(block.body1, block.body2);
        lag.bodies = notes_.moving(block.body1, block.body2);
        lag.size = notes_.size_of_pair(block.body1, block.body2);
      }
    });
    if (largest == 0 || slowest.load == 0) return;
    double held = 0;  // |λ|/h of all rows now
    for (const double lambda : own.work.system.lambda) held += lambda * lambda;
    lag.load_share = std::abs(slowest.load) * largest / (std::sqrt(held) / notes_.treatment.h);
    lags_.push_back(lag);
  }

  SlowMode mode_of(const Lag& lag) const {
    const bool jumps = notes_.treatment.adds_velocity;
    return {.left = lag.left,
            .beta = jumps ? notes_.treatment.beta : 0,
            .share = jumps ? 0 : notes_.treatment.beta,
            .step = notes_.treatment.h,
            .warm_start = notes_.treatment.warm_start,
            .only_pushes = !lag.joint,
            .slop = notes_.treatment.slop};
  }

  void note_pressing() {
    auto& pairs = pressing_.emplace_back();
    for_each_block(pilot_.work.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
      bool holds = false;
      for (int k = 0; k < K && B != Bound::none; ++k)
        holds = holds || pilot_.work.system.lambda[block.row + k] > 0;
      if (holds) pairs.insert(std::minmax<int>(block.body1, block.body2));
    });
  }

  /// Mean |λ|/h in a step of the file [N]. `lasting` leaves out an impact, which its own step's sweeps answer.
  double load_in(std::size_t frame, bool lasting) const {
    const std::size_t first = lasting && frame > 0 ? frame - 1 : frame,
                      last = lasting ? std::min(frame + 1, loads_.size() - 1) : frame;
    return *std::min_element(&loads_[first], &loads_[last] + 1);
  }

  /// How far the slowest mode opens over the run, under the load that the exact motion has.
  void lag() {
    ModeState state;
    const Lag *at = &lags_.front(), *worst = at;
    double gap = 0, high = 0, low = 0, by_half = 0;  // of it, its last quarter and its first half [bodies]
    const long steps = std::lround(file_.duration / notes_.treatment.h);
    for (long i = 0; i < steps && gap < 1e3; ++i) {
      const double time = static_cast<double>(i) * notes_.treatment.h;
      while (at != &lags_.back() && at->time < time) ++at;
      const auto frame = std::min(loads_.size() - 1, static_cast<std::size_t>(time / file_.step));
      if (!at->joint && !pressing_[frame].contains(at->pair)) state = {};  // they have left each other
      state.step(mode_of(*at), load_in(frame, !at->joint) * at->load_share);
      const double now = state.C / at->size;
      if (std::abs(now) > gap) gap = std::abs(now), worst = at;
      if (2 * time < file_.duration) by_half = gap * (worst->joint ? 1 : 2);
      if (4 * i > 3 * steps) high = std::max(high, now), low = std::min(low, now);
    }
    const Lag& most = *worst;
    const double growth = mode_of(most).growth(), limit = (1 - most.left) / most.left;
    const bool grows = growth > 1.0005;
    const double needed = std::log(0.05) / std::log(std::min(most.left_by_a_sweep, 1 - 1e-12));
    const std::vector<Knob> knobs{exactly(), notes_.more_sweeps(needed / std::max(1, notes_.treatment.passes))};
    const std::string sweeps = fmt::format(
        "A sweep leaves ρ = {:.6g} of the slowest error, a substep q = {:.3g}. ", most.left_by_a_sweep, most.left);
    if (!most.joint) gap *= 2;  // the other modes of a pile add as much
    notes_.keep(
        {.law = most.joint ? (grows ? 6 : 4) : 4,
         .grade = beyond(gap, share_of_a_body),
         .quantity = most.joint ? "gap [bodies]" : "overlap [bodies]",
         .number = std::min(gap, 1e3),
         .limit = share_of_a_body,
         .bodies = most.bodies,
         .sentence =
             sweeps +
             (most.joint && grows
                  ? fmt::format("A warm start with β = {:.3g} is stable below (1 − q)/q = {:.3g}: the error "
                                "grows by {:.4g} a substep.",
                                notes_.treatment.beta, limit, growth)
                  : fmt::format("Under its load the mode opens by {:.3g} of a body before the sweeps catch up.",
                                gap)),
         .knobs = knobs,
         .shows = Shows::in_time,
         .by_half = by_half});
    if (!notes_.treatment.warm_start || !notes_.treatment.adds_velocity) return;
    if (!most.joint)
      notes_.keep(
          {.law = 9,
           .grade = beyond(high - low, share_of_a_body),
           .quantity = "hop [bodies]",
           .number = high - low,
           .limit = share_of_a_body,
           .bodies = most.bodies,
           .sentence =
               sweeps +
               fmt::format("A warm start with β = {:.3g} makes the bodies hop on each other, by {:.3g} of a body.",
                           notes_.treatment.beta, high - low),
           .knobs = knobs,
           .shows = Shows::in_time,
           .by_half = by_half});
    notes_.keep(
        {.law = 6,
         .quantity = "β·q/(1 − q)",
         .number = notes_.treatment.beta / limit,
         .limit = 1,
         .bodies = most.bodies,
         .sentence = fmt::format("β = {:.3g}, with a limit of (1 − q)/q = {:.3g}.", notes_.treatment.beta, limit),
         .knobs = {turn_to("beta", 0.5 * limit), exactly()}});
  }

  const SceneFile& file_;
  Notes<M> notes_;
  Trials<M> trials_;
  Simulation<M> pilot_;
  int parts_;                                            // steps of the pilot in one of the file
  double moved_at_ = 0;                                  // when anything last moved [s]
  std::vector<double> loads_;                            // mean |λ|/h of all rows in each step [N]
  std::vector<std::set<std::pair<int, int>>> pressing_;  // bodies that press on each other after each step
  std::vector<int> hardest_;
  double transverse_ = 0;               // the largest ω [1/s]
  long every_ = 1;                      // steps of the file between moments
  double taken_ = 0, most_motion_ = 0;  // by turning rows, of the motion [J]
  std::vector<double> openings_;        // of the joints, by row [m]
  std::vector<Lag> lags_;
};

bool fails_by(const Diagnosis& diagnosis, int law) {
  return std::any_of(diagnosis.findings.begin(), diagnosis.findings.end(),
                     [=](const Finding& one) { return one.law == law && one.grade == Grade::fails; });
}

}  // namespace

Diagnosis diagnose(const SceneFile& file) {
  return std::visit(
      [&]<class M>(const Scene<M>& scene) {
        if (const std::string reason = refusal(scene, file.method); !reason.empty())
          throw std::invalid_argument(reason);
        const bool large = scene.bodies().size() > 100;
        int parts = std::max(large ? 2 : 4, static_cast<int>(std::ceil(file.step * (large ? 120 : 240))));
        const int most_parts = 4 * parts;
        // Nothing, if the rows swing faster than that.
        const auto examine = [&](double give, double most_transverse) -> std::optional<Diagnosis> {
          for (;;) {
            // The pilot's own steps are short enough only well below law 7's limit.
            const double resolved = parts < most_parts ? parts / file.step : INFINITY;
            Examination<M> examination(file, scene, give, parts);
            Diagnosis diagnosis = examination.findings(std::min(resolved, most_transverse));
            if (examination.transverse() > most_transverse) return std::nullopt;
            if (examination.transverse() <= resolved) return diagnosis;
            parts = std::min(most_parts, static_cast<int>(std::ceil(1.25 * examination.transverse() * file.step)));
          }
        };
        constexpr double unseen = 0.002;
        Diagnosis diagnosis = *examine(unseen, INFINITY);
        // Law 7 says that bodies begin to swing. They stop where their swing has let the joints open so far that
        // they pull less: it fails only what pulls too hard even when they have opened as far as counts as a
        // failure.
        if (fails_by(diagnosis, 7))
          if (auto open = examine(share_of_a_body, 2 * file.method.substeps / file.step))
            diagnosis = *std::move(open);
        return diagnosis;
      },
      file.scene);
}

std::vector<double> body_sizes(const SceneFile& file) {
  return std::visit([](const auto& scene) { return sizes(scene); }, file.scene);
}

}  // namespace byhand::doctor
