#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <iostream>
#include <random>

#include "solver/constraints/anchors.hpp"
#include "solver/scene.hpp"
#include "tests/solver/dense.hpp"

// Random bodies for properties that hold whatever the numbers are, drawn from one fixed seed that every program
// prints.
namespace byhand {

inline constexpr std::uint64_t seed = 20261121;

class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  int index(int count) { return static_cast<int>(uniform(0, count)); }

  template <int n>
  Eigen::Matrix<double, n, 1> vector(double size) {
    Eigen::Matrix<double, n, 1> result;
    for (double& x : result) x = uniform(-size, size);
    return result;
  }
  template <class M>
  Linear<M> direction();
  /// Within 2 m of the origin on each axis, turned anyhow.
  template <class M>
  Pose<M> pose();
  template <class M>
  Velocity<M> velocity();
  /// 0.2 to 5 kg, three moments that a body can have.
  template <class M>
  InverseMass<M> mass();
  template <class M>
  Arms<M> arms();

 private:
  std::mt19937_64 bits_{seed};
};

/// Two bodies with all that one constraint between them can see.
template <class M>
struct Pair {
  Pose<M> pose1, pose2;
  Velocity<M> V1, V2;
  InverseMass<M> m1, m2;
  Anchors<M> at;

  Arm<M> r1() const;
  Arm<M> r2() const;
  Linear<M> P1() const;
  Linear<M> P2() const;
  /// A scene of the two.
  Scene<M> scene() const;
  Bodies<M> bodies() const { return scene().bodies(); }
};

template <class M>
Pair<M> random_pair(Random& random);

template <class M>
constexpr const char* name_of() {
  if constexpr (M::angular == 0)
    return M::linear == 2 ? "particle in the plane" : "particle in space";
  else
    return M::linear == 2 ? "body in the plane" : "body in space";
}

/// Calls f.template operator()<M>(random) for each model `draws` times, and says on failure which draw of which
/// model it was.
template <class... Models, class F>
void in_models(F&& f, int draws = 1) {
  const auto in_one = [&]<class M>(Random random) {
    for (int draw = 0; draw < draws && !testing::Test::HasFatalFailure(); ++draw) {
      SCOPED_TRACE(testing::Message() << name_of<M>() << ", draw " << draw << ", seed " << seed);
      f.template operator()<M>(random);
    }
  };
  (in_one.template operator()<Models>(Random()), ...);
}
template <class F>
void in_all_models(F&& f, int draws = 1) {
  in_models<PlaneParticle, PlaneBody, SpaceParticle, SpaceBody>(f, draws);
}
/// The models that turn.
template <class F>
void in_both_bodies(F&& f, int draws = 1) {
  in_models<PlaneBody, SpaceBody>(f, draws);
}

/// A test whose body is run in each model M, with `random`, as often as a third argument says:
///
///   TEST_IN_ALL_MODELS(Equation17, MakesTheRowVanish, draws) { const auto pair = random_pair<M>(random); … }
#define TEST_IN_ALL_MODELS(suite, name, ...) BYHAND_TEST_IN(in_all_models, suite, name, __VA_ARGS__)
#define TEST_IN_BOTH_BODIES(suite, name, ...) BYHAND_TEST_IN(in_both_bodies, suite, name, __VA_ARGS__)
#define BYHAND_TEST_IN(models, suite, name, ...)                                                   \
  template <class M>                                                                               \
  void suite##_##name(Random& random);                                                             \
  TEST(suite, name) {                                                                              \
    models([]<class M>(Random& random) { suite##_##name<M>(random); } __VA_OPT__(, ) __VA_ARGS__); \
  }                                                                                                \
  template <class M>                                                                               \
  void suite##_##name([[maybe_unused]] Random& random)

class PrintsTheSeed : public testing::Environment {
  void SetUp() override { std::cout << "random seed " << seed << '\n'; }
};
inline const testing::Environment* const prints_the_seed = testing::AddGlobalTestEnvironment(new PrintsTheSeed);

}  // namespace byhand
