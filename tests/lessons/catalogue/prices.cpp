// What a row-solve, a row that is written, a body that is moved … takes in instructions: measures the prices of
// lessons/catalogue/prices.inc, and holds costs that are counted with them against callgrind's count. Both draw
// settings: every kind of rows, from one body to two hundred, every method and cure.
//
//   prices run COUNT SEED [ONLY]
//                            under valgrind --tool=callgrind: draws that many settings, runs them, only those of
//                            one method or one kind of rows if it is named, and has callgrind write the
//                            instructions of each. Prints what each counted
//   prices fit COUNTED DUMPS the prices, none below zero, with the least relative error, as a table of C++
//   prices check COUNTED DUMPS  fails unless of 10 settings 9 are counted within 15 %, and of 100 at most one is
//                            more than 30 % off: of boxes that tumble in space, and of two methods on one body
//
// prices.sh puts them together.

#include <fmt/format.h>
#include <valgrind/callgrind.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "lessons/catalogue/run.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/ragdoll.hpp"
#include "lessons/scenes/slider_crank.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/constraints/weld.hpp"

namespace {

using namespace byhand;

constexpr const char* bob_models[] = {"bobs in the plane", "balls in the plane", "links in the plane",
                                      "bobs in space",     "balls in space",     "links in space"};

constexpr int counts = std::tuple_size_v<Counts>;

/// Accuracy as the input, which is no choice of the chooser's: the strength of such a "family" is its tolerance.
template <class Base>
Family to_a_tolerance(const std::string& name) {
  Family family;
  family.name = name;
  family.cures = {Cure::none};
  family.solves_rows = false;
  family.setting = [](const Knobs& knobs) { return Setting{Controlled<Base>{knobs.strength}, knobs.substeps}; };
  return family;
}

/// Exact solves, as the true motions of files are found.
Family true_motion() {
  Family family;
  family.name = "by graph";
  family.cures = {Cure::baumgarte};
  family.exact = true;
  family.setting = [](const Knobs& knobs) {
    AnyStepping method{ByGraph{}, Baumgarte{knobs.strength}};
    method.substeps = knobs.substeps;
    method.gyroscopic = Gyroscopic::implicit;
    return Setting{method};
  };
  return family;
}

/// All that has prices.
const std::vector<Family>& priced() {
  static const std::vector<Family> all = [] {
    std::vector<Family> found = families();
    found.push_back(true_motion());
    found.push_back(to_a_tolerance<Rattle>("RATTLE to a tolerance"));
    found.push_back(to_a_tolerance<Generalised>("generalised, to a tolerance"));
    return found;
  }();
  return all;
}
const Family& priced(std::string_view name) {
  return *std::find_if(priced().begin(), priced().end(), [&](const Family& one) { return one.name == name; });
}

Cure cure_named(std::string_view name) {
  for (const Cure cure : {Cure::baumgarte, Cure::projection, Cure::split_impulse, Cure::soft})
    if (name_of(cure) == name) return cure;
  return Cure::none;
}

/// Which counts a part of a step has a price for.
std::array<bool, counts> paid_by(std::string_view part, bool solves_rows) {
  // row-solve, laid out, solve, pass, prepared, projected, written, body, contact, substep, step, planned, pair
  if (part == "stepping") return {0, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0, 1};
  if (!solves_rows) return {1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 0, 1};
  if (std::any_of(priced().begin(), priced().end(), [&](const Family& one) { return one.name == part; }))
    return {1, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, part == "direct" || part == "by graph"};
  return {1, 0, 0, 0, 0, 1, 1, 1, 0, 1, 0, 0};  // a cure
}

class Draws {
 public:
  explicit Draws(unsigned seed) : engine_(seed) {}
  template <class T>
  T one_of(std::initializer_list<T> all) {
    return all.begin()[below(all.size())];
  }
  std::size_t below(std::size_t count) { return engine_() % count; }
  double between(double low, double high) { return low * std::pow(high / low, (engine_() >> 5) / 134217728.0); }

