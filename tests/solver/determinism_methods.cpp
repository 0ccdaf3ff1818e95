#include <gtest/gtest.h>

#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/avbd.hpp"
#include "lessons/methods/controlled.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/methods/xpbd.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "tests/solver/hash.hpp"

// As determinism.cpp, for the families that do not step velocities. They cost more a step, and a bit that differs
// shows at once: two seconds are enough.
namespace determinism_methods_test {

using namespace byhand;

const ChainOptions swinging{.links = 3, .length = 0.5, .mass = 3, .end_mass = 7, .angle = 1.2};

Scene<PlaneBody> struck_stack() {
  Scene<PlaneBody> boxes = stack(4);
  kick(boxes, 0.5);
  return boxes;
}

const Case cases[] = {
    {"PlaneBodiesXpbd", [] { return after(2, pinned_chain<PlaneBody>(swinging), Xpbd{}); }, 0x552e7a6fcb4259ef},
    {"SpaceBodiesXpbd", [] { return after(2, pinned_chain<SpaceBody>(swinging), Xpbd{}); }, 0x344606d98623c665},
    {"PlaneStackXpbd", [] { return after(2, struck_stack(), Xpbd{}); }, 0x475a5241ccea91ff},
    {"PlaneBodiesAvbd", [] { return after(2, pinned_chain<PlaneBody>(swinging), Avbd{}); }, 0x34c4b1d26d69c923},
    {"PlaneStackAvbd", [] { return after(2, struck_stack(), Avbd{}); }, 0xe1474c2d6fc72f63},
    {"PlaneBodiesRungeKutta",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Accelerations{.substeps = 8}); }, 0xbeac15d98ede7649},
    {"SpaceBodiesMidpoint",
     [] {
       return after(2, pinned_chain<SpaceBody>(swinging),
                    Accelerations{.scheme = Scheme::implicit_midpoint, .substeps = 8});
     },
     0x5736e27f7c22a539},
    {"PlaneBodiesRattle", [] { return after(2, pinned_chain<PlaneBody>(swinging), Rattle{.substeps = 8}); },
     0xe93c30df572030d8},
    {"SpaceBodiesRattle", [] { return after(2, pinned_chain<SpaceBody>(swinging), Rattle{.substeps = 8}); },
     0xb268eee64deb30f2},
    {"PlaneBodiesRattleToATolerance",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Controlled<Rattle>{1e-3}); }, 0x9bf5b04c54984753},
    {"SpaceBodiesRattleToATolerance",
     [] { return after(2, pinned_chain<SpaceBody>(swinging), Controlled<Rattle>{1e-3}); }, 0x812f6c425235bfcf},
    {"PlaneBodiesGeneralisedToATolerance",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Controlled<Generalised>{1e-7}); },
     0xff2b06fe2b6c59d8},
    {"SpaceBodiesGeneralisedToATolerance",
     [] { return after(2, pinned_chain<SpaceBody>(swinging), Controlled<Generalised>{1e-7}); },
     0xe473666ec7827f40},
};

class DeterminismOfMethods : public testing::TestWithParam<Case> {};

TEST_P(DeterminismOfMethods, EndsInTheNumberWrittenDown) { expect_hash(GetParam()); }

INSTANTIATE_TEST_SUITE_P(, DeterminismOfMethods, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace determinism_methods_test
