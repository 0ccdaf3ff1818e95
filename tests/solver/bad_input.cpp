#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/avbd.hpp"
#include "lessons/methods/controlled.hpp"
#include "lessons/methods/generalised.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/methods/xpbd.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/solving.hpp"

// Bad input is refused where it enters, in one sentence with the value and what is allowed, and leaves nothing
// behind.
namespace bad_input_test {

using namespace byhand;
using testing::AllOf, testing::HasSubstr, testing::StartsWith, testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan = std::nan("");

/// Expects the sentence "`name` is `value`, but it must be `allowed`".
void expect_refusal(const std::string& name_and_value, const std::string& allowed,
                    const std::function<void()>& f) {
  EXPECT_THAT(f, ThrowsMessage<std::invalid_argument>(
                     AllOf(StartsWith(name_and_value), HasSubstr(", but it must be "), HasSubstr(allowed))));
}

TEST(Mass, MustBePositiveAndFinite) {
  for (const auto& [bad, text] : {std::pair(0.0, "0"), {-3.0, "-3"}, {infinity, "inf"}, {nan, "nan"}}) {
    const double mass = bad;
    const std::string name = std::string("mass is ") + text;
    expect_refusal(name, "positive finite number [kg]", [&] { with_mass<PlaneParticle>(mass); });
    expect_refusal(name, "positive finite number [kg]", [&] { with_mass<SpaceBody>(mass, {1, 1, 1}); });
    expect_refusal(name, "positive finite number [kg]", [&] { ball<PlaneBody>(mass, 1); });
    expect_refusal(name, "positive finite number [kg]", [&] { box<SpaceBody>(mass, {1, 1, 1}); });
  }
  expect_refusal("moment of inertia is -2", "[kg m²]", [] { with_mass<SpaceBody>(1, {1, -2, 1}); });
  expect_refusal("largest moment of inertia is 3.01", "at most 3, the sum", [] {
    with_mass<SpaceBody>(1, {1, 2, 3.01});
  });
  expect_refusal("largest moment of inertia is 7", "at most 5, the sum", [] {
    with_mass<SpaceBody>(1, {7, 2, 3});
  });
  EXPECT_NO_THROW((with_mass<SpaceBody>(1, {1, 2, 3}))) << "a plate";
  expect_refusal("radius is 0", "[m]", [] { ball<PlaneBody>(1, 0); });
  expect_refusal("side is nan", "[m]", [] { box<SpaceBody>(1, {1, 1, nan}); });
}

/// A scene of two bodies, and a check that what is refused leaves it as it was.
template <class M>
struct Subject {
  Scene<M> scene;
  Random random;