 private:
  std::mt19937 engine_;
};

/// A scene that is not of the catalogue.
template <class M>
Problem uncatalogued(const std::string& name, const Scene<M>& scene) {
  NamedScene named;
  named.name = named.title = name;
  named.models = {name};
  named.duty = Duty::keep;
  named.keeps_energy = false;
  named.body = 1e9;
  named.make = [scene](const Problem&) { return AnyScene(scene); };
  return Problem(std::move(named));
}
/// Boxes that fall onto the ground askew, in rows of three: contacts come and go.
template <class M>
Problem falling(int count) {
  Scene<M> scene;
  add_ground(scene);
  for (int i = 0; i < count; ++i) {
    const int level = i / 3;
    Pose<M> pose;
    pose.position = (i % 3 - 1.0) * 1.3 * Linear<M>::Unit(0) + (0.75 + 1.4 * level) * Linear<M>::Unit(1);
    if constexpr (M::linear == 2)
      pose.rotation = plane_rotation(0.3 + 0.7 * i);
    else
      pose.rotation = space_rotation(Angular<M>(0.3 + 0.7 * i, 0.2, 0.4 * i));
    add_box(scene, pose, 1 + i % 2, Linear<M>(Linear<M>::Ones()));
  }
  return uncatalogued("falling boxes", scene);
}
template <class M>
Problem kicked(Scene<M> scene) {
  kick(scene, 0.02);
  return uncatalogued("boxes", scene);
}

/// A chain of ropes, which tighten as it falls.
template <class M>
Problem ropes(int links) {
  Scene<M> scene = rod_chain<M, Rope>({.links = links, .end_mass = 4, .angle = 1.3});
  for (Pose<M>& pose : scene.state().pose) pose.position *= 0.95;
  return uncatalogued("ropes", scene);
}

/// A chain of links that swing about one axis each, held at its first or floating and turning.
Problem hinged(int links, bool held) {
  using M = SpaceBody;
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), held ? fixed<M>() : box<M>(2, {1, 0.1, 0.2}));
  for (int i = 1; i <= links; ++i) {
    scene.add_body(Linear<M>((i - 0.5) * Linear<M>::UnitX()), box<M>(1 + i % 2, {1, 0.1, 0.2}));
    const Linear<M> axis = Linear<M>(0, 0.3 * (i % 3), 1).normalized();
    scene.add(hinge(scene.bodies(), i - 1, i, Linear<M>((i - 1.0) * Linear<M>::UnitX()), axis));
  }
  if (!held) scene.state().velocity[0].tail<M::angular>() = Angular<M>(1, 2, 3);
  return uncatalogued("hinges", scene);
}

/// A chain of pins, sliders and welds by turns; or without welds, held together by springs.
template <class M>
Problem mixed(int links, bool sprung) {
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  for (int i = 1; i <= links; ++i) {
    const Linear<M> along = Linear<M>::UnitX(), point = (0.3 * i - 0.15) * along;
    scene.add_body(Linear<M>(0.3 * i * along), box<M>(1 + i % 2, Linear<M>::Constant(0.2)));
    if (i % 3 == 0)
      scene.add(pin<M>(scene.bodies(), i - 1, i, point));
    else if (i % 3 == 1 || sprung)
      scene.add(slider<M>(scene.bodies(), i - 1, i, point, sprung ? Linear<M>::UnitY() : along));
    else
      scene.add(weld<M>(scene.bodies(), i - 1, i, point));
    if (sprung) scene.add(Spring<M>{{i - 1, i}, 0.3, {200, 1}});
  }
  return uncatalogued("mixed joints", scene);
}

enum class Ties { rods, springs, rods_of_both_kinds, rods_and_springs };

/// A net of rods or springs, or of two kinds by turns, that hangs by two corners; braced by one, with a tie across
/// each mesh. What a direct solve eliminates has loops.
template <class M>
Problem net(int width, int height, Ties ties, bool braced) {
  Scene<M> scene;
  for (int i = 0; i < width * height; ++i) {
    const int level = i / width;
    scene.add_body(Linear<M>((i % width) * Linear<M>::Unit(0) - level * Linear<M>::Unit(1)),
                   i == 0 || (i == width - 1 && !braced) ? fixed<M>() : with_mass<M>(1 + i % 2));
  }
  const auto tie = [&](int i, int other, double length) {
    const bool odd = scene.count() % 2 == 1;
    if (ties == Ties::springs || (ties == Ties::rods_and_springs && odd))
      scene.add(Spring<M>{{other, i}, length, {200, 1}});
    else if (ties == Ties::rods_of_both_kinds && odd)
      scene.add(NormalisedDistance<M>{{other, i}, length});
    else
      scene.add(Distance<M>{{other, i}, length});
  };
  for (int i = 0; i < width * height; ++i) {
    const bool below = i >= width, right = i % width > 0;
    if (right && (below || width > 2 || braced)) tie(i, i - 1, 1);
    if (below) tie(i, i - width, 1);
    if (below && right && braced) tie(i, i - width - 1, std::sqrt(2.0));
  }
  return uncatalogued(braced ? "truss" : "net", scene);
}

