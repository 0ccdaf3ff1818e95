#include <gtest/gtest.h>

#include "lessons/methods/row_solvers.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "tests/solver/hash.hpp"

// The same scene and method give the same bits whatever the compiler, its options and the processor: each run of
// ten seconds ends in a number that is written down here. A test that
// fails prints the new one, for changes that are meant to change the arithmetic.
namespace determinism_test {

using namespace byhand;

/// A stack of four boxes that slides off a slope on contacts and friction at the corners of each.
template <class M>
Scene<M> sliding_stack() {
  Scene<M> scene;
  scene.gravity = 3 * Linear<M>::Unit(0) - 9 * Linear<M>::Unit(1);
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const Linear<M> up = Linear<M>::Unit(1);
  for (int i = 1; i <= 4; ++i) {
    scene.add_body(Linear<M>((i - 0.5) * up), box<M>(1, Linear<M>::Ones()));
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.4, 0.5}) {
        if (M::linear == 2 && z > 0) continue;
        Linear<M> point = (i - 1) * up + x * Linear<M>::Unit(0);
        if constexpr (M::linear == 3) point[2] = z;
        const auto at = between<M>(scene.bodies(), i - 1, point, i, point);
        const int contact = scene.add(Contact<M>{at, up});
        scene.add(Friction<M>{at, tangents_of<M>(up), 0.2, contact});
      }
  }
  return scene;
}

AnyStepping with_substeps(const AnyRowSolver& solver, int substeps) {
  AnyStepping method{solver};
  method.substeps = substeps;
  return method;
}

const ChainOptions swinging{.links = 10, .length = 0.5, .mass = 3, .end_mass = 7, .angle = 1.2};
constexpr GaussSeidel red_black{20, true, SweepOrder::coloured};

