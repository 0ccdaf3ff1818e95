#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lessons/catalogue/tuning.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/swinging_chain.hpp"
#include "lessons/pictures/methods.hpp"

// Scenes by name: what they are held against, and that every method runs them or says why not.
namespace catalogue_test {

using namespace byhand;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Named {
  std::string scene, model;
};
void PrintTo(const Named& one, std::ostream* out) { *out << one.scene << ", " << one.model; }

std::vector<Named> all_scenes() {
  std::vector<Named> all;
  for (const NamedScene& scene : catalogue())
    for (const std::string& model : scene.models) all.push_back({scene.name, model});
  return all;
}

Problem small(const Named& named) {
  if (named.scene == "chain") return Problem("chain", {{"links", 5}}, named.model);
  if (named.scene == "stack") return Problem("stack", {{"boxes", 3}});
  if (named.scene == "pyramid") return Problem("pyramid", {{"base", 3}});
  return Problem(named.scene, {}, named.model);
}

TEST(Families, HaveAPlaceAmongTheColoursEach) {
  for (const Family& family : families())
    EXPECT_LT(pictures::place_of(family.name), pictures::methods.size()) << family.name;
}

class EveryScene : public testing::TestWithParam<Named> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryScene, testing::ValuesIn(all_scenes()));

TEST_P(EveryScene, IsRunByEveryMethodOrRefusedWithAReason) {
  const Problem problem = small(GetParam());
  for (const Family& family : families()) {
    const Setting setting = family.setting(first_knobs(problem, family, family.cures.front(), 4));
    AnyScene scene = problem.start();
    const std::string refusal = scene.refusal(setting.method);
    if (!refusal.empty()) {
      EXPECT_THAT([&] { scene.use(setting.method); }, ThrowsMessage<std::invalid_argument>(HasSubstr(refusal)));
      continue;
    }
    scene.use(setting.method);
    // Boxes that lie on two others have rows that repeat each other: that alone a direct solve may refuse.
    const bool repeats = GetParam().scene == "pyramid" && family.name == "direct";
    bool refused = false;
    try {
      for (int i = 0; i < 20; ++i) scene.step(frame / setting.steps);
      EXPECT_TRUE(scene.finite()) << family.name;
      EXPECT_NEAR(scene.time(), 20 * frame / setting.steps, 1e-12);
      EXPECT_GT(scene.row_solves(), 0) << family.name;
    } catch (const SingularSystem& error) {
      EXPECT_THAT(error.what(), HasSubstr("repeat")) << family.name;
      refused = true;
    }
    EXPECT_EQ(refused, repeats) << family.name;
  }
}

TEST_P(EveryScene, BeginsOnItsConstraintsWhereItsReferenceDoes) {
  const Problem problem = small(GetParam());
  const AnyScene scene = problem.start();
  EXPECT_LT(scene.separation(), 1e-14);
  const ExactState exact = problem.scene().exact(problem)(0);
  std::size_t i = 0;
  for (const Placement& body : scene.placements())
    if (body.moves) {
      ASSERT_LT(i, exact.positions.size());
      EXPECT_LT((body.position - exact.positions[i++]).norm(), 1e-14);
    }
  EXPECT_EQ(i, exact.positions.size());
  EXPECT_LT((scene.momentum() - exact.momentum).norm(), 1e-14);
}

TEST_P(EveryScene, ComesToItsReferenceAsStepsAreShortened) {
  // The rows of each substep solved exactly: what is left is the time step's error, of first order.
  const Problem problem = small(GetParam());
  // A pyramid's rows repeat each other, which the direct solve refuses.
  const bool repeats = GetParam().scene == "pyramid";
  const Family& exact = family_named(repeats ? "conjugate sweeps to a tolerance" : "direct");
  Knobs knobs{.substeps = 16, .passes = 8, .cure = Cure::baumgarte, .strength = 1};
  const Point coarse = measure(problem, exact, knobs);
  knobs.substeps = 64;
  const Point fine = measure(problem, exact, knobs);
  ASSERT_EQ(fine.outcome, Outcome::good) << fine.reason;
  const double rounding = std::max(1e-9, 10 * problem.reference().uncertainty);
  for (const Error error : {Error::drift, Error::trajectory}) {
    EXPECT_LT(fine[error], std::max(rounding, coarse[error] / 3)) << name_of(error);
    EXPECT_LT(fine[error], 0.03) << name_of(error);
  }
  EXPECT_LT(fine[Error::reaction], 0.05);
}