/// The turn of a link of a chain in the plane x, y against the one before it.
template <class M>
Turn<M> turn_of(const Scene<M>& scene, int link) {
  if constexpr (M::angular == 1)
    return turn<M>(scene.bodies(), link - 1, link);
  else
    return turn<M>(scene.bodies(), link - 1, link, Linear<M>::UnitZ());
}

/// A chain whose first joint is driven and whose others have stops.
template <class M>
Problem machine(int links, double strength) {
  Scene<M> scene = pinned_chain<M>({.links = links, .angle = 1.3});
  scene.add(motor(turn_of(scene, 1), 2, strength));
  for (int link = 2; link <= links; ++link)
    for (const Stop stop : {Stop::lower, Stop::upper})
      scene.add(Limit<M, Turn>{turn_of(scene, link), stop == Stop::lower ? -0.4 : 0.4, stop});
  return uncatalogued("machine", scene);
}

/// An arm whose first joint is driven, and whose others are drawn: ball joints with a stop of their swing, hinges,
/// some held by a servo, and welds; a part of them with a spring beside.
Problem drawn_arm(int links, Draws& draws) {
  using M = SpaceBody;
  const Linear<M> along = Linear<M>::UnitX(), axis = Linear<M>(0, 0.6, 0.8);
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  for (int i = 1; i <= links; ++i) {
    const Linear<M> point = (0.3 * i - 0.15) * along;
    scene.add_body(Linear<M>(0.3 * i * along), box<M>(1 + i % 2, Linear<M>::Constant(0.2)));
    const int joint = i > 1 ? draws.one_of({0, 1, 2, 3}) : 0;
    if (joint == 2) {
      scene.add(pin<M>(scene.bodies(), i - 1, i, point));
      scene.add(at_most<M>(1.0, Swing<M>{i - 1, i, along, along}));
    } else if (joint == 3) {
      scene.add(weld<M>(scene.bodies(), i - 1, i, point));
    } else {
      scene.add(hinge(scene.bodies(), i - 1, i, point, axis));
      const Turn<M> freedom = turn<M>(scene.bodies(), i - 1, i, axis);
      if (i == 1)
        scene.add(motor(freedom, 2, 50));
      else if (joint == 1)
        scene.add(servo<M>(freedom, 0.3, {100, 5}, 50));
    }
    if (draws.one_of({true, false, false, false})) scene.add(Spring<M>{{i - 1, i}, 0.3, {80, 1}});
  }
  return uncatalogued("arm", scene);
}

/// Balls on the ground, or on a table that has no weight to hold them down, some far apart.
template <class M>
Problem balls(int count, bool weight, double apart) {
  Scene<M> scene;
  if (weight)
    add_ground(scene);
  else
    scene.gravity.setZero();
  for (int i = 0; i < count; ++i) {
    const int column = i % 4, level = i / 4;
    const Linear<M> place = apart * column * Linear<M>::Unit(0) + (0.5 + 1.01 * level) * Linear<M>::Unit(1);
    const int body = scene.add_body(place, ball<M>(1 + i % 2, 0.5), (i % 2 ? -0.5 : 1.0) * Velocity<M>::Unit(0));
    scene.set_shape(body, Ball<M>{0.5}, {0.3, i % 3 ? 0.0 : 0.8});
  }
  return uncatalogued("balls", scene);
}

/// Ragdolls that fall onto the ground, or lie there.
Problem ragdolls(int count, double height) {
  Scene<PlaneBody> scene;
  add_ground(scene);
  for (int i = 0; i < count; ++i) add_ragdoll(scene, {2.0 * i, 0.9 + height});
  return uncatalogued("ragdolls", scene);
}