  Subject() {
    for (int i = 0; i < 2; ++i) scene.add_body(random.pose<M>(), random.mass<M>());
  }
  void refuses(const std::string& name_and_value, const std::string& allowed, const std::function<void()>& f) {
    const int bodies = scene.bodies().size(), constraints = scene.count();
    const auto version = scene.version();
    expect_refusal(name_and_value, allowed, f);
    EXPECT_EQ(scene.bodies().pose.size(), bodies);
    EXPECT_EQ(scene.bodies().velocity.size(), bodies);
    const auto& masses = scene.bodies().inverse_mass;
    EXPECT_EQ(std::distance(masses.begin(), masses.end()), bodies);
    EXPECT_EQ(scene.count(), constraints);
    EXPECT_EQ(scene.version(), version) << "nothing has to be laid out anew";
    EXPECT_EQ(scene.template all<Distance>().size() + scene.template all<Pin>().size() +
                  scene.template all<NormalisedDistance>().size() + scene.template all<Contact>().size() +
                  scene.template all<Friction>().size(),
              constraints);
  }
};

TEST(Body, MustBeSomewhereFiniteWithAMassThatIsPositiveOrNone) {
  in_all_models([]<class M>(Random& random) {
    Subject<M> subject;
    auto& scene = subject.scene;
    const auto mass = random.mass<M>();
    for (const double bad : {infinity, -infinity, nan}) {
      Pose<M> pose;
      pose.position[1] = bad;
      Velocity<M> V = Velocity<M>::Zero();
      V[M::dof - 1] = bad;
      subject.refuses(fmt::format("position is {}", bad), "finite number [m]",
                      [&] { scene.add_body(pose, mass); });
      subject.refuses(fmt::format("velocity is {}", bad), "finite number",
                      [&] { scene.add_body(Pose<M>{}, mass, V); });
    }
    for (const double bad : {-1.0, infinity, nan}) {
      InverseMass<M> wrong = mass;
      wrong.linear = bad;
      subject.refuses(fmt::format("inverse mass is {}", bad),
                      "positive and finite, or zero throughout for a fixed body",
                      [&] { scene.add_body(Pose<M>{}, wrong); });
    }
  });
  in_both_bodies([]<class M>(Random& random) {
    Subject<M> subject;
    auto& scene = subject.scene;
    InverseMass<M> cannot_turn = random.mass<M>(), only_turns = cannot_turn;
    cannot_turn.angular.setZero();
    only_turns.linear = 0;
    subject.refuses("inverse moment of inertia is 0", "positive", [&] { scene.add_body(Pose<M>{}, cannot_turn); });
    subject.refuses("inverse moment of inertia is", "zero throughout",
                    [&] { scene.add_body(Pose<M>{}, only_turns); });
  });
  Subject<PlaneBody> plane;
  Pose<PlaneBody> pose;
  pose.rotation = {2, 0};
  plane.refuses("squared length of the rotation is 4", "1",
                [&] { plane.scene.add_body(pose, ball<PlaneBody>(1, 1)); });
  pose.rotation = {std::sqrt(1.5), 0};
  plane.refuses("squared length of the rotation is 1.", "1",
                [&] { plane.scene.add_body(pose, ball<PlaneBody>(1, 1)); });
  Subject<SpaceBody> space;
  Pose<SpaceBody> turned;
  turned.rotation.coeffs() << nan, 0, 0, 1;
  space.refuses("squared length of the rotation is nan", "1",
                [&] { space.scene.add_body(turned, ball<SpaceBody>(1, 1)); });
}

TEST(Constraint, RefusesDirectionsThatAreNotOrthonormal) {
  Subject<SpaceBody> subject;
  auto& scene = subject.scene;
  Hinge<SpaceBody> hinge{{0, 1}};
  hinge.across.col(0) *= 1.1;
  subject.refuses("distance of the directions across the hinge from orthonormal is", "between 0 and",
                  [&] { scene.add(hinge); });
  Slider<SpaceBody> slider{{0, 1}}, turned = slider;
  slider.across.col(0) *= 1.1;
  subject.refuses("distance of the directions across the slider from orthonormal is", "between 0 and",
                  [&] { scene.add(slider); });
  turned.right.rest.coeffs() *= 1.1;
  subject.refuses("squared length of the rotation is 1.21", "1", [&] { scene.add(turned); });
}

TEST_IN_ALL_MODELS(Constraint, MustJoinTwoBodiesOfTheScene) {
  Subject<M> subject;
  auto& scene = subject.scene;
  const std::string allowed = "at least 0 and less than 2, the number of bodies";
  subject.refuses("body index is 2", allowed, [&] { scene.add(Distance<M>{{0, 2}}); });
  subject.refuses("body index is -1", allowed, [&] { scene.add(NormalisedDistance<M>{{-1, 0}}); });
  subject.refuses("body index is 7", allowed, [&] { scene.add(Pin<M>{{7, 0}}); });
  subject.refuses("body index is 3", allowed, [&] { scene.add(Contact<M>{{0, 3}}); });
  subject.refuses("body index is 1", "another one", [&] { scene.add(Pin<M>{{1, 1}}); });
  subject.refuses("body index is 5", allowed, [&] { pin<M>(scene.bodies(), 0, 5, Linear<M>::Zero()); });
  subject.refuses("body index is -2", allowed, [&] { pin<M>(scene.bodies(), -2, 1, Linear<M>::Zero()); });
  if constexpr (M::angular > 0) {
    subject.refuses("body index is 9", allowed,
                    [&] { axis_in<M>(scene.bodies(), 9, Linear<M>(Linear<M>::Unit(0))); });
    for (const double bad : {0.0, infinity, nan}) {
      Linear<M> axis = Linear<M>::Zero();
      axis[0] = bad;
      subject.refuses(fmt::format("length of the axis is {}", bad), "positive and finite",
                      [&] { axis_in<M>(scene.bodies(), 1, axis); });
    }
    subject.refuses("body index is 9", allowed, [&] { orientation<M>(scene.bodies(), 0, 9); });
    Pin<M> far{{0, 1}};
    far.at.arms.second[1] = infinity;
    subject.refuses("arm is inf", "finite number [m]", [&] { scene.add(far); });
  }
}

// Whoever names no bodies has named one twice.
TEST_IN_ALL_MODELS(Constraint, MustNameItsBodies) {
  Subject<M> subject;
  auto& scene = subject.scene;
  const auto refused = [&](const auto& constraint) {
    subject.refuses("body index is 0", "another one", [&] { scene.add(constraint); });
  };
  refused(Distance<M>{}), refused(NormalisedDistance<M>{}), refused(Rope<M>{}), refused(Spring<M>{});
  refused(Pin<M>{}), refused(Contact<M>{}), refused(Friction<M>{});
  if constexpr (M::angular == 1) refused(motor(Turn<M>{}, 1, 1)), refused(at_least(-1.0, Turn<M>{}));
}

TEST_IN_ALL_MODELS(Rod, MustHaveALengthAndADirection) {
  Subject<M> subject;
  auto& scene = subject.scene;
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    const std::string name = fmt::format("length is {}", bad);
    subject.refuses(name, "positive finite number [m]", [&] { scene.add(Distance<M>{{0, 1}, bad}); });
    subject.refuses(name, "positive finite number [m]", [&] { scene.add(NormalisedDistance<M>{{0, 1}, bad}); });
  }
  scene.state().pose[1] = scene.bodies().pose[0];
  const std::string name = "distance between the rod's ends is 0";
  subject.refuses(name, "above zero [m]", [&] { scene.add(Distance<M>{{0, 1}, 1}); });
  subject.refuses(name, "above zero [m]", [&] { scene.add(NormalisedDistance<M>{{0, 1}, 1}); });
}

