#include <gtest/gtest.h>

#include "solver/constraints/hinge.hpp"
#include "solver/constraints/motor.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Rows that cannot all be met: what their correction makes of the bodies stays in proportion to what the rows ask,
// at any length, mass and step, and the step does not say that it has converged.
namespace law_rows_unmet_test {

using namespace byhand;

struct Scale {
  double length = 1, mass = 1, time = 1;
};

/// The largest speed in the last half of 1,200 steps, the sum of the speeds that its rods ask for one by one at
/// their largest, (β/h)|C|/|J| on the lighter body, and the steps that did not converge.
struct Seen {
  double fastest = 0, asked = 0;
  int unconverged = 0;
};

template <class M>
struct Rods {
  Scene<M> scene = {};
  std::vector<Handle<Distance<M>>> rods = {};

  void join(int from, int to, double length) { rods.push_back(scene.add(Distance<M>{{from, to}, length})); }
};

template <class M>
Linear<M> point(double x, double y) {
  return x * Linear<M>::Unit(0) + y * Linear<M>::Unit(1);
}

template <class M>
Seen watch(const Rods<M>& at_rest, double h, auto&& before_step) {
  Simulation<M> simulation{at_rest.scene};
  Seen seen;
  for (int i = 0; i < 1200; ++i) {
    before_step(simulation.scene, i);
    double asked = 0;
    for (const auto& handle : at_rest.rods) {
      const Distance<M>& rod = simulation.scene.get(handle);
      const auto& pose = simulation.scene.bodies().pose;
      const double d = (pose[rod.at.body2].position - pose[rod.at.body1].position).norm();
      asked += 0.2 / h * std::abs(d * d - rod.length * rod.length) / (2 * d);
    }
    simulation.step(h);
    if (i < 600) continue;
    seen.unconverged += !simulation.work.solution.converged;
    seen.asked = std::max(seen.asked, asked);
    for (const auto& V : simulation.scene.bodies().velocity) seen.fastest = std::max(seen.fastest, V.norm());
  }
  return seen;
}

/// Three rods between anchors that are drawn apart for 300 steps.
template <class M>
Seen pulled_apart(double span, const Scale& scale = {}) {
  Rods<M> chain;
  chain.scene.gravity *= scale.length / (scale.time * scale.time);
  const auto add = [&](double x, double y, const InverseMass<M>& mass) {
    return chain.scene.add_body(Linear<M>(scale.length * point<M>(x, y)), mass);
  };
  const int left = add(0, 0, fixed<M>()), right = add(2.5, 0, fixed<M>()),
            b = add(0.9, -0.3, with_mass<M>(scale.mass)), c = add(1.6, -0.3, with_mass<M>(scale.mass));
  chain.join(left, b, scale.length);
  chain.join(b, c, scale.length);
  chain.join(c, right, scale.length);
  return watch(chain, scale.time / 60, [&](Scene<M>& now, int i) {
    if (i < 300) now.set_position(right, scale.length * point<M>(2.5 + (span - 2.5) * i / 299, 0));
  });
}

template <class M>
Seen triangle_that_is_none(const Scale& scale = {}) {
  Rods<M> triangle;
  triangle.scene.gravity.setZero();
  for (const auto& position : {point<M>(0, 0), point<M>(1, 0), point<M>(0.4, 0.3)})
    triangle.scene.add_body(Linear<M>(scale.length * position), with_mass<M>(scale.mass));
  triangle.join(0, 1, scale.length);
  triangle.join(1, 2, 0.4 * scale.length);
  triangle.join(2, 0, 0.4 * scale.length);
  return watch(triangle, scale.time / 60, [](Scene<M>&, int) {});
}

template <class M>
class RowsThatCannotBeMet : public testing::Test {};
using Particles = testing::Types<PlaneParticle, SpaceParticle>;
TYPED_TEST_SUITE(RowsThatCannotBeMet, Particles);

// The limit is 2.5 times what the rods ask; what one step leaves, the next takes up. Gravity adds its gh.
TYPED_TEST(RowsThatCannotBeMet, ArePulledNoFasterThanTheyAsk) {
  using M = TypeParam;
  for (const double span : {3.003, 3.03, 3.3, 5.0}) {
    const Seen seen = pulled_apart<M>(span);
    EXPECT_LE(seen.fastest, 4 * seen.asked + 0.17) << span;
    EXPECT_GT(seen.unconverged, 0) << span;
  }
  EXPECT_LE(pulled_apart<M>(3.3).fastest, 1);
  const Seen triangle = triangle_that_is_none<M>();
  EXPECT_LE(triangle.fastest, 4 * triangle.asked);
  EXPECT_GT(triangle.unconverged, 500);
}

// On the other side of the boundary the rods can be met.
TYPED_TEST(RowsThatCannotBeMet, SlackRodsConverge) {
  for (const double span : {2.5, 2.9, 2.99}) {
    const Seen seen = pulled_apart<TypeParam>(span);
    EXPECT_EQ(seen.unconverged, 0) << span;
    EXPECT_LE(seen.fastest, 0.1) << span;
  }
}

TYPED_TEST(RowsThatCannotBeMet, DoTheSameAtAnyLengthMassAndStep) {
  using M = TypeParam;
  const Seen triangle = triangle_that_is_none<M>(), rods = pulled_apart<M>(3.03);
  for (const Scale scale :
       {Scale{.length = 1024}, Scale{.mass = 1.0 / 512}, Scale{.time = 1.0 / 16}, Scale{1.0 / 64, 32, 4}}) {
    const double speed = scale.length / scale.time;
    EXPECT_NEAR(triangle_that_is_none<M>(scale).fastest / speed, triangle.fastest, 1e-6 * triangle.fastest);
    EXPECT_NEAR(pulled_apart<M>(3.03, scale).fastest / speed, rods.fastest, 1e-3 * rods.fastest);
  }
}

// A heavy bob at the end of light ones makes the rows nearly dependent by mass alone: its correction is exact.
TYPED_TEST(RowsThatCannotBeMet, AHeavyBobIsCorrectedInFull) {
  using M = TypeParam;
  for (const double mass : {1.0, 100.0, 1e4}) {
    Scene<M> scene;
    scene.gravity.setZero();
    scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
    for (int i = 1; i <= 5; ++i) {
      scene.add_body(Linear<M>(1.01 * i * Linear<M>::Unit(0)), with_mass<M>(i == 5 ? mass : 1));
      scene.add(Distance<M>{{i - 1, i}, 1});
    }
    Simulation<M> simulation{scene};
    const double before = position_error(scene).max;
    simulation.step(1.0 / 60);
    EXPECT_TRUE(simulation.work.solution.converged);
    EXPECT_NEAR(position_error(simulation.scene).max, 0.8 * before, 1e-3 * before) << mass;
  }
}

// Two pins of one body at points that are apart, and two rods on a line that are too short together.
TYPED_TEST(RowsThatCannotBeMet, DoNotConvergeWhereTheyRepeat) {
  using M = TypeParam;
  for (const double apart : {1e-6, 1.0, 10.0}) {
    Scene<M> pinned, straight;
    for (Scene<M>* scene : {&pinned, &straight}) {
      for (const double x : {-apart / 2, apart / 2}) scene->add_body(point<M>(x, 0), fixed<M>());
      scene->add_body(point<M>(0, 0), with_mass<M>(1));
      scene->gravity.setZero();
    }
    for (const int anchor : {0, 1}) {
      pinned.add(pin<M>(pinned.bodies(), anchor, 2, pinned.bodies().pose[anchor].position));
      straight.add(NormalisedDistance<M>{{anchor, 2}, apart / 4});
    }
    for (const Scene<M>& scene : {pinned, straight}) {
      Simulation<M> simulation{scene};
      for (int i = 0; i < 60; ++i) {
        simulation.step(1.0 / 60);
        EXPECT_FALSE(simulation.work.solution.converged) << apart << ' ' << i;
      }
    }
  }
}

template <class M>
class RowsAgainstContacts : public testing::Test {};
using Bodies = testing::Types<PlaneBody, SpaceBody>;
TYPED_TEST_SUITE(RowsAgainstContacts, Bodies);

// A rod of this length from a point 3 m above the middle of a box on the ground: beyond 3 m it cannot be met.
template <class M>
Scene<M> rod_on_crate(double length, double friction, double scale = 1) {
  Scene<M> scene;
  scene.gravity *= scale;
  scene.set_margin(scale * scene.colliders().margin);
  scene.set_shape(scene.add_body(point<M>(0, 0), fixed<M>()), HalfSpace<M>{point<M>(0, 1)}, {friction});
  const int point_above = scene.add_body(point<M>(0, 3.5 * scale), fixed<M>());
  const Linear<M> sides = Linear<M>::Constant(scale);
  const int crate = scene.add_body(point<M>(0, 0.5 * scale), box<M>(1, sides));
  scene.set_shape(crate, Box<M>{sides}, {friction});
  scene.add(NormalisedDistance<M>{{point_above, crate}, scale * length});
  return scene;
}
template <class M>
Seen pressed(double length, double friction) {
  Simulation<M> simulation{rod_on_crate<M>(length, friction)};
  const int crate = 2;
  Seen seen;
  for (int i = 0; i < 600; ++i) {
    simulation.step(1.0 / 60);
    seen.unconverged += !simulation.work.solution.converged;
    const Velocity<M>& V = simulation.scene.bodies().velocity[crate];
    seen.fastest = std::max(seen.fastest, V.norm());
  }
  seen.asked = 0.2 * 60 * (length - 3);
  return seen;
}

// On the other side of the boundary: a motor can turn a bar that is pinned anywhere, at any strength from rest on,
// and the whole energy of the turn is its own. `arm` is from the bar's centre to its pin, on a body that stands
// elsewhere, and may stand at any angle.
TYPED_TEST(RowsAgainstContacts, DoNotSlowWhatAMotorTurns) {
  using M = TypeParam;
  for (const auto& [arm, angle] :
       {std::pair(0.0, 0.0), {0.25, 0.0}, {0.5, 0.8}, {2.0, 0.0}, {2.0, 2.3}, {5.0, 0.8}})
    for (const double strength : {20.0, 100.0, 1e4, 1e300}) {
      Scene<M> scene;
      scene.gravity.setZero();
      Linear<M> sides = Linear<M>::Constant(0.1);
      sides[0] = 1;
      const int ground = scene.add_body(point<M>(7, 3), fixed<M>()),
                bar = scene.add_body(point<M>(arm * std::cos(angle), arm * std::sin(angle)), box<M>(1, sides));
      if constexpr (M::linear == 2) {
        scene.add(pin<M>(scene.bodies(), ground, bar, point<M>(0, 0)));
        scene.add(motor<M>(turn(scene.bodies(), ground, bar), 2, strength));
      } else {
        scene.add(hinge<M>(scene.bodies(), ground, bar, point<M>(0, 0), Linear<M>::Unit(2)));
        scene.add(motor<M>(turn(scene.bodies(), ground, bar, Linear<M>::Unit(2)), 2, strength));
      }
      Simulation simulation{std::move(scene)};
      simulation.step(1.0 / 60);
      EXPECT_TRUE(simulation.work.solution.converged) << arm << ' ' << angle << ' ' << strength;
      // It is up to its speed at once, or after (I + mr²)ω = strength t.
      const double inertia = 1.01 / 12 + arm * arm;
      run(simulation, 2 * inertia / strength + 2.0 / 60, 1.0 / 60);
      EXPECT_NEAR(simulation.scene.bodies().velocity[bar][M::dof - 1], 2, 1e-6) << arm << ' ' << strength;
      EXPECT_TRUE(simulation.work.solution.converged) << arm << ' ' << strength;
    }
}

/// The largest speed of two pinned bars of 1 m between two fixed bodies 2 m apart, one of which moves away by
/// `distance` at `speed`.
template <class M>
double drawn_taut(double distance, double speed, double h) {
  Scene<M> scene;
  Linear<M> sides = Linear<M>::Constant(0.2);
  sides[0] = 1;
  const int left = scene.add_body(point<M>(0, 0), fixed<M>()), right = scene.add_body(point<M>(2, 0), fixed<M>()),
            a = scene.add_body(point<M>(0.5, 0), box<M>(1, sides)),
            b = scene.add_body(point<M>(1.5, 0), box<M>(1, sides));
  scene.add(pin<M>(scene.bodies(), left, a, point<M>(0, 0)));
  scene.add(pin<M>(scene.bodies(), a, b, point<M>(1, 0)));
  scene.add(pin<M>(scene.bodies(), b, right, point<M>(2, 0)));
  Simulation<M> simulation{std::move(scene)};
  double fastest = 0;
  for (int i = 0; i < static_cast<int>(10 / h); ++i) {
    const double left_to_go = 2 + distance - simulation.scene.bodies().pose[right].position.x();
    Velocity<M> V = Velocity<M>::Zero();
    if (left_to_go > 1e-12) V[0] = std::min(speed, left_to_go / h);
    simulation.scene.set_velocity(right, V);
    simulation.step(h);
    for (const int body : {a, b})
      fastest = std::max(fastest, simulation.scene.bodies().velocity[body].template head<M::linear>().norm());
  }
  return fastest;
}

// An exact solve of the pins answers .1 m/s with 117 m/s: straight bars can lengthen only by turning.
TYPED_TEST(RowsAgainstContacts, OfBarsThatAreDrawnTautThrowNothing) {
  for (const double distance : {0.001, 0.005, 0.02, 0.05, 0.2})
    for (const double speed : {0.01, 0.1, 0.5, 2.0})
      EXPECT_LE(drawn_taut<TypeParam>(distance, speed, 1.0 / 60), 2 + speed)
          << distance << " m at " << speed << " m/s";
  for (const double h : {1.0 / 240, 1.0 / 1000}) EXPECT_LE(drawn_taut<TypeParam>(0.05, 0.1, h), 2) << h;
}

TYPED_TEST(RowsAgainstContacts, ArePressedNoFasterThanTheyAsk) {
  for (const double length : {3.01, 3.05, 3.2, 4.0})
    for (const double friction : {0.0, 0.6}) {
      const Seen seen = pressed<TypeParam>(length, friction);
      EXPECT_LE(seen.fastest, 4 * seen.asked + 0.5) << length << ' ' << friction;
      EXPECT_GT(seen.unconverged, 0) << length << ' ' << friction;
    }
}

// The ground lets the box give way by nothing, so that the damping alone answers: λ = b/(.04/m), however small all
// is, and does not grow.
TYPED_TEST(RowsAgainstContacts, PressByWhatTheirDampingAllows) {
  for (const double scale : {1.0, 0x1p-12, 0x1p12})
    for (const double length : {3.05, 3.2, 4.0}) {
      Simulation<TypeParam> simulation{rod_on_crate<TypeParam>(length, 0.6, scale)};
      for (int i = 1; i <= 120; ++i) {
        simulation.step(1.0 / 60);
        if (i < 60) continue;
        EXPECT_NEAR(std::abs(simulation.impulse(0)[0]) / (25 * 0.2 * 60 * scale * (length - 3)), 1, 0.01) << i;
      }
    }
}

TYPED_TEST(RowsAgainstContacts, ConvergeWhereTheyCanBeMet) {
  for (const double length : {2.9, 3.0}) {
    const Seen seen = pressed<TypeParam>(length, 0.6);
    EXPECT_LE(seen.fastest, 2) << length;
    EXPECT_EQ(seen.unconverged, 0) << length;
  }
}

// Pinned bars of .1 to 10 kg that fall on the ground in any pose, as in a ragdoll. With pins off by centimetres
// they wedge; a step then made 40 J into 822.
template <class M>
Scene<M> pinned_bars(int count, double lightest, double heaviest, Random& random) {
  const Surface surface{.friction = 0.5, .restitution = 0.3};
  Scene<M> scene;
  scene.set_shape(scene.add_body(point<M>(0, 0), fixed<M>()), HalfSpace<M>{point<M>(0, 1)}, surface);
  Linear<M> sides = Linear<M>::Constant(0.1);
  sides[0] = 0.5;
  const double height = random.uniform(1, 2);
  for (int i = 1; i <= count; ++i) {
    const double mass = lightest * std::pow(heaviest / lightest, random.uniform(0, 1));
    const int bar = scene.add_body(point<M>(0.54 * i, height), box<M>(mass, sides),
                                   Velocity<M>(random.template vector<M::dof>(3)));
    scene.set_shape(bar, Box<M>{sides}, surface);
    if (i > 1) scene.add(pin<M>(scene.bodies(), bar - 1, bar, point<M>(0.54 * i - 0.27, height)));
  }
  return scene;
}

TYPED_TEST(RowsAgainstContacts, OfPinnedBarsThatWedgeMakeLittleEnergy) {
  using M = TypeParam;
  struct Bars {
    int count;
    double lightest, heaviest;
    int falls;
  };
  Random random;
  for (const Bars bars : {Bars{3, 1, 1, 600}, Bars{6, 0.1, 10, 300}})
    for (int fall = 0; fall < bars.falls / (M::linear == 3 ? 5 : 1); ++fall) {
      Simulation<M> simulation{pinned_bars<M>(bars.count, bars.lightest, bars.heaviest, random)};
      for (int i = 0; i < 150; ++i) {
        const double before = energy(simulation.scene), moving = kinetic_energy(simulation.scene.bodies());
        simulation.step(1.0 / 60);
        if (!simulation.work.solution.converged) continue;
        ASSERT_LE(energy(simulation.scene), before + moving + 1) << bars.count << ' ' << fall << ' ' << i;
      }
    }
}

// A fixed plate that comes at .2 m/s presses cubes against the ground or a wall. λ grew with each step until a
// contact ended, and with what was left cubes left at 1e7 m/s.
template <class M>
double pressed_by_a_plate(int cubes, double mass, int axis) {
  const auto at = [&](double along) { return axis == 1 ? point<M>(0, along) : point<M>(along, 0.5); };
  const Linear<M> sides = Linear<M>::Constant(1);
  Linear<M> flat = sides;
  flat[axis] = 0.2;
  Scene<M> scene;
  scene.set_shape(scene.add_body(point<M>(0, 0), fixed<M>()), HalfSpace<M>{point<M>(0, 1)});
  for (int i = 0; i < cubes; ++i)
    scene.set_shape(scene.add_body(at(0.5 + i), box<M>(i > 0 ? 1 : mass, sides)), Box<M>{sides});
  if (axis == 0) scene.set_shape(scene.add_body(at(-0.1), fixed<M>()), Box<M>{flat});
  const Velocity<M> coming = -0.2 * Velocity<M>::Unit(axis);
  scene.set_shape(scene.add_body(at(cubes + 0.3), fixed<M>(), coming), Box<M>{flat});
  Simulation<M> simulation{std::move(scene)};
  double fastest = 0;
  for (int i = 0; i < 300; ++i) {
    simulation.step(1.0 / 60);
    for (int body = 1; body <= cubes; ++body)
      fastest = std::max(fastest, simulation.scene.bodies().velocity[body].norm());
  }
  return fastest;
}

TYPED_TEST(RowsAgainstContacts, OfAPlateThatPressesThrowNothing) {
  for (const int cubes : {1, 2, 3})
    for (const double mass : {1.0, 10.0})
      for (const int axis : {0, 1})
        EXPECT_LE(pressed_by_a_plate<TypeParam>(cubes, mass, axis), 50) << cubes << ' ' << mass << ' ' << axis;
}

}  // namespace law_rows_unmet_test