const Case cases[] = {
    {"PlaneBodiesGaussSeidel",
     [] {
       return after_ten_seconds(pinned_chain<PlaneBody>(swinging), {GaussSeidel{40}, Baumgarte{0.1}});
     },
     {0xb135589261770427, "20 rows laid out, 600 solves, 24000 passes, 12000 rows prepared, 480000 row solves"}},
    {"PlaneBodiesRedBlack",
     [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), with_substeps(red_black, 4)); },
     {0x839505d02ab9adcb, "20 rows laid out, 2400 solves, 48000 passes, 48000 rows prepared, 960000 row solves"}},
    {"PlaneBodiesJacobi",
     [] {
       return after_ten_seconds(pinned_chain<PlaneBody>(swinging), with_substeps(Jacobi{20, false, 0.6}, 4));
     },
     {0x7cde5a909ce3d567, "20 rows laid out, 2400 solves, 48000 passes, 48000 rows prepared, 960000 row solves"}},
    {"PlaneBodiesDirect",
     [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), with_substeps(Direct{}, 4)); },
     {0x0b44c763f1ffc375,
      "20 rows laid out, 2400 solves, 48000 rows prepared, 69600 row solves, 732 numbers read in plans"}},
    {"PlaneTreeDirect",
     [] { return after_ten_seconds(pinned_tree<PlaneBody>(5), with_substeps(Direct{}, 8)); },
     {0xdaea18344cf92c9c,
      "62 rows laid out, 4800 solves, 297600 rows prepared, 633600 row solves, 3224 numbers read in plans"}},
    {"PlaneStarDirect",
     [] { return after_ten_seconds(pinned_star<PlaneBody>(12), with_substeps(Direct{}, 4)); },
     {0x8d5385bbfc8771e6,
      "24 rows laid out, 2400 solves, 57600 rows prepared, 139200 row solves, 966 numbers read in plans"}},
    {"SpaceBodiesGaussSeidel",
     [] { return after_ten_seconds(pinned_chain<SpaceBody>(swinging), with_substeps(GaussSeidel{20}, 4)); },
     {0xa527e00d47a95333, "30 rows laid out, 2400 solves, 48000 passes, 72000 rows prepared, 1440000 row solves"}},
    {"SpaceBodiesDirect",
     [] { return after_ten_seconds(pinned_chain<SpaceBody>(swinging), with_substeps(Direct{}, 4)); },
     {0x8116046847652338,
      "30 rows laid out, 2400 solves, 72000 rows prepared, 103200 row solves, 732 numbers read in plans"}},
    {"PlaneParticlesRowByRow",
     [] {
       return after_ten_seconds(rod_chain<PlaneParticle>(swinging),
                                with_substeps(GaussSeidel{20, true, SweepOrder::reverse}, 4));
     },
     {0x34dd349eb00082d5, "10 rows laid out, 2400 solves, 48000 passes, 24000 rows prepared, 480000 row solves"}},
    {"PlaneParticlesDirect",
     [] {
       return after_ten_seconds(rod_chain<PlaneParticle, NormalisedDistance>(swinging),
                                with_substeps(Direct{}, 4));
     },
     {0x8ccde4b151132e32,
      "10 rows laid out, 2400 solves, 24000 rows prepared, 19200 row solves, 732 numbers read in plans"}},
    {"SpaceParticlesDirect",
     [] { return after_ten_seconds(rod_chain<SpaceParticle>(swinging), with_substeps(Direct{}, 4)); },
     {0x117a77f54ef7e30b,
      "10 rows laid out, 2400 solves, 24000 rows prepared, 12000 row solves, 732 numbers read in plans"}},
    {"PlaneBodiesConjugateGradients",
     [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), with_substeps(ConjugateGradients{12}, 4)); },
     {0x7190b4f85a826719, "20 rows laid out, 2400 solves, 28800 passes, 48000 rows prepared, 576000 row solves"}},
    {"SpaceBodiesConjugateGradients",
     [] { return after_ten_seconds(pinned_chain<SpaceBody>(swinging), with_substeps(ConjugateGradients{12}, 4)); },
     {0x9f7da11752f9bda3, "30 rows laid out, 2400 solves, 28800 passes, 72000 rows prepared, 864000 row solves"}},
    {"PlaneParticlesAcceleratedGradient",
     [] {
       return after_ten_seconds(rod_chain<PlaneParticle>(swinging), with_substeps(AcceleratedGradient{20}, 4));
     },
     {0x8a3b58e844d3bc13, "10 rows laid out, 2400 solves, 48756 passes, 24000 rows prepared, 487560 row solves"}},
    {"SpaceStackAcceleratedGradient",
     [] {
       return after_ten_seconds(sliding_stack<SpaceBody>(), AnyStepping{AcceleratedGradient{}, Baumgarte{}});
     },
     {0x9fff2eb9de3aa033, "48 rows laid out, 600 solves, 8216 passes, 28800 rows prepared, 394368 row solves"}},
    {"PlaneBodiesSymmetricSplitImpulse",
     [] {
       return after_ten_seconds(pinned_chain<PlaneBody>(swinging),
                                {GaussSeidel{20, true, SweepOrder::symmetric}, SplitImpulse{}});
     },
     {0xa8e175878623231c, "20 rows laid out, 1200 solves, 48000 passes, 24000 rows prepared, 960000 row solves"}},
    {"SpaceBodiesSoftConstraints",
     [] {
       return after_ten_seconds(pinned_chain<SpaceBody>(swinging), {GaussSeidel{20}, SoftConstraints{}});
     },
     {0x7d0faa11a242f554, "30 rows laid out, 1200 solves, 24000 passes, 36000 rows prepared, 720000 row solves"}},
    {"PlaneStackSoftConstraints",
     [] {
       return after_ten_seconds(sliding_stack<PlaneBody>(), {GaussSeidel{}, SoftConstraints{.refresh = false}});
     },
     {0x9fde5d8a09825c1b, "16 rows laid out, 1200 solves, 12000 passes, 19200 rows prepared, 192000 row solves"}},
    {"PlaneBodiesSoftConstraintsDirect",
     [] {
       return after_ten_seconds(pinned_chain<PlaneBody>(swinging), {Direct{}, SoftConstraints{}});
     },
     {0xe97a456d521a07b6,
      "20 rows laid out, 1200 solves, 24000 rows prepared, 34800 row solves, 732 numbers read in plans"}},
    {"PlaneStackSlides",
     [] {
       return after_ten_seconds(sliding_stack<PlaneBody>(), {GaussSeidel{}, Baumgarte{}});
     },
     {0x162fcdd7332ef549, "16 rows laid out, 600 solves, 6000 passes, 9600 rows prepared, 96000 row solves"}},
    {"SpaceStackSlides",
     [] {
       return after_ten_seconds(sliding_stack<SpaceBody>(), {GaussSeidel{}, Baumgarte{}});
     },
     {0x1c04bbac9e7a8766, "48 rows laid out, 600 solves, 6000 passes, 28800 rows prepared, 288000 row solves"}},
};

class Determinism : public testing::TestWithParam<Case> {};

TEST_P(Determinism, EndsInTheNumberWrittenDown) { expect_end(GetParam()); }

INSTANTIATE_TEST_SUITE_P(, Determinism, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace determinism_test