TEST_IN_ALL_MODELS(Softness, MustNotBeNegative) {
  Subject<M> subject;
  auto& scene = subject.scene;
  for (const double bad : {-1.0, infinity, nan}) {
    const std::string name = fmt::format("softness is {}", bad);
    subject.refuses(name, "between 0 and", [&] { scene.add(Distance<M>{{0, 1}, 1, bad}); });
    subject.refuses(name, "between 0 and", [&] { scene.add(NormalisedDistance<M>{{0, 1}, 1, bad}); });
    subject.refuses(name, "between 0 and", [&] { scene.add(Pin<M>{{0, 1}, bad}); });
    subject.refuses(name, "between 0 and", [&] { scene.add(Contact<M>{{0, 1}, Linear<M>::Unit(0), bad}); });
  }
}

TEST_IN_ALL_MODELS(Contact, MustHaveAUnitNormal) {
  Subject<M> subject;
  auto& scene = subject.scene;
  for (const double bad : {0.0, 2.0, nan})
    subject.refuses(fmt::format("length of the normal is {}", bad), "between 0.999999999 and 1.000000001", [&] {
      scene.add(Contact<M>{{0, 1}, bad * Linear<M>::Unit(0)});
    });
}

TEST(BodyForces, AreOfABodyOfTheScene) {
  Subject<PlaneBody> subject;
  const std::string allowed = "at least 0 and less than 2, the number of bodies";
  subject.refuses("body index is 2", allowed, [&] { subject.scene.set_gravity_scale(2, 0); });
  subject.refuses("body index is -1", allowed, [&] { subject.scene.set_damping(-1, 0); });
}

TEST(Spring, IsTunedToAPositiveFrequencyAndADampingRatioThatIsNotNegative) {
  Scene<PlaneParticle> scene;
  for (const double x : {0.0, 1.0}) scene.add_body({x, 0}, with_mass<PlaneParticle>(1));
  const NormalisedDistance<PlaneParticle> row{{0, 1}, 1};
  expect_refusal("frequency is 0", "[rad/s]", [&] { tuned(scene.bodies(), row, 0, 1); });
  for (const double bad : {-0.1, infinity, nan})
    expect_refusal(fmt::format("damping ratio is {}", bad), "between 0",
                   [&] { tuned(scene.bodies(), row, 1, bad); });
}

