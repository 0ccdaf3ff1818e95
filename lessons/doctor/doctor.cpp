#include "lessons/doctor/doctor.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "lessons/doctor/rows.hpp"
#include "lessons/doctor/slow_mode.hpp"
#include "lessons/laws/closed_forms.hpp"

// The scene is first moved by a method that solves each step exactly, with short steps. At moments of that motion
// the laws ask the rows what the file's own method and step would make of them.
namespace byhand::doctor {
namespace {

constexpr double share_of_a_body = 0.1;  // a gap of this share of a body is a failure
constexpr double hop_of_a_body = 0.01;   // bodies that go on hopping so high leave their places

/// How the file's method solves and corrects, as far as the laws ask.
struct Treatment {
  double h = 0;    // a substep [s]
  int passes = 0;  // of sweeps in a substep; 0 solves exactly
  bool warm_start = true;
  double beta = 0;             // share of C that a substep takes back
  double slop = 0;             // [m]
  bool adds_velocity = false;  // whether the correction is a velocity, which stays
  bool regularised = true;     // whether rows that repeat have an answer
};

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
  if (const auto* cure = std::get_if<Baumgarte>(&file.method.drift)) {
    treatment.beta = cure->beta, treatment.slop = cure->slop;
    treatment.adds_velocity = true;
  }
  if (const auto* cure = std::get_if<SplitImpulse>(&file.method.drift))
    treatment.beta = cure->beta, treatment.slop = cure->slop;
  if (const auto* cure = std::get_if<Projection>(&file.method.drift))
    treatment.beta = cure->share, treatment.slop = cure->slop;
  if (const auto* cure = std::get_if<SoftConstraints>(&file.method.drift)) {
    const double turn = treatment.h * cure->frequency;
    treatment.beta = turn / (2 * cure->damping_ratio + turn);
  }
  return treatment;
}

/// One sweep of the file's method.
RowSolver one_sweep_of(const RowSolver& solver) {
  RowSolver one = solver;
  if (auto* sweeps = std::get_if<GaussSeidel>(&one)) sweeps->sweeps = 1, sweeps->tolerance = 0;
  if (auto* jacobi = std::get_if<Jacobi>(&one)) jacobi->sweeps = 1;
  return one;
}

Knob turn_to(const std::string& name, double value) {
  return {name, value, fmt::format("{} = {:.3g}", name, value)};
}

/// The length of each body [m]: of its shape, else twice its longest arm, else a rod's length.
template <class M>
std::vector<double> sizes(const Scene<M>& scene) {
  std::vector<double> all(static_cast<std::size_t>(scene.bodies().size()), 0.0);
  for (std::size_t i = 0; i < scene.colliders().shapes.size(); ++i) {
    const Shape<M>& shape = scene.colliders().shapes[i];
    if (const auto* round = std::get_if<Ball<M>>(&shape)) all[i] = 2 * round->radius;
    if constexpr (M::angular > 0)
      if (const auto* block = std::get_if<Box<M>>(&shape)) all[i] = block->sides.maxCoeff();
  }
  const std::vector<double> shapes = all;
  const auto take = [&](int body, double length) {
    const auto at = static_cast<std::size_t>(body);
    if (shapes[at] == 0) all[at] = std::max(all[at], length);
  };
  const auto holds = [&](const auto& constraint) {
    if constexpr (M::angular > 0) {
      take(constraint.at.body1, 2 * constraint.at.arms.first.norm());
      take(constraint.at.body2, 2 * constraint.at.arms.second.norm());
    }
    if constexpr (requires { constraint.length; }) {
      if (all[static_cast<std::size_t>(constraint.at.body1)] == 0) take(constraint.at.body1, constraint.length);
      if (all[static_cast<std::size_t>(constraint.at.body2)] == 0) take(constraint.at.body2, constraint.length);
    }
  };
  for (const auto& one : scene.template all<Pin<M>>()) holds(one);
  for (const auto& one : scene.template all<Distance<M>>()) holds(one);
  for (const auto& one : scene.template all<NormalisedDistance<M>>()) holds(one);
  for (const auto& one : scene.template all<Rope<M>>()) holds(one);
  if constexpr (M::angular > 0) {
    for (const auto& one : scene.template all<Weld<M>>()) holds(one);
    for (const auto& one : scene.template all<Slider<M>>()) holds(one);
  }
  if constexpr (M::angular == 3)
    for (const auto& one : scene.template all<Hinge<M>>()) holds(one);
  return all;
}

template <class M>
class Examination {
 public:
  Examination(const SceneFile& file, const Scene<M>& scene)
      : file_(file), treatment_(treatment_of(file)), pilot_{scene, {ByGraph{}, Baumgarte{.slop = 0.001}}} {
    parts_ = std::max(4, static_cast<int>(std::ceil(file.step * 240)));
    sizes_ = sizes(scene);
  }