/// A chain of boxes that falls onto the ground, whose first joint may be driven.
template <class M>
Problem fallen_chain(int links, double height, bool driven) {
  Scene<M> scene;
  add_ground(scene);
  for (int i = 1; i <= links; ++i) {
    Pose<M> pose;
    pose.position = 1.1 * i * Linear<M>::Unit(0) + (0.2 + height) * Linear<M>::Unit(1);
    Linear<M> sides = Linear<M>::Constant(0.4);
    sides[0] = 1;
    add_box(scene, pose, 1 + i % 2, sides);
    if (i > 1) scene.add(pin<M>(scene.bodies(), i - 1, i, Linear<M>(pose.position - 0.55 * Linear<M>::Unit(0))));
  }
  if (driven && links > 1) scene.add(motor(turn_of(scene, 2), 2, 50));
  return uncatalogued("chain on the ground", scene);
}

/// Bodies that nothing holds, in air.
template <class M>
Problem thrown(int count) {
  Scene<M> scene;
  for (int i = 0; i < count; ++i) {
    Velocity<M> V = Velocity<M>::Constant(0.5 + 0.1 * i);
    InverseMass<M> mass;
    if constexpr (M::angular == 0)
      mass = with_mass<M>(1);
    else
      mass = box<M>(1, Linear<M>::LinSpaced(0.2, 0.5));
    scene.set_damping(scene.add_body(3.0 * i * Linear<M>::Unit(0), mass, V), 0.2, M::angular ? 0.1 : 0.0);
  }
  return uncatalogued("thrown bodies", scene);
}

template <class M>
Problem drawn_net(Draws& draws) {
  const int width = draws.one_of({2, 3, 5}), height = draws.one_of({2, 3, 5, 8});
  const auto kind = draws.below(4);
  return net<M>(width, height, kind % 2 == 1 ? Ties::springs : Ties::rods, kind >= 2);
}
template <class M>
Problem drawn_mixed_net(Draws& draws) {
  const int width = draws.one_of({2, 3, 5}), height = draws.one_of({2, 3, 5, 8});
  return net<M>(width, height, draws.one_of({Ties::rods_of_both_kinds, Ties::rods_and_springs}), draws.below(2));
}

Problem drawn_problem(Draws& draws) {
  const std::string model = bob_models[draws.below(6)];
  const double links = draws.one_of({1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0});
  const double kick = draws.one_of({0.0, 0.02, 0.02});
  const int few = draws.one_of({1, 2, 3, 5, 10, 20});
  switch (draws.below(33)) {
    case 0: return Problem("stack", {{"boxes", draws.one_of({2.0, 3.0, 5.0, 8.0, 12.0, 30.0})}, {"kick", kick}});
    case 1: return Problem("pyramid", {{"base", draws.one_of({2.0, 3.0, 4.0, 6.0, 9.0, 12.0})}, {"kick", kick}});
    case 2: return Problem(draws.one_of({"incline", "four_bar"}));
    case 3: return Problem(draws.one_of({"top", "spherical_pendulum", "conical_pendulum"}));
    case 4: return Problem("pendulum", {}, bob_models[draws.one_of<std::size_t>({0, 1, 3, 4})]);
    case 5: return Problem("compound_pendulum", {}, bob_models[draws.one_of<std::size_t>({2, 5})]);
    case 6: return falling<PlaneBody>(draws.one_of({3, 6, 12, 24}));
    case 7: return falling<SpaceBody>(draws.one_of({1, 2, 4, 6}));
    case 8: return kicked(stack<SpaceBody>(draws.one_of({1, 2, 3, 5})));
    case 9: return kicked(pyramid<SpaceBody>(draws.one_of({2, 3})));
    case 10: return ropes<PlaneParticle>(few);
    case 11: return ropes<SpaceParticle>(few);
    case 12: return machine<PlaneBody>(few, draws.between(1, 1e4));
    case 13: return machine<SpaceBody>(few, draws.between(1, 1e4));
    case 14: return uncatalogued("slider crank", slider_crank({.strength = draws.between(10, 1e6)}));
    case 15:
      switch (draws.below(4)) {
        case 0: return thrown<PlaneParticle>(few);
        case 1: return thrown<SpaceParticle>(few);
        case 2: return thrown<PlaneBody>(few);
        default: return thrown<SpaceBody>(few);
      }
    case 16: return balls<PlaneBody>(few, draws.below(2), draws.one_of({1.0, 1.2, 5.0}));
    case 17: return balls<SpaceBody>(few, draws.below(2), draws.one_of({1.0, 1.2, 5.0}));
    case 18: return ragdolls(draws.one_of({1, 1, 2, 5}), draws.one_of({0.02, 0.5}));
    case 19: return fallen_chain<PlaneBody>(draws.one_of({2, 3, 5, 10}), draws.one_of({0.0, 0.1}), draws.below(2));
    case 20: return fallen_chain<SpaceBody>(draws.one_of({2, 3, 5}), draws.one_of({0.0, 0.1}), draws.below(2));
    case 21: return hinged(few, draws.below(2));
    case 22: return mixed<PlaneBody>(few, draws.below(2));
    case 23: return mixed<SpaceBody>(few, draws.below(2));
    case 24: return drawn_net<PlaneParticle>(draws);
    case 25: return drawn_net<SpaceParticle>(draws);
    case 26: return drawn_mixed_net<PlaneParticle>(draws);
    case 27: return drawn_mixed_net<SpaceParticle>(draws);
    case 28: return drawn_arm(few, draws);
    default: return Problem("chain", {{"links", links}}, model);
  }
}

