#include <gtest/gtest.h>

#include "solver/methods/accelerations.hpp"
#include "solver/methods/avbd.hpp"
#include "solver/methods/rattle.hpp"
#include "solver/methods/xpbd.hpp"
#include "solver/scenes/boxes.hpp"
#include "solver/scenes/chain.hpp"
#include "tests/solver/hash.hpp"

// As determinism.cpp, for the families that do not step velocities.
namespace {

using namespace byhand;

const ChainOptions swinging{.links = 3, .length = 0.5, .mass = 3, .end_mass = 7, .angle = 1.2};

Boxes struck_stack() {
  Boxes boxes = stack(4);
  kick(boxes, 0.5);
  return boxes;
}

const Case cases[] = {
    {"PlaneBodiesXpbd", [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), Xpbd{}); },
     0xed0ca5be9b1e1561},
    {"SpaceBodiesXpbd", [] { return after_ten_seconds(pinned_chain<SpaceBody>(swinging), Xpbd{}); },
     0x4798a11d39ff354b},
    {"PlaneStackXpbd", [] { return after_ten_seconds(struck_stack(), Xpbd{}); }, 0x58a25529b721df59},
    {"PlaneBodiesAvbd", [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), Avbd{}); },
     0x89e88d7ed9818df7},
    {"PlaneStackAvbd", [] { return after_ten_seconds(struck_stack(), Avbd{}); }, 0x0e80b6c465f504f2},
    {"PlaneBodiesRungeKutta",
     [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), Accelerations{.substeps = 8}); },
     0xe6cd87bac2fadef9},
    {"SpaceBodiesMidpoint",
     [] {
       return after_ten_seconds(pinned_chain<SpaceBody>(swinging),
                                Accelerations{.scheme = Scheme::implicit_midpoint, .substeps = 8});
     },
     0x8e5bcce5d3490cdb},
    {"PlaneBodiesRattle",
     [] { return after_ten_seconds(pinned_chain<PlaneBody>(swinging), Rattle{.substeps = 8}); },
     0x9cd00fe773746123},
    {"SpaceBodiesRattle",
     [] { return after_ten_seconds(pinned_chain<SpaceBody>(swinging), Rattle{.substeps = 8}); },
     0xb49a968303dc2dd3},
};

class DeterminismOfMethods : public testing::TestWithParam<Case> {};

TEST_P(DeterminismOfMethods, EndsInTheNumberWrittenDown) { expect_hash(GetParam()); }

INSTANTIATE_TEST_SUITE_P(, DeterminismOfMethods, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