TEST(Swing, StopsWithinHalfATurn) {
  Subject<SpaceBody> subject;
  const auto freedom = swing<SpaceBody>(subject.scene.bodies(), 0, 1, Linear<SpaceBody>::Unit(1));
  for (const double bad : {-1.0, 0.0, 3.15, nan})
    expect_refusal(fmt::format("place of the stop is {}", bad), "above 0 and below 3.14",
                   [&] { subject.scene.add(at_most<SpaceBody>(bad, freedom)); });
  EXPECT_NO_THROW(subject.scene.add(at_most<SpaceBody>(3.1, freedom)));
}

TEST(Margin, MustBePositiveAndFinite) {
  Subject<PlaneBody> subject;
  for (const double bad : {0.0, -1.0, infinity, nan})
    subject.refuses(fmt::format("contact margin is {}", bad), "positive finite number [m]",
                    [&] { subject.scene.set_margin(bad); });
  for (const double bad : {-1.0, infinity, nan})
    subject.refuses(fmt::format("lookahead is {}", bad), "between 0 and",
                    [&] { subject.scene.set_margin(0.02, bad); });
}

TEST_IN_ALL_MODELS(Friction, MustFollowAContactWithUnitTangentsAndACoefficient) {
  Subject<M> subject;
  auto& scene = subject.scene;
  const auto tangents = tangents_of<M>(Linear<M>::Unit(1));
  const std::string allowed = "the handle of a contact that was added before";
  subject.refuses("contact of a friction is 0", allowed, [&] {
    scene.add(Friction<M>{{0, 1}, tangents, 0.5, 0});
  });
  const int rod = scene.add(Distance<M>{{0, 1}, 1});
  const int contact = scene.add(Contact<M>{{0, 1}, Linear<M>::Unit(1)});
  subject.refuses("contact of a friction is 0", allowed, [&] {
    scene.add(Friction<M>{{0, 1}, tangents, 0.5, rod});
  });
  subject.refuses("contact of a friction is -1", allowed, [&] {
    scene.add(Friction<M>{{0, 1}, tangents, 0.5, -1});
  });
  subject.refuses("contact of a friction is 2", allowed, [&] {
    scene.add(Friction<M>{{0, 1}, tangents, 0.5, 2});
  });
  const auto expect_leads_none = [&](int id) {
    expect_refusal(fmt::format("contact of a friction is {}", id), allowed, [&] {
      scene.add(Friction<M>{{0, 1}, tangents, 0.5, id});
    });
    scene.remove(id);
  };
  expect_leads_none(scene.add(Rope<M>{{0, 1}, 1}));  // pulls
  if constexpr (M::angular > 0) {
    Turn<M> turn{0, 1};
    if constexpr (M::angular == 3) turn.axis = Linear<M>::Unit(0);
    expect_leads_none(scene.add(motor(turn, 1, 1)));     // its λ may be of either sign
    expect_leads_none(scene.add(at_least(-1.0, turn)));  // presses no surface
  }
  subject.refuses("friction coefficient is -0.5", "between 0 and", [&] {
    scene.add(Friction<M>{{0, 1}, tangents, -0.5, contact});
  });
  subject.refuses("distance of the tangents from orthonormal is", "between 0 and", [&] {
    scene.add(Friction<M>{{0, 1}, 2 * tangents, 0.5, contact});
  });
  EXPECT_NO_THROW(scene.add(Friction<M>{{0, 1}, tangents, 0.5, contact}));
}