Knobs drawn_knobs(const Family& family, Draws& draws) {
  Knobs knobs{.substeps = draws.one_of({1, 1, 2, 3, 4, 8, 14})};
  if (!family.pass.empty()) knobs.passes = draws.one_of({1, 2, 4, 8, 20});
  if (family.pass == "digit") knobs.passes = std::min(knobs.passes, 6);
  knobs = with_cure(knobs, family.cures[draws.below(family.cures.size())]);
  if (knobs.cure == Cure::projection)
    knobs.strength = draws.one_of({1, 2, 4, 8, 16});
  else if (knobs.cure != Cure::none)
    knobs.strength = draws.between(0.02, 0.9);
  if (family.most_relaxation > 1) knobs.relaxation = draws.one_of({1.0, 1.3, 1.7});
  if (family.name == "Jacobi") knobs.relaxation = 0.4;
  if (family.name.ends_with("to a tolerance") && !family.solves_rows) knobs.strength = draws.between(1e-3, 1e-1);
  return knobs;
}

/// Prints a setting, its kind of rows and what ten frames of it counted; callgrind writes their instructions. Not
/// of one that fails: its cost does not count, and numbers without end take any time.
void run(const Problem& problem, const Family& family, Knobs knobs) {
  AnyScene scene = problem.start();
  if (family.name == "direct" &&
      (scene.row_kind() == "boxes in space" || scene.row_kind() == "joined shapes in space"))
    knobs.regularisation = 1e-9;  // four points of a face repeat each other
  const Setting setting = family.setting(knobs);
  if (measure(problem, family, knobs, {.seconds = 20 * frame, .reference = false}).outcome != Outcome::good)
    return;
  scene.use(setting.method);
  const auto frames = [&](int count) {
    for (int i = 0; i < count * setting.steps; ++i) scene.step(frame / setting.steps);
  };
  frames(10);
  const Counts first = counts_of(scene.effort());
  CALLGRIND_ZERO_STATS;
  frames(10);
  CALLGRIND_DUMP_STATS;
  const Counts last = counts_of(scene.effort());
  fmt::print("{};{};{};{} of {}{}", scene.row_kind(), family.name, name_of(knobs.cure), problem.scene().name,
             scene.rows(), described_knobs(family, knobs));
  for (std::size_t k = 0; k < counts; ++k) fmt::print(";{}", last[k] - first[k]);
  fmt::print("\n");
}

/// Of any method and kind of rows, or of one method or one kind alone.
void run(int count, unsigned seed, std::string_view only) {
  Draws draws(seed);
  const auto method =
      std::find_if(priced().begin(), priced().end(), [&](const Family& one) { return one.name == only; });
  const bool any = only.empty() || method != priced().end();
  for (int i = 0; i < count; ++i) {
    const Problem problem = drawn_problem(draws);
    const Family& family = method != priced().end() ? *method : priced()[draws.below(priced().size())];
    const Knobs knobs = drawn_knobs(family, draws);
    if (any || problem.start().row_kind() == only) run(problem, family, knobs);
  }
}

struct Counted {
  std::string kind, family, cure, what;
  Counts counts;
  double instructions;
};