TEST(Catalogue, ACopyGoesOnAlone) {
  AnyScene scene = Problem("chain", {{"links", 5}}).start();
  for (int i = 0; i < 10; ++i) scene.step(frame);
  AnyScene copy = scene;
  copy.step(frame);
  EXPECT_NE(copy.energy(), scene.energy());
  scene.step(frame);
  EXPECT_EQ(copy.energy(), scene.energy());
  EXPECT_EQ(copy.time(), scene.time());
}

TEST(Catalogue, TheSamePhysicsCostsMoreInARicherModelAndIsTheSameToRoundOff) {
  const auto run = [](const std::string& model) {
    AnyScene scene = Problem("chain", {{"links", 5}}, model).start();
    scene.use(AnyStepping{Direct{}});
    for (int i = 0; i < 60; ++i) scene.step(frame);
    return scene;
  };
  for (const auto& [poor, rich] : {std::pair("bobs in the plane", "balls in the plane"),
                                   {"bobs in the plane", "bobs in space"},
                                   {"bobs in space", "balls in space"},
                                   {"links in the plane", "links in space"}}) {
    const AnyScene a = run(poor), b = run(rich);
    EXPECT_LT(a.degrees_of_freedom(), b.degrees_of_freedom());
    EXPECT_LT(a.scene_bytes(), b.scene_bytes());
    EXPECT_LT(a.row_bytes(), b.row_bytes());
    const auto first = a.placements(), second = b.placements();
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_LT((first[i].position - second[i].position).norm(), 1e-12) << poor << " and " << rich;
  }
}

TEST(Reference, OfAPendulumIsTheCertifiedOne) {
  const double angle = -1.405027311525;  // atlas A1, at 1 s from 90°
  const Problem problem("pendulum");
  EXPECT_LT((problem.reference().positions[0] - Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0)).norm(),
            1e-11);
}

TEST(Reference, OfTwoBobsIsTheDoublePendulums) {
  const double first = -0.6250876998, second = -1.0345850857;  // atlas A4, at 1 s from 90°/90°
  const auto positions = Problem("double_pendulum").reference().positions;
  const Eigen::Vector3d one(std::sin(first), -std::cos(first), 0), two(std::sin(second), -std::cos(second), 0);
  EXPECT_LT((positions[0] - one).norm(), 1e-10);
  EXPECT_LT((positions[1] - one - two).norm(), 1e-10);
}

TEST(SwingingChain, OfOneLinkIsACompoundPendulum) {
  const SwingingChain chain({{.length = 3, .centre = 1.5, .mass = 2, .inertia = 2 * 9 / 12.0}}, 2, 9.81);
  const CompoundPendulum exact(2, 3, 2, 9.81);
  const double angle = exact.angle(1.3), rate = exact.angular_velocity(1.3);
  const SwingingChain::State end = chain.at(1.3);
  EXPECT_LT((end.positions[0] - 1.5 * Eigen::Vector2d(std::sin(angle), -std::cos(angle))).norm(), 1e-10);
  EXPECT_LT((end.velocities[0] - 1.5 * rate * Eigen::Vector2d(std::cos(angle), std::sin(angle))).norm(), 1e-10);
}

