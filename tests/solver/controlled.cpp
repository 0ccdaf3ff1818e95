#include "lessons/methods/controlled.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/double_pendulum.hpp"
#include "lessons/exact/free_top.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/exact/spherical_pendulum.hpp"
#include "lessons/exact/swinging_chain.hpp"
#include "lessons/scenes/circle.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "tests/solver/equalities.hpp"
#include "tests/solver/random.hpp"

namespace controlled_test {

using namespace byhand;
constexpr double pi = std::numbers::pi, g = 9.81, time = 2, between = 0.5;  // looked at
constexpr int looks = 4;

using Places = std::vector<Eigen::Vector3d>;  // of the bodies that move

template <class M>
Places places_of(const Scene<M>& scene) {
  Places places;
  for (int i = 0; i < scene.bodies().size(); ++i) {
    if (!moves(scene.bodies().inverse_mass[i])) continue;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    place.head<M::linear>() = scene.bodies().pose[i].position;
    places.push_back(place);
  }
  return places;
}
double farthest(const Places& one, const Places& other) {
  double most = 0;
  for (std::size_t i = 0; i < one.size(); ++i) most = std::max(most, (one[i] - other[i]).norm());
  return most;
}

/// The places at each look.
template <class M, class Method>
std::vector<Places> path_of(Simulation<M, Method>& simulation) {
  std::vector<Places> path;
  for (int i = 0; i < looks; ++i) {
    simulation.step(between);
    path.push_back(places_of(simulation.scene));
  }
  return path;
}
double farthest(const std::vector<Places>& one, const std::vector<Places>& other) {
  double most = 0;
  for (int i = 0; i < looks; ++i) most = std::max(most, farthest(one[i], other[i]));
  return most;
}

/// A scene, and where it is at each look by an answer that knows no constraints.
template <class M>
struct Known {
  Scene<M> scene;
  std::vector<Places> path;
};
template <class M, class F>
Known<M> known(const Scene<M>& scene, F&& places_at) {
  std::vector<Places> path;
  for (int i = 1; i <= looks; ++i) path.push_back(places_at(i * between));
  return {scene, path};
}

Eigen::Vector3d in_plane(double angle) { return {std::sin(angle), -std::cos(angle), 0}; }

Known<PlaneParticle> simple() {
  const SimplePendulum exact(2, 1, g);
  return known(pendulum<PlaneParticle>(2, 1, 1), [&](double t) { return Places{in_plane(exact.angle(t))}; });
}
Known<PlaneParticle> twofold() {
  const DoublePendulum exact({{pi / 2, pi / 2}, {0, 0}}, {1, 1}, {1, 1}, g);
  return known(rod_chain<PlaneParticle, NormalisedDistance>({.links = 2, .angle = pi / 2}), [&](double t) {
    const auto angles = exact.at(t).angles;
    return Places{in_plane(angles[0]), in_plane(angles[0]) + in_plane(angles[1])};
  });
}
Known<PlaneBody> heavy_chain() {
  std::vector<SwingingChain::Link> links(10, {1, 0.5, 1, 1.01 / 12});
  links.back().mass = 1000, links.back().inertia = 1010.0 / 12;
  const SwingingChain exact(links, pi / 2, g);
  return known(pinned_chain<PlaneBody>({.links = 10, .end_mass = 1000, .angle = pi / 2}), [&](double t) {
    Places places;
    for (const auto& at : exact.at(t).positions) places.push_back({at.x(), at.y(), 0});
    return places;
  });
}
Known<SpaceParticle> spherical() {
  const SphericalPendulum exact(1, 3, 1, g);
  auto scene = pendulum<SpaceParticle>(1, 1, 1);
  scene.state().velocity[1] = {0, 0, -3 * std::sin(1.0)};
  return known(scene, [&](double t) {
    const auto at = exact.at(t);
    const double r = std::sin(at.angle);
    return Places{{r * std::cos(at.azimuth), -std::cos(at.angle), -r * std::sin(at.azimuth)}};
  });
}
Known<SpaceBody> top() {
  const HeavyTop top{.mass = 2, .arm = 0.3, .moment_along = 0.08, .moment_across = 0.25, .spin = 40};
  const double lean = 0.7, rate = top.precession(lean)[0];
  return known(spinning_top(top, lean, rate), [=](double t) {
    const double r = top.arm * std::sin(lean);
    return Places{{r * std::cos(rate * t), top.arm * std::cos(lean), -r * std::sin(rate * t)}};
  });
}

struct Cost {
  double error = 0;  // [m]
  long long row_solves = 0;
};
template <class M, class Method>
Cost cost_of(const Known<M>& known, const Method& method) {
  Simulation<M, Method> simulation{known.scene, method};
  const double error = farthest(path_of(simulation), known.path);
  return {error, simulation.work.row_solves};
}

/// What the largest of some small displacements has grown to, at most: they are allowed by the constraints.
template <class M>
double amplification(const Scene<M>& scene) {
  Random random;
  const Generalised fine{.substeps = 2000};
  Simulation<M, Generalised> simulation{scene, fine};
  const std::vector<Places> path = path_of(simulation);
  double most = 1;
  for (int draw = 0; draw < 3; ++draw) {
    Simulation<M, Rattle> away{scene};
    away.scene.gravity.setZero();
    for (int i = 0; i < scene.bodies().size(); ++i)
      if (moves(scene.bodies().inverse_mass[i])) away.scene.state().velocity[i] = random.velocity<M>();
    away.step(1e-7);
    simulation = {scene, fine};
    simulation.scene.state().pose = away.scene.bodies().pose;
    const double start = farthest(places_of(away.scene), places_of(scene));
    most = std::max(most, farthest(path_of(simulation), path) / start);
  }
  return most;
}

/// The slope of the line through points on logarithmic axes with the least squares.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// The error follows the tolerance, and is at most ten times tolerance × time × amplification.
template <class Method, class M>
void expect_error_follows(const char* name, const Known<M>& known, double largest, double smallest) {
  const double grows = amplification(known.scene);
  std::vector<double> tolerances, errors;
  for (double tolerance = largest; tolerance > 0.5 * smallest; tolerance /= 10) {
    tolerances.push_back(tolerance);
    errors.push_back(cost_of(known, Controlled<Method>{tolerance, 1'000'000}).error);
    EXPECT_LE(errors.back(), 10 * tolerance * time * grows) << name << ", " << tolerance;
  }
  EXPECT_NEAR(slope(tolerances, errors), 1, 0.1) << name;
}

/// What a fixed substep costs at the same error, between two numbers of substeps in the ratio of √2.
template <class Method, class M>
double fixed_cost(const Known<M>& known, double error) {
  Cost last{INFINITY, 0};
  for (double count = 2; count < 1e6; count *= std::numbers::sqrt2) {
    Method method;
    method.substeps = static_cast<int>(count);
    Cost now;
    try {
      now = cost_of(known, method);
    } catch (const std::runtime_error&) {
      continue;
    }
    if (now.error < error)
      return last.row_solves * std::pow(static_cast<double>(now.row_solves) / last.row_solves,
                                        std::log(last.error / error) / std::log(last.error / now.error));
    last = now;
  }
  return NAN;
}
template <class Method, class M>
void expect_cheap(const char* name, const Known<M>& known, std::initializer_list<double> tolerances) {
  for (const double tolerance : tolerances) {
    const Cost own = cost_of(known, Controlled<Method>{tolerance});
    EXPECT_LE(own.row_solves, 1.3 * fixed_cost<Method>(known, own.error)) << name << ", " << tolerance;
  }
}

TEST(Controlled, RattlesErrorFollowsTheTolerance) {
  expect_error_follows<Rattle>("pendulum", simple(), 1e-3, 1e-7);
  expect_error_follows<Rattle>("double pendulum", twofold(), 1e-3, 1e-7);
  expect_error_follows<Rattle>("chain with a heavy end", heavy_chain(), 1e-3, 1e-5);
  expect_error_follows<Rattle>("spherical pendulum", spherical(), 1e-3, 1e-7);
  expect_error_follows<Rattle>("top", top(), 1e-3, 1e-7);
}
TEST(Controlled, TheErrorInGeneralisedCoordinatesFollowsTheTolerance) {
  expect_error_follows<Generalised>("pendulum", simple(), 1e-3, 1e-9);
  expect_error_follows<Generalised>("double pendulum", twofold(), 1e-3, 1e-9);
  expect_error_follows<Generalised>("chain with a heavy end", heavy_chain(), 1e-3, 1e-8);
  expect_error_follows<Generalised>("spherical pendulum", spherical(), 1e-3, 1e-9);
  expect_error_follows<Generalised>("top", top(), 1e-3, 1e-9);
}

// No constraint holds it, and gravity does not pull: all of the error is of its own turning.
TEST(Controlled, TumblesABookToTheTolerance) {
  const Eigen::Vector3d moments(1, 2, 2.8), spin(0.1, 5, 0.1);
  const Eigen::Vector3d exact = FreeTop(moments, spin).at(time).value;
  const auto follows = [&](auto method, double largest) {
    std::vector<double> tolerances, errors;
    for (int i = 0; i < 5; ++i) {
      method.tolerance = largest * std::pow(10, -i);
      Simulation simulation{free_top(moments, spin), method};
      simulation.step(time);
      const Bodies<SpaceBody>& bodies = simulation.scene.bodies();
      tolerances.push_back(method.tolerance);
      errors.push_back(
          (rotate(inverse(bodies.pose[0].rotation), Eigen::Vector3d(bodies.velocity[0].tail<3>())) - exact)
              .norm());
    }
    EXPECT_GT(slope(tolerances, errors), 0.9);  // Fehlberg's errors nearly cancel here: 1.16
  };
  follows(Controlled<Rattle>(), 1e-2);
  follows(Controlled<Generalised>(), 1e-4);
}

TEST(Controlled, RattleCostsLittleMoreThanItsBestFixedSubstep) {
  expect_cheap<Rattle>("pendulum", simple(), {1e-3, 1e-4, 1e-5});
  expect_cheap<Rattle>("double pendulum", twofold(), {1e-3, 1e-4, 1e-5});
  expect_cheap<Rattle>("chain with a heavy end", heavy_chain(), {1e-3});
  expect_cheap<Rattle>("spherical pendulum", spherical(), {1e-3, 1e-4, 1e-5});
  expect_cheap<Rattle>("top", top(), {1e-3, 1e-4, 1e-5});
}
// With fewer substeps, thirty in all, the search for the first one and what frames cut off weigh more.
TEST(Controlled, GeneralisedCoordinatesCostLittleMoreThanTheirBestFixedSubstep) {
  expect_cheap<Generalised>("pendulum", simple(), {1e-5, 1e-6, 1e-7, 1e-8});
  expect_cheap<Generalised>("double pendulum", twofold(), {1e-4, 1e-5, 1e-6, 1e-7, 1e-8});
  expect_cheap<Generalised>("chain with a heavy end", heavy_chain(), {1e-4, 1e-5, 1e-6, 1e-7});
  expect_cheap<Generalised>("spherical pendulum", spherical(), {1e-5, 1e-6, 1e-7, 1e-8});
  expect_cheap<Generalised>("top", top(), {1e-4, 1e-5, 1e-6, 1e-7, 1e-8});
}

TEST(Controlled, RunsWhereFixedSubstepsAreRefused) {
  const Known<PlaneBody> chain = heavy_chain();
  Simulation fixed_step{chain.scene, Rattle{.substeps = 4}};
  EXPECT_THROW(run(fixed_step, time, 1.0 / 60), NoConvergence);
  Simulation controlled{chain.scene, Controlled<Rattle>{1e-2}};
  run(controlled, time, 1.0 / 60);
  EXPECT_LT(farthest(places_of(controlled.scene), chain.path.back()), 1e-2 * time);
}

// With a tolerance that allows longer substeps than stability does, the controller stays at the limit of
// stability.
TEST(Controlled, RarelyTakesASubstepBackWhereStabilityLimitsIt) {
  Simulation simulation{heavy_chain().scene, Controlled<Generalised>{1e-3}};
  int tried = 0, rejected = 0;
  run(simulation, time, between, [&] { tried += simulation.work.tried, rejected += simulation.work.rejected; });
  EXPECT_LT(rejected, 0.03 * tried);
}

/// A run that begins with `substep` [s].
template <class Method, class M>
Simulation<M, Controlled<Method>> begun_with(double substep, const Scene<M>& scene, double tolerance,
                                             double step) {
  Simulation<M, Controlled<Method>> simulation{scene, {tolerance}};
  simulation.work.next = substep;
  simulation.step(step);
  return simulation;
}
/// A substep that is far too long is taken back, and all goes on as if a fifth of it had come first.
template <class Method, class M>
void expect_taken_back_wholly(const Scene<M>& scene, double tolerance) {
  const double step = 0.5;
  const auto longer = begun_with<Method>(step, scene, tolerance, step),
             shorter = begun_with<Method>(0.2 * step, scene, tolerance, step);
  EXPECT_GT(shorter.work.rejected, 0);
  EXPECT_EQ(longer.work.rejected, shorter.work.rejected + 1);
  EXPECT_EQ(longer.work.tried, shorter.work.tried + 1);
  EXPECT_EQ(longer.work.next, shorter.work.next);
  EXPECT_EQ(longer.scene.bodies().velocity, shorter.scene.bodies().velocity);
  EXPECT_EQ(places_of(longer.scene), places_of(shorter.scene));
  EXPECT_EQ(longer.work.system.lambda, shorter.work.system.lambda);
  EXPECT_GT(longer.work.row_solves, shorter.work.row_solves) << "what is taken back is paid for";
}
TEST(Controlled, ASubstepThatIsTakenBackLeavesNothing) {
  const auto circle = particle_on_a_circle<PlaneParticle, Distance>(2, 50, 3);
  expect_taken_back_wholly<Rattle>(circle, 1e-2);
  expect_taken_back_wholly<Rattle>(top().scene, 1e-5);
  expect_taken_back_wholly<Generalised>(twofold().scene, 1e-9);
  expect_taken_back_wholly<Generalised>(top().scene, 1e-9);
}

TEST(Controlled, TellsTheForceOfItsLastSubstep) {
  Simulation simulation{particle_on_a_circle<PlaneParticle>(2, 5, 3), Controlled<Rattle>{1e-4}};
  run(simulation, 1, 1.0 / 60);
  EXPECT_NEAR(force(simulation.work, 0), -3 * 5.0 * 5.0 / 2, 1e-2);
}

TEST(Controlled, KeepsItsSubstepBetweenFrames) {
  const auto keeps = [](auto method, double tolerance) {
    method.tolerance = tolerance;
    Simulation simulation{twofold().scene, method};
    simulation.step(1.0 / 60);
    const int first = simulation.work.tried;
    simulation.step(1.0 / 60);
    EXPECT_LE(simulation.work.tried, first);
    EXPECT_EQ(simulation.work.rejected, 0);
  };
  keeps(Controlled<Rattle>(), 1e-4);
  keeps(Controlled<Generalised>(), 1e-9);
}

// However small its error.
TEST(Controlled, ASubstepGrowsAtMostFivefold) {
  Simulation simulation{twofold().scene, Controlled<Rattle>{1}};
  simulation.work.next = 1e-9;
  simulation.step(1e-9);
  EXPECT_NEAR(simulation.work.next, 5e-9, 1e-15);
}

// What a start is off by is no error of a step, and no step is short enough to take it away.
TEST(Controlled, ClosesAGapAtTheStart) {
  auto scene = pendulum<PlaneParticle>(1, 2, 3);
  scene.state().pose[1].position *= 1.05;
  scene.state().velocity[1] = {1, 2};
  const auto closes = [&](const auto& method) {
    Simulation simulation{scene, method};
    simulation.step(1.0 / 60);
    EXPECT_LT(position_error(simulation.scene).max, 1e-14);
    EXPECT_LT(simulation.work.tried, 100);
  };
  closes(Controlled<Rattle>{1e-4});
  closes(Controlled<Generalised>{1e-4});
}

TEST(Controlled, LeavesRestAtRest) {
  const auto rests = [](const auto& method) {
    Simulation simulation{pendulum<PlaneParticle>(0, 1, 1), method};
    int tried = 0;
    run(simulation, 1, 1.0 / 60, [&] { tried += simulation.work.tried; });
    EXPECT_EQ(simulation.scene.bodies().pose[1].position, Eigen::Vector2d(0, -1));
    EXPECT_LE(tried, 62) << "one a frame, after a short one at the start";
  };
  rests(Controlled<Rattle>());
  rests(Controlled<Generalised>());
}

TEST(Controlled, DoesTheSameAtAnyLength) {
  const auto same = [](auto method) {
    const auto of = [=](double length) {
      auto longer = method;
      longer.tolerance *= length;
      return longer;
    };
    expect_same_at_any_length(
        [](double a) { return rod_chain<PlaneParticle>({.links = 3, .length = a, .angle = 1}); }, of);
    expect_same_at_any_length(
        [](double a) { return pinned_chain<SpaceBody>({.links = 3, .length = a, .angle = 1}); }, of);
  };
  same(Controlled<Rattle>());
  same(Controlled<Generalised>{1e-8});
}

TEST(Controlled, RefusesWhatItCannotRun) {
  const auto refuses = [](auto method) {
    expect_refusals(method);
    for (const double tolerance : {0.0, -1e-3, std::nan(""), static_cast<double>(INFINITY)}) {
      method.tolerance = tolerance;
      expect_invalid(method,
                     "tolerance is " + text_of(tolerance) + ", but it must be a positive finite number [m/s]");
    }
    method = {.most_substeps = 0};
    expect_invalid(method, "largest number of substeps is 0, but it must be at least 1");
  };
  refuses(Controlled<Rattle>());
  refuses(Controlled<Generalised>());
}

TEST(Controlled, SaysThatAToleranceTakesTooManySubsteps) {
  const auto words = [](const char* tolerance, int most) {
    return std::string("a tolerance of ") + tolerance + " m/s cannot be kept with " + std::to_string(most) +
           " substeps in a step of 0.5 s; allow a larger error or more substeps";
  };
  const auto scene = twofold().scene;
  expect_thrown<NoConvergence>(scene, Controlled<Rattle>{1e-6, 50}, 0.5, words("1e-06", 50));
  expect_thrown<NoConvergence>(scene, Controlled<Generalised>{1e-12, 50}, 0.5, words("1e-12", 50));
  // Below rounding no substep is short enough, and few are tried.
  expect_thrown<NoConvergence>(scene, Controlled<Rattle>{1e-30}, 0.5, words("1e-30", 100'000));
  expect_thrown<NoConvergence>(scene, Controlled<Generalised>{1e-30}, 0.5, words("1e-30", 100'000));
}

// x = v₀(1 - exp(-ct))/c.
TEST(Controlled, GeneralisedCoordinatesFollowADampingThatRattleRefuses) {
  const double speed = 5, span = 0.5;
  for (const double rate : {0.1, 10.0, 1000.0})
    for (const double tolerance : {1e-4, 1e-6}) {
      Scene<PlaneParticle> scene;
      scene.gravity.setZero();
      scene.add_body(Eigen::Vector2d(0, 0), with_mass<PlaneParticle>(2), {speed, 0});
      scene.set_damping(0, rate, 0);
      Simulation simulation{scene, Controlled<Generalised>{tolerance}};
      simulation.step(span);
      EXPECT_NEAR(simulation.scene.bodies().pose[0].position.x(), -speed * std::expm1(-rate * span) / rate,
                  tolerance * span)
          << rate << ", " << tolerance;
      expect_thrown<std::invalid_argument>(
          scene, Controlled<Rattle>{tolerance}, span,
          "RATTLE keeps no tolerance where bodies are damped, and body 0 is; take generalised coordinates");
    }
}

}  // namespace controlled_test