std::vector<Counted> read(const char* efforts, int count, char** dumps) {
  std::vector<double> instructions;
  for (int i = 0; i < count; ++i) {
    std::ifstream dump(dumps[i]);
    double total = 0, part = 0;
    for (std::string word; dump >> word;) {
      if (word == "part:") dump >> part;
      if (word == "totals:" || word == "summary:") dump >> total;
    }
    if (static_cast<std::size_t>(part) > instructions.size()) instructions.resize(static_cast<std::size_t>(part));
    if (part > 0) instructions[static_cast<std::size_t>(part) - 1] = total;
  }
  std::vector<Counted> all;
  std::ifstream lines(efforts);
  for (std::string line; std::getline(lines, line) && all.size() < instructions.size();) {
    std::istringstream fields(line);
    std::string field;
    const auto next = [&] { return std::getline(fields, field, ';'), field; };
    Counted one;
    one.kind = next(), one.family = next(), one.cure = next(), one.what = next();
    for (double& number : one.counts) number = std::stod(next());
    one.instructions = instructions[all.size()];
    all.push_back(one);
  }
  return all;
}

/// The prices of one kind of rows: each in turn the best while the others stay, until they do.
void fit(const std::string& kind, const std::vector<Counted>& all) {
  std::map<std::string, Counts> prices;
  std::vector<const Counted*> runs;
  std::vector<double> rest;  // of each run, the share that is not paid for yet
  const auto parts_of = [](const Counted& one) {
    return priced(one.family).solves_rows ? std::vector<std::string>{one.family, "stepping", one.cure}
                                          : std::vector<std::string>{one.family};
  };
  std::map<std::string, std::vector<std::size_t>> users;
  for (const Counted& one : all)
    if (one.kind == kind) {
      for (const std::string& part : parts_of(one)) users[part].push_back(runs.size()), prices[part] = {};
      runs.push_back(&one), rest.push_back(1);
    }
  for (int round = 0; round < 4000; ++round)
    for (auto& [part, own] : prices) {
      const Family& user = priced(runs[users[part].front()]->family);
      const auto paid = paid_by(part, user.solves_rows);
      for (std::size_t k = 0; k < counts; ++k) {
        if (!paid[k]) continue;
        double product = 0, square = 0;
        for (const std::size_t i : users[part]) {
          const double share = runs[i]->counts[k] / runs[i]->instructions;
          product += (rest[i] + own[k] * share) * share, square += share * share;
        }
        const double best = square > 0 ? std::max(0.0, product / square) : 0;
        for (const std::size_t i : users[part])
          rest[i] -= (best - own[k]) * runs[i]->counts[k] / runs[i]->instructions;
        own[k] = best;
      }
    }
  for (const auto& [part, own] : prices) {
    double worst = 0;
    for (const std::size_t i : users[part]) worst = std::max(worst, std::abs(rest[i]));
    fmt::print("{{\"{}\", \"{}\", {{", kind, part);
    for (std::size_t k = 0; k < counts; ++k) fmt::print("{}{:.4g}", k ? ", " : "", own[k]);
    fmt::print("}}}},\n");
    std::cerr << fmt::format("{:>15} {:<32} {:4} runs, within {:.0f} %\n", kind, part, users[part].size(),
                             100 * worst);
  }
}

int check(const std::vector<Counted>& all) {
  int good = 0, bad = 0;
  for (const Counted& one : all) {
    const Prices prices = prices_of(one.kind, priced(one.family), cure_named(one.cure));
    const double off = cost_of(one.counts, prices) / one.instructions - 1;
    good += std::abs(off) <= 0.15, bad += std::abs(off) > 0.3;
    if (std::abs(off) > 0.15) fmt::print("{:+4.0f} %  {}: {}\n", 100 * off, one.family, one.what);
  }
  const auto judged = static_cast<double>(all.size()), share = good / judged;
  fmt::print("{} settings: {:.1f} % counted within 15 %, {} beyond 30 %\n", all.size(), 100 * share, bad);
  return share >= 0.9 && 100 * bad <= judged ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "run" && (argc == 4 || argc == 5))
    return run(std::stoi(argv[2]), static_cast<unsigned>(std::stoul(argv[3])), argc == 5 ? argv[4] : ""), 0;
  if (argc < 4)
    return std::cerr << "prices run COUNT SEED, prices fit COUNTED DUMPS, prices check COUNTED DUMPS\n", 2;
  const auto all = read(argv[2], argc - 3, argv + 3);
  if (command == "check") return check(all);
  std::set<std::string> kinds;
  for (const Counted& one : all) kinds.insert(one.kind);
  for (const std::string& kind : kinds) fit(kind, all);
  return 0;
}