  Diagnosis findings() {
    at_the_start();
    const long steps = std::max(1L, std::lround(file_.duration / file_.step));
    const long every = std::max(1L, steps / 24);
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
      loads_.push_back(impulse / file_.step);
      if (!pilot_.work.system.lambda.empty()) follow_bends();
      if (i % every == 0 || i == 3) at_a_moment();
    }
    if (!lags_.empty()) lag();
    Diagnosis diagnosis;
    for (auto& [key, finding] : worst_) diagnosis.findings.push_back(std::move(finding));
    std::stable_sort(diagnosis.findings.begin(), diagnosis.findings.end(), [](const Finding& a, const Finding& b) {
      if (a.grade != b.grade) return a.grade > b.grade;
      return a.grade == Grade::fails && a.time != b.time ? a.time < b.time : a.excess() > b.excess();
    });
    return diagnosis;
  }

 private:
  /// The slowest mode of the sweeps at one moment.
  struct Lag {
    double time = 0, left = 0, left_by_a_sweep = 0;  // [s]; q of a substep, ρ of a sweep
    double load_share = 0;  // the rate that the load gives the worst row in a substep, by |λ|/h of all rows
    double size = 1;        // of its bodies [m]
    bool joint = true;
    std::vector<int> bodies = {};
  };

  double size_of_pair(int body1, int body2) const {
    const double one = sizes_[static_cast<std::size_t>(body1)], two = sizes_[static_cast<std::size_t>(body2)];
    const double both = one > 0 && two > 0 ? std::min(one, two) : std::max(one, two);
    return both > 0 ? both : 1;
  }
  std::vector<int> moving(int body1, int body2) const {
    std::vector<int> all;
    for (const int body : {body1, body2})
      if (moves(pilot_.scene.bodies().inverse_mass[body])) all.push_back(body);
    return all;
  }

  /// Keeps a law's worst finding, with the time at which the law first fails.
  void keep(Finding finding) {
    finding.time = pilot_.time;
    if (finding.grade != Grade::fails)
      finding.grade = finding.excess() > 0.7 ? Grade::near_the_limit : Grade::fine;
    const auto [place, is_new] = worst_.try_emplace({finding.law, finding.quantity}, finding);
    if (is_new || finding.excess() <= place->second.excess()) return;
    if (place->second.grade == Grade::fails) finding.time = place->second.time, finding.grade = Grade::fails;
    place->second = finding;
  }
  static Grade beyond(double number, double limit) { return number > limit ? Grade::fails : Grade::fine; }

  int substeps() const { return file_.method.substeps; }
  Knob more_substeps(double factor) const {
    return turn_to("substeps", std::ceil(substeps() * std::max(factor, 1.01)));
  }
  Knob more_sweeps(double factor) const {
    const int now = std::max(1, treatment_.passes);
    return turn_to("sweeps", std::min(1e6, std::ceil(now * std::max(factor, 1.2))));
  }
  static Knob exactly() { return {"solver", 0, "solver = by_graph"}; }