TEST(SwingingChain, KeepsItsLengthsAndItsEnergy) {
  std::vector<SwingingChain::Link> links(20);
  links.back().mass = 30;
  const SwingingChain::State end = SwingingChain(links, 1.5, 9.81).at(2);
  const auto energy = [&](const std::vector<Eigen::Vector2d>& x, const std::vector<Eigen::Vector2d>& v) {
    double sum = 0;
    for (std::size_t i = 0; i < links.size(); ++i)
      sum += links[i].mass * (v[i].squaredNorm() / 2 + 9.81 * x[i].y());
    return sum;
  };
  std::vector<Eigen::Vector2d> start;
  for (std::size_t i = 0; i < links.size(); ++i) {
    start.push_back((i + 1.0) * Eigen::Vector2d(std::sin(1.5), -std::cos(1.5)));
    const Eigen::Vector2d above = i == 0 ? Eigen::Vector2d(0, 0) : end.positions[i - 1];
    EXPECT_NEAR((end.positions[i] - above).norm(), 1, 1e-14);
  }
  const std::vector<Eigen::Vector2d> rest(links.size(), Eigen::Vector2d(0, 0));
  EXPECT_NEAR(energy(end.positions, end.velocities), energy(start, rest), 1e-7);  // of thousands of joules moved
}

TEST(SwingingChain, RefusesBadInput) {
  EXPECT_THROW(SwingingChain({}, 0, 9.81), std::invalid_argument);
  EXPECT_THROW(SwingingChain({{.inertia = -1}}, 0, 9.81), std::invalid_argument);
  EXPECT_THROW(SwingingChain({{}}, NAN, 9.81), std::invalid_argument);
  EXPECT_THROW(SwingingChain({{}}, 0, 0), std::invalid_argument);
  EXPECT_THROW(SwingingChain({{}}, 0, 9.81).at(1, 0), std::invalid_argument);
}

TEST(Reference, OfAHangingChainPullsWithItsWeight) {
  const Problem problem("chain", {{"links", 50}, {"angle", 0}, {"end_mass", 100}});
  EXPECT_LT((problem.reference().reaction - Eigen::Vector3d(0, 149 * 9.81, 0)).norm(), 1e-8);
  const Point exact = measure(problem, family_named("direct"), {.cure = Cure::baumgarte, .strength = 0.2});
  EXPECT_LT(exact[Error::reaction], 1e-12);
  EXPECT_LT(exact[Error::trajectory], 1e-12);
}

TEST(Reference, SumsMomentaThatAreTheRateOfItsPositions) {
  const double dt = 1e-5;
  for (const auto& [name, masses] : {std::pair<std::string, std::vector<double>>{"pendulum", {1}},
                                     {"compound_pendulum", {1}},
                                     {"double_pendulum", {1, 1}},
                                     {"four_bar", {1, 1, 1}},
                                     {"spherical_pendulum", {1}},
                                     {"conical_pendulum", {1}},
                                     {"top", {1}},
                                     {"incline", {1}}}) {
    const Problem problem(name);
    const auto exact = problem.scene().exact(problem);
    const ExactState before = exact(0.7 - dt), now = exact(0.7), after = exact(0.7 + dt);
    Eigen::Vector3d momentum(0, 0, 0);
    for (std::size_t i = 0; i < masses.size(); ++i)
      momentum += masses[i] * (after.positions[i] - before.positions[i]) / (2 * dt);
    EXPECT_LT((momentum - now.momentum).norm(), 1e-6) << name;
  }
}

TEST(Problem, RefusesWhatItDoesNotHave) {
  EXPECT_THAT([] { Problem("chian"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("scene is chian, but it must be one of pendulum")));
  EXPECT_THAT(
      [] {
        Problem("chain", {{"link", 3}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("is link, but it must be one of links")));
  EXPECT_THAT(
      [] {
        Problem("chain", {{"links", 2.5}});
      },
      ThrowsMessage<std::invalid_argument>("links is 2.5, but it must be a whole number"));
  EXPECT_THAT(
      [] {
        Problem("chain", {{"links", 0}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("links is 0")));
  EXPECT_THAT([] { Problem("chain", {}, "jelly"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("model is jelly")));
}

}  // namespace catalogue_test