TEST_IN_ALL_MODELS(Step, MustHaveATimeAndChoicesWithinTheirRange) {
  auto scene = rod_chain<M>({.links = 2, .angle = 1});
  const auto before = scene;
  Work<M> work;
  const auto refuses = [&](double h, const AnyStepping& method, const std::string& name_and_value,
                           const std::string& allowed) {
    expect_refusal(name_and_value, allowed, [&] { advance(scene, method, h, work); });
    EXPECT_EQ(numbers_of<M>(scene.bodies().velocity), numbers_of<M>(before.bodies().velocity));
    EXPECT_EQ(difference(scene.bodies().pose[2].position, before.bodies().pose[2].position), 0);
  };
  for (const double bad : {0.0, -1.0, infinity, nan})
    refuses(bad, {}, fmt::format("time step is {}", bad), "positive finite number [s]");
  for (const double bad : {-0.1, 3.1, nan})
    refuses(0.1, {GaussSeidel{}, Baumgarte{bad}}, fmt::format("beta is {}", bad), "between 0 and 3");
  refuses(0.1, {GaussSeidel{}, Baumgarte{-1, BetaReading::literal}}, "beta is -1", "[1/s]");
  refuses(0.1, {GaussSeidel{}, Baumgarte{1.1e6, BetaReading::literal}}, "beta is 1", "[1/s]");
  refuses(0.1, {GaussSeidel{0}}, "number of sweeps is 0", "at least 1");
  refuses(0.1, {GaussSeidel{.tolerance = -1}}, "tolerance is -1", "between 0 and");
  refuses(0.1, {ConjugateSweeps{0}}, "number of sweeps is 0", "at least 1");
  refuses(0.1, {ConjugateSweeps{.tolerance = nan}}, "tolerance is nan", "between 0 and");
  refuses(0.1, {Jacobi{-2}}, "number of sweeps is -2", "at least 1");
  for (const double bad : {0.0, 2.0, nan}) {
    GaussSeidel sweeps;
    sweeps.relaxation = bad;
    refuses(0.1, {sweeps}, fmt::format("relaxation is {}", bad), "above 0 and below 2");
    Jacobi jacobi;
    jacobi.relaxation = bad;
    refuses(0.1, {jacobi}, fmt::format("relaxation is {}", bad), "above 0 and below 2");
  }
  refuses(0.1, {ConjugateGradients{0}}, "number of iterations is 0", "at least 1");
  refuses(0.1, {ConjugateGradients{1, -1}}, "tolerance is -1", "between 0 and");
  refuses(0.1, {AcceleratedGradient{-1}}, "number of iterations is -1", "at least 1");
  refuses(0.1, {AcceleratedGradient{1, nan}}, "tolerance is nan", "between 0 and");
  refuses(0.1, {GaussSeidel{}, SplitImpulse{3.1}}, "beta is 3.1", "between 0 and 3");
  refuses(0.1, {GaussSeidel{}, SplitImpulse{.slop = -1}}, "slop is -1", "[m]");
  refuses(0.1, {GaussSeidel{}, SplitImpulse{.speed_cap = 0}}, "speed cap is 0", "[m/s]");
  for (const double bad : {0.0, -1.0, infinity, nan})
    refuses(0.1, {GaussSeidel{}, SoftConstraints{bad}}, fmt::format("frequency is {}", bad), "[rad/s]");
  refuses(0.1, {GaussSeidel{}, SoftConstraints{1, -0.1}}, "damping ratio is -0.1", "between 0 and");
  refuses(0.1, {GaussSeidel{}, SoftConstraints{.slop = nan}}, "slop is nan", "[m]");
  refuses(0.1, {GaussSeidel{}, SoftConstraints{.speed_cap = nan}}, "speed cap is nan", "[m/s]");
  refuses(0.1, {Direct{Factorisation::structured, -1}}, "regularisation is -1", "between 0 and 1");
  refuses(0.1, {Direct{.smallest_pivot = 1.5}}, "smallest pivot is 1.5", "between 0 and 1");
  for (const double bad : {0.0, 1.5, nan})
    refuses(0.1, {Direct{.tolerance = bad}}, fmt::format("tolerance is {}", bad), "above 0 and at most 1");
  AnyStepping method;
  method.substeps = 0;
  refuses(0.1, method, "number of substeps is 0", "at least 1");
  method = {};
  method.bounce_threshold = -0.1;
  refuses(0.1, method, "bounce threshold is -0.1", "[m/s]");
}

