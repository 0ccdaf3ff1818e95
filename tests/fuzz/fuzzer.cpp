#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fuzz/draw.hpp"
#include "tests/fuzz/shrink.hpp"

// The fuzzer finds what it is for, and a sample of its scenes keeps every law.
namespace fuzzer_test {

using namespace byhand;
using namespace byhand::fuzz;
using testing::HasSubstr, testing::Le, testing::SizeIs;

const VelocityStepping by_default{};

template <class M>
void expect_laws_kept() {
  for (std::uint64_t draw = 1; draw <= 60; ++draw) {
    const auto found = failure<M>(draw, by_default);
    EXPECT_FALSE(found) << "scene " << draw << ", " << found->law << ": " << found->what << '\n'
                        << code_of(found->scene);
  }
}
TEST(Fuzzer, SixtyScenesInThePlaneKeepEveryLaw) { expect_laws_kept<PlaneBody>(); }
TEST(Fuzzer, SixtyScenesInSpaceKeepEveryLaw) { expect_laws_kept<SpaceBody>(); }

/// The first scene that breaks a law of this name.
template <class M>
Failure<M> found(const VelocityStepping& method, const char* name) {
  for (std::uint64_t draw = 1; draw <= 1000; ++draw)
    if (auto broken = failure<M>(draw, method, name)) return *broken;
  ADD_FAILURE() << "no scene breaks the law: " << name;
  return {};
}

TEST(Fuzzer, FindsThatSweepsAloneLetAHeavyBodySinkIntoALightOne) {
  VelocityStepping sweeps = by_default;
  sweeps.solver = ConjugateSweeps{.tolerance = 1e-5};
  const auto sunken = found<SpaceBody>(sweeps, "sink");
  EXPECT_THAT(sunken.scene.parts, SizeIs(Le(4)));
  const auto masses = [&](bool light) {
    double extreme = light ? 1e300 : 0;
    for (const auto& part : sunken.scene.parts)
      if (part.mass > 0) extreme = light ? std::min(extreme, part.mass) : std::max(extreme, part.mass);
    return extreme;
  };
  EXPECT_GT(masses(false), 20 * masses(true));
  EXPECT_THAT(code_of(sunken.scene), HasSubstr("scene.set_shape(0, HalfSpace<SpaceBody>{{0, 1, 0}}"));
}

TEST(Fuzzer, FindsThatALooseToleranceLeavesTheAnswerToTheOrderAndTheBeginning) {
  VelocityStepping loose = by_default;
  loose.solver = GaussSeidel{.sweeps = 1000, .tolerance = 0.01};
  for (const char* name : {"order", "beginning"}) {
    EXPECT_THAT(found<PlaneBody>(loose, name).scene.parts, SizeIs(Le(4))) << name;
    EXPECT_THAT(found<SpaceBody>(loose, name).scene.parts, SizeIs(Le(4))) << name;
  }
}

TEST(Fuzzer, FindsThatAnExplicitGyroscopicTermMakesEnergy) {
  VelocityStepping explicitly = by_default;
  explicitly.gyroscopic = Gyroscopic::explicit_;
  EXPECT_THAT(found<SpaceBody>(explicitly, "energy").what, HasSubstr("energy [J]"));
}

TEST(Fuzzer, FindsThatBetaAboveTwoLeavesTheFiniteNumbers) {
  VelocityStepping strong = by_default;
  strong.drift = Baumgarte{3};
  EXPECT_THAT(found<PlaneBody>(strong, "finite").scene.parts, SizeIs(Le(4)));
}

TEST(Fuzzer, DrawsTheSameSceneForTheSameNumber) {
  EXPECT_EQ(code_of(drawn<SpaceBody>(7)), code_of(drawn<SpaceBody>(7)));
  EXPECT_NE(code_of(drawn<SpaceBody>(7)), code_of(drawn<SpaceBody>(8)));
}

}  // namespace fuzzer_test