  // Before anything moves: β, overlaps, rows that repeat or contradict each other.
  void at_the_start() {
    if (treatment_.adds_velocity && treatment_.beta > 0) {
      const double limit = 2;
      keep({.law = 1,
            .grade = beyond(treatment_.beta, limit),
            .quantity = "β",
            .number = treatment_.beta,
            .limit = limit,
            .sentence = fmt::format(
                "A step takes back β = {:.3g} of an error; above 2 the error grows, by |1 − β| = {:.3g} "
                "each step.",
                treatment_.beta, std::abs(1 - treatment_.beta)),
            .knobs = {turn_to("beta", 0.2)}});
    }
    Scene<M> scene = pilot_.scene;
    Work<M> work;
    work.contacts.find(scene, treatment_.h);
    lay_out(scene, RowSolver(GaussSeidel{}), work);
    write_rows(scene, treatment_.h, work);
    overlaps(scene, work.system);
    repeated(scene, work.system);
    contradicting_limits(work.system);
  }

  void overlaps(const Scene<M>& scene, const System<M>& system) {
    if (!treatment_.adds_velocity || treatment_.beta <= 0 || treatment_.beta > 1) return;
    const double gravity = scene.gravity.norm();
    if (gravity == 0) return;
    const double limit = laws::popping_overlap(treatment_.beta, treatment_.h, gravity) + treatment_.slop;
    Finding deepest{.law = 2, .quantity = "overlap [m]", .limit = limit};
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      for (int k = 0; k < run.position_rows; ++k)
        if (one_sided(system, block, k) && -system.C[block.row + k] > deepest.number) {
          deepest.number = -system.C[block.row + k];
          deepest.bodies = moving(block.body1, block.body2);
        }
    });
    if (deepest.number <= treatment_.slop) return;
    const double speed = treatment_.beta * deepest.number / treatment_.h;
    deepest.grade = beyond(deepest.number, limit);
    deepest.sentence = fmt::format(
        "They begin {:.3g} m in each other. The correction drives them apart at βd/h = {:.3g} m/s, which stays: "
        "they leave "
        "each other if they overlap by more than {:.3g} m.",
        deepest.number, speed, limit);
    deepest.knobs = {{"cure", 0, "cure = split_impulse"},
                     turn_to("beta", treatment_.beta * limit / deepest.number)};
    keep(deepest);
  }

  /// Two stops of one freedom, of which no motion reaches both sides.
  void contradicting_limits(const System<M>& system) {
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
          worst.number = apart, worst.bodies = moving(one.body1, one.body2);
      }
    if (worst.number <= worst.limit) return;
    worst.grade = Grade::fails;
    worst.sentence = fmt::format(
        "The lower stop lies {:.3g} above the upper one: no motion obeys both, and λ grows without end.",
        worst.number);
    worst.knobs = {{"constraints", 0, "exchange at_least and at_most"}};
    keep(worst);
  }

  /// Rows without bounds that depend on each other, by the eigenvalues of D^-½ A D^-½.
  void repeated(const Scene<M>& scene, const System<M>& system) {
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
      std::vector<Velocity<M>> V(static_cast<std::size_t>(scene.bodies().size()), Velocity<M>::Zero());
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
      if (std::abs(conflict) / size_of_pair(pair[0], pair[1]) >= gap) {
        gap = std::abs(conflict) / size_of_pair(pair[0], pair[1]);
        finding.bodies = moving(pair[0], pair[1]);
      }
    }
    if (repeats == 0) return;
    const bool has_no_answer = !treatment_.regularised, contradicts = gap > share_of_a_body;
    finding.number = repeats;
    finding.grade = has_no_answer || contradicts ? Grade::fails : Grade::fine;
    finding.limit = finding.grade == Grade::fails ? 1 : 10.0 * repeats;
    finding.sentence =
        contradicts
            ? fmt::format(
                  "{} of {} rows repeat what others say, and contradict them by {:.2g} of a body: no motion obeys "
                  "all, and λ grows without end.",
                  repeats, count, gap)
            : fmt::format("{} of {} rows repeat what others say: only the sum of their λ is known.", repeats,
                          count);
    finding.knobs = {contradicts ? Knob{"constraints", 0, "take out or lengthen the rod that contradicts"}
                                 : turn_to("regularisation", 1e-7),
                     exactly()};
    keep(finding);
  }

  Moment<M> now() const { return {pilot_.scene, pilot_.work, file_.step / parts_, pilot_.time}; }

  void at_a_moment() {
    const Moment<M> moment = now();
    turns(moment);
    speeds(moment);
    if (moment.work.system.rows() == 0) return;
    transverse(moment);
    cones(moment);
    if (treatment_.passes > 0) sweeps(moment);
  }

  void transverse(const Moment<M>& moment) {
    const double frequency = largest_transverse_frequency(moment);
    if (frequency == 0) return;
    const double number = frequency * treatment_.h, limit = 2;
    const double hardest = strongest(moment);
    keep(
        {.law = 7,
         .grade = beyond(number, 0.87 * limit),  // it is seen at some moments only
         .quantity = "ω·h",
         .number = number,
         .limit = limit,
         .bodies = hardest_,
         .sentence = fmt::format("At {:.2f} s a joint pulls with {:.3g} N, which makes light bodies swing across "
                                 "it at ω = {:.3g} /s: ω·h = {:.3g}, "
                                 "and J that stands still over a step is stable up to 2. More sweeps cannot help.",
                                 pilot_.time, hardest, frequency, number),
         .knobs = {more_substeps(1.25 * number / limit)}});
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
        hardest_ = moving(block.body1, block.body2);
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
    const double kept = std::pow(1 - std::min(1.0, treatment_.beta), count);
    Finding worst{.law = 13, .quantity = "gap of a turning joint [bodies]", .limit = share_of_a_body};
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      if (B != Bound::none) return;
      double sum = 0;
      for (int k = 0; k < std::min(run.position_rows, M::linear); ++k)
        sum += std::pow(bend[static_cast<std::size_t>(block.row + k)], 2);
      const double step = 0.5 * treatment_.h * treatment_.h * std::sqrt(sum);
      double& opening = openings_[static_cast<std::size_t>(block.row)];
      // The sum of a geometric series: what each of the substeps leaves of the step before.
      const double added = treatment_.beta > 0 ? step * (1 - kept) / std::min(1.0, treatment_.beta) : step * count;
      opening = opening * kept + added;
      const double number = opening / size_of_pair(block.body1, block.body2);
      if (number > worst.number) worst.number = number, worst.bodies = moving(block.body1, block.body2);
    });
    if (worst.number == 0) return;
    worst.grade = beyond(worst.number, worst.limit);
    worst.sentence = fmt::format(
        "At {:.2f} s a joint bends its way so fast that it stands open by {:.3g} of a body: a substep adds "
        "½h²|J̇V|, "
        "and β takes back a share.",
        pilot_.time, worst.number);
    worst.knobs = {more_substeps(1.2 * std::sqrt(worst.excess()))};
    keep(worst);
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
          worst.number = share, worst.bodies = moving(block.body1, block.body2);
      }
    });
    if (worst.bodies.empty()) return;
    worst.sentence = fmt::format(
        "At {:.2f} s friction carries {:.3g} of what its cone allows: a little less of μ, or a little more of "
        "a load, and it slips.",
        pilot_.time, worst.number);
    worst.knobs = {{"friction", 0, "a larger μ of these bodies"}};
    keep(worst);
  }

  /// Law 13: how far a body in space turns in a substep. Its axes are taken as they are at the beginning.
  void turns(const Moment<M>& moment) {
    if constexpr (M::angular == 3) {
      const Bodies<M>& bodies = moment.scene.bodies();
      Finding worst{.law = 13, .quantity = "turn in a substep [rad]", .limit = 0.5};
      for (int i = 0; i < bodies.size(); ++i)
        if (const double turn = bodies.velocity[i].template tail<3>().norm() * treatment_.h;
            moves(bodies.inverse_mass[i]) && turn > worst.number)
          worst.number = turn, worst.bodies = {i};
      if (worst.number == 0) return;
      worst.sentence = fmt::format(
          "At {:.2f} s it turns by θ = {:.3g} rad in a substep: whatever is held off its axis is off by a share 1 "
          "− cos θ = {:.3g} of "
          "its arm, and spin and precession lose their pace.",
          pilot_.time, worst.number, 1 - std::cos(worst.number));
      worst.knobs = {more_substeps(worst.number / 0.1)};
      keep(worst);
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
      const double way = fastest * treatment_.h * (1 - colliders.lookahead);
      if (std::isinf(thinnest) || way == 0) return;
      keep({.law = 16,
            .quantity = "way in a substep [m]",
            .number = way,
            .limit = thinnest / 2 + colliders.margin,
            .bodies = {body},
            .sentence = fmt::format("At {:.2f} s it moves {:.3g} m in a substep, and the thinnest shape is {:.3g} "
                                    "m thick: beyond half of "
                                    "that, and the margin, it may pass unseen.",
                                    pilot_.time, way, thinnest),
            .knobs = {{"contact_lookahead", 1, "contact_lookahead = 1"}, more_substeps(way / (thinnest / 2))}});
    }
  }

  void sweeps(const Moment<M>& moment) {
    const Moment<M> own = laid_out_for(moment, file_.method.solver, treatment_.h);
    const Slowest<M> slowest = slowest_mode(own, one_sweep_of(file_.method.solver));
    const double rho = slowest.left_by_a_sweep;
    if (rho == 0) return;
    const double q = std::pow(rho, treatment_.passes);
    if (std::holds_alternative<Jacobi>(file_.method.solver))
      keep({.law = 5,
            .grade = beyond(rho, 1),
            .quantity = "rate of a Jacobi sweep",
            .number = rho,
            .limit = 1,
            .sentence =
                fmt::format("A sweep of Jacobi multiplies the slowest error by {:.3g}: rows that share a body all "
                            "answer at once.",
                            rho),
            .knobs = {turn_to("relaxation", 1.8 / (1 + rho)), {"solver", 0, "solver = gauss_seidel"}}});
    columns(own, rho);
    // The row that the mode moves most.
    Lag lag{.time = moment.time, .left = q, .left_by_a_sweep = rho};
    double largest = 0;
    for_each_block(own.work.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run& run) {
      for (int k = 0; k < std::min(run.position_rows, M::linear); ++k) {
        const double rate = std::abs(slowest.rates[static_cast<std::size_t>(block.row + k)]);
        if (rate <= largest) continue;
        largest = rate;
        lag.joint = B == Bound::none;
        lag.bodies = moving(block.body1, block.body2);
        lag.size = size_of_pair(block.body1, block.body2);
      }
    });
    if (largest == 0 || slowest.load == 0) return;
    double held = 0;  // |λ|/h of all rows now
    for (const double lambda : own.work.system.lambda) held += lambda * lambda;
    lag.load_share = std::abs(slowest.load) * largest / (std::sqrt(held) / treatment_.h);
    lags_.push_back(lag);
  }

  SlowMode mode_of(const Lag& lag) const {
    const bool jumps = treatment_.adds_velocity;
    return {.left = lag.left,
            .beta = jumps ? treatment_.beta : 0,
            .share = jumps ? 0 : treatment_.beta,
            .step = treatment_.h,
            .warm_start = treatment_.warm_start,
            .only_pushes = !lag.joint,
            .slop = treatment_.slop};
  }

  /// How far the slowest mode opens over the run, under the load that the exact motion has.
  void lag() {
    ModeState state;
    const Lag *at = &lags_.front(), *worst = at;
    double gap = 0, high = 0, low = 0, when = 0;  // of it, and of its last quarter [bodies]
    const long steps = std::lround(file_.duration / treatment_.h);
    for (long i = 0; i < steps && gap < 1e3; ++i) {
      const double time = static_cast<double>(i) * treatment_.h;
      while (at != &lags_.back() && at->time < time) ++at;
      const auto frame = std::min(loads_.size() - 1, static_cast<std::size_t>(time / file_.step));
      state.step(mode_of(*at), loads_[frame] * at->load_share);
      const double now = state.C / at->size;
      if (std::abs(now) > gap) gap = std::abs(now), worst = at;
      if (gap > share_of_a_body && when == 0) when = time;
      if (4 * i > 3 * steps) high = std::max(high, now), low = std::min(low, now);
    }
    const Lag& most = *worst;
    const double growth = mode_of(most).growth(), limit = (1 - most.left) / most.left;
    const bool grows = growth > 1.0005;
    const double needed = std::log(0.05) / std::log(std::min(most.left_by_a_sweep, 1 - 1e-12));
    const std::vector<Knob> knobs{exactly(), more_sweeps(needed / std::max(1, treatment_.passes))};
    const std::string sweeps = fmt::format(
        "A sweep leaves ρ = {:.6g} of the slowest error, a substep q = {:.3g}. ", most.left_by_a_sweep, most.left);
    if (!most.joint) gap *= 2;  // the other modes of a pile add as much
    keep({.law = most.joint ? (grows ? 6 : 4) : 23,
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
                                 treatment_.beta, limit, growth)
                   : fmt::format("Under its load the mode opens by {:.3g} of a body before the sweeps catch up.",
                                 gap)),
          .knobs = knobs});
    if (!treatment_.warm_start || !treatment_.adds_velocity) return;
    if (!most.joint)
      keep({.law = 9,
            .grade = beyond(high - low, hop_of_a_body),
            .quantity = "hop [bodies]",
            .number = high - low,
            .limit = hop_of_a_body,
            .bodies = most.bodies,
            .sentence =
                sweeps +
                fmt::format("Warm start and β = {:.3g} make the bodies hop on each other, by {:.3g} of a body.",
                            treatment_.beta, high - low),
            .knobs = knobs});
    keep({.law = 6,
          .quantity = "β·q/(1 − q)",
          .number = treatment_.beta / limit,
          .limit = 1,
          .bodies = most.bodies,
          .sentence = fmt::format("β = {:.3g} beside (1 − q)/q = {:.3g}.", treatment_.beta, limit),
          .knobs = {turn_to("beta", 0.5 * limit), exactly()}});
  }

  /// Law 9: the heaviest body above a lighter one, along the paths of pushes. A warm start settles up to about
  /// three times the sweeps, at β = 0.2.
  void mass_ratios(const std::vector<std::vector<int>>& above, const Bodies<M>& bodies) {
    Finding worst{.law = 9, .quantity = "mass ratio along a path of pushes", .limit = 3.0 * treatment_.passes};
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
    worst.sentence = fmt::format(
        "The upper body is {:.3g} times as heavy as one that carries it; {} warm sweeps settle at β = 0.2 up to "
        "about {:.3g}.",
        worst.number, treatment_.passes, worst.limit);
    worst.knobs = {exactly(), more_sweeps(worst.excess())};
    keep(worst);
  }

  /// Law 4 from λ = 0: a sweep passes a weight down by one contact, so that the foot of a pile as high as this
  /// needs as many sweeps in every step.
  void cold_height(const std::vector<std::vector<int>>& above, const Bodies<M>& bodies) {
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
    const double number = static_cast<double>(highest) / treatment_.passes, limit = 2.5;
    if (highest < 2 || !moves(bodies.inverse_mass[top])) return;
    keep({.law = 4,
          .grade = beyond(number, limit),
          .quantity = "contacts below the top by cold sweeps",
          .number = number,
          .limit = limit,
          .bodies = {top},
          .sentence = fmt::format(
              "{} contacts lie between the ground and the top of the pile, and {} sweep{} from λ = 0 pass its "
              "weight down by as many.",
              highest, treatment_.passes, treatment_.passes == 1 ? "" : "s"),
          .knobs = {exactly(), more_sweeps(static_cast<double>(highest) / treatment_.passes)}});
  }

  /// Law 18: bodies that stand one upon the other, each on one and under one.
  void columns(const Moment<M>& moment, double rho) {
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
      if (!treatment_.warm_start) cold_height(above, bodies);
      mass_ratios(above, bodies);
      for (int first = 0; first < bodies.size(); ++first) {
        const auto at = static_cast<std::size_t>(first);
        if (!moves(bodies.inverse_mass[first]) || below[at].size() != 1 ||
            moves(bodies.inverse_mass[below[at][0]]))
          continue;
        std::vector<int> column{first};
        while (above[static_cast<std::size_t>(column.back())].size() == 1 && column.size() <= count)
          column.push_back(above[static_cast<std::size_t>(column.back())][0]);
        if (column.size() < 3 || !above[static_cast<std::size_t>(column.back())].empty()) continue;
        const double height = (bodies.pose[column.back()].position - bodies.pose[first].position).dot(up) /
                              static_cast<double>(column.size() - 1);
        const double tipping2 = laws::tipping_rate_squared(static_cast<int>(column.size()),
                                                           moment.scene.gravity.norm(), {height, height});
        const double q = std::pow(rho, treatment_.passes), h = treatment_.h;
        const double number = tipping2 * h * h * q / std::max(1 - q, 1e-12);
        const SlowMode lean{
            .left = q, .tipping = std::sqrt(tipping2), .step = h, .warm_start = treatment_.warm_start};
        const double growth = lean.growth();
        double push = 1e-9;
        for (const int body : column)
          push = std::max(push, bodies.velocity[body].template head<M::linear>().norm() * h);
        const double falls = growth > 1 + 1e-9 ? std::log(0.5 * height / push) / std::log(growth) * h : INFINITY;
        keep({.law = 18,
              .grade = falls < file_.duration ? Grade::fails : Grade::fine,
              .quantity = "(σh)² q/(1 − q)",
              .number = number,
              .limit = 1,
              .bodies = column,
              .sentence = fmt::format(
                  "A column of {} tips over at σ = {:.3g} /s by itself, and {} sweeps leave q = {:.4g} of its "
                  "bending. {}",
                  column.size(), std::sqrt(tipping2), treatment_.passes, q,
                  std::isfinite(falls)
                      ? fmt::format("A push grows by {:.4g} a substep: it falls about {:.2g} s later.", growth,
                                    falls)
                      : "A push dies out."),
              .knobs = {exactly(), more_sweeps(1.5 * laws::sweeps_to_stand(tipping2, rho, h) / treatment_.passes),
                        more_substeps(1.3 * std::sqrt(number))}});
      }
    }
  }

  const SceneFile& file_;
  Treatment treatment_;
  Simulation<M> pilot_;
  int parts_ = 1;                      // steps of the pilot in one of the file
  std::vector<double> sizes_, loads_;  // of the bodies [m]; mean |λ|/h of all rows in each step [N]
  std::vector<int> hardest_;
  std::map<std::pair<int, std::string>, Finding> worst_;  // by law and quantity
  std::vector<double> openings_;                          // of the joints, by row [m]
  std::vector<Lag> lags_;
};

}  // namespace