// The reference pages state them.
TEST(Defaults, OfRowSolversAreThoseOfTheReference) {
  EXPECT_EQ(GaussSeidel{}.sweeps, 10);
  EXPECT_EQ(GaussSeidel{}.relaxation, 1);
  EXPECT_EQ(GaussSeidel{}.tolerance, 0);
  EXPECT_EQ(Jacobi{}.sweeps, 10);
  EXPECT_EQ(Jacobi{}.relaxation, 1);
  EXPECT_EQ(std::get<Baumgarte>(VelocityStepping{}.drift).slop, 0.001);
  EXPECT_EQ(ConjugateSweeps{}.sweeps, 50);
  EXPECT_EQ(ConjugateSweeps{}.tolerance, 1e-6);
  EXPECT_EQ(ConjugateGradients{}.iterations, 50);
  EXPECT_EQ(ConjugateGradients{}.tolerance, 1e-9);
  EXPECT_EQ(AcceleratedGradient{}.iterations, 50);
  EXPECT_EQ(AcceleratedGradient{}.tolerance, 1e-6);
  EXPECT_EQ(Direct{}.regularisation, 0);
  EXPECT_EQ(Direct{}.rounds, 20);
  EXPECT_EQ(Direct{}.tolerance, 1e-10);
  EXPECT_EQ(SemismoothNewton{}.rounds, 20);
  EXPECT_EQ(SemismoothNewton{}.sweeps, 10);
  EXPECT_EQ(SemismoothNewton{}.tolerance, 1e-12);
  EXPECT_EQ(ByGraph{}.unlike, 50);
}
TEST(Defaults, OfMethodsAndCuresAreThoseOfTheReference) {
  EXPECT_EQ(AnyStepping{}.substeps, 1);
  EXPECT_EQ(AnyStepping{}.bounce_threshold, 0.5);
  EXPECT_EQ(Baumgarte{}.beta, 0.2);
  EXPECT_EQ(Baumgarte{}.slop, 0);
  EXPECT_EQ(SplitImpulse{}.beta, 0.2);
  EXPECT_EQ(SplitImpulse{}.slop, 0);
  EXPECT_EQ(Projection{}.sweeps, 4);
  EXPECT_EQ(Projection{}.slop, 0);
  EXPECT_EQ(Xpbd{}.substeps, 20);
  EXPECT_EQ(Xpbd{}.iterations, 1);
  EXPECT_EQ(Xpbd{}.push_speed, 1);
  EXPECT_EQ(Xpbd{}.bounce_threshold, 0.5);
  EXPECT_EQ(Avbd{}.iterations, 10);
  EXPECT_EQ(Avbd{}.alpha, 0.95);
  EXPECT_EQ(Avbd{}.beta, 100);
  EXPECT_EQ(Avbd{}.memory, 0.99);
  EXPECT_EQ(Avbd{}.softest, 1);
  EXPECT_EQ(Avbd{}.stiffest, 3e5);
  EXPECT_EQ(Avbd{}.bounce_threshold, 0.5);
  EXPECT_EQ(Rattle{}.substeps, 1);
  EXPECT_EQ(Accelerations{}.substeps, 1);
  EXPECT_EQ(Generalised{}.substeps, 1);
  EXPECT_EQ(Controlled<Rattle>{}.tolerance, 1e-4);
  EXPECT_EQ(Controlled<Rattle>{}.most_substeps, 100'000);
}

// On the allowed side of the limit.
TEST(Strength, OfAServoOrMotorMayBeZero) {
  using M = PlaneBody;
  Scene<M> scene = pinned_chain<M>({.links = 1});
  const Turn<M> joint = turn<M>(scene.bodies(), 0, 1);
  EXPECT_NO_THROW(scene.add(servo(joint, 1, {100, 1}, 0)));
  EXPECT_NO_THROW(scene.add(motor(joint, 1, 0)));
  expect_refusal("strength of the servo is -1", "zero or above", [&] {
    scene.add(servo(joint, 1, {100, 1}, -1));
  });
}

TEST(Scenes, RefuseWhatTheyCannotBuild) {
  expect_refusal("number of links is 0", "at least 1", [] { rod_chain<PlaneParticle>({.links = 0}); });
  expect_refusal("length of a link is -1", "[m]", [] { pinned_chain<PlaneBody>({.length = -1}); });
  expect_refusal("mass is 0", "[kg]", [] { rod_chain<SpaceParticle>({.mass = 0}); });
  expect_refusal("end mass is 0", "[kg]", [] { rod_chain<SpaceParticle>({.end_mass = 0}); });
  expect_refusal("position is nan", "finite", [] { rod_chain<SpaceParticle>({.angle = nan}); });
  expect_refusal("length is 0", "[m]", [] { pendulum<PlaneParticle>(1, 0, 1); });
  expect_refusal("mass is -1", "[kg]", [] { hinged_rod(1, 1, -1); });
  expect_refusal("number of levels is 0", "between 1 and 20", [] { pinned_tree<PlaneBody>(0); });
  expect_refusal("number of arms is 0", "at least 1", [] { pinned_star<PlaneBody>(0); });
}

}  // namespace bad_input_test