Diagnosis diagnose(const SceneFile& file) {
  return std::visit(
      [&]<class M>(const Scene<M>& scene) {
        if (const std::string reason = refusal(scene, file.method); !reason.empty())
          throw std::invalid_argument(reason);
        return Examination<M>(file, scene).findings();
      },
      file.scene);
}

std::vector<double> body_sizes(const SceneFile& file) {
  return std::visit([](const auto& scene) { return sizes(scene); }, file.scene);
}

SceneFile turned(SceneFile file, const Knob& knob) {
  const auto set = [&](auto& choices, auto member) { std::visit([&](auto& one) { member(one); }, choices); };
  if (knob.name == "substeps") file.method.substeps = static_cast<int>(knob.value);
  if (knob.name == "solver") {
    if (knob.words == "solver = gauss_seidel")
      file.method.solver = GaussSeidel{};
    else
      file.method.solver = ByGraph{};
  }
  if (knob.name == "cure") file.method.drift = SplitImpulse{};
  set(file.method.solver, [&](auto& one) {
    if constexpr (requires { one.sweeps; })
      if (knob.name == "sweeps") one.sweeps = static_cast<int>(knob.value);
    if constexpr (requires { one.relaxation; })
      if (knob.name == "relaxation") one.relaxation = knob.value;
    if constexpr (requires { one.regularisation; })
      if (knob.name == "regularisation") one.regularisation = knob.value;
  });
  set(file.method.drift, [&](auto& one) {
    if constexpr (requires { one.beta; })
      if (knob.name == "beta") one.beta = knob.value;
  });
  return file;
}

}  // namespace byhand::doctor
