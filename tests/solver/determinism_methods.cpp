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
    {"PlaneBodiesXpbd",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Xpbd{}); },
     {0x552e7a6fcb4259ef, "6 rows laid out, 2400 passes, 14400 row solves"}},
    {"SpaceBodiesXpbd",
     [] { return after(2, pinned_chain<SpaceBody>(swinging), Xpbd{}); },
     {0x344606d98623c665, "9 rows laid out, 2400 passes, 21600 row solves"}},
    {"PlaneStackXpbd",
     [] { return after(2, struck_stack(), Xpbd{}); },
     {0x475a5241ccea91ff, "72 rows laid out, 2400 passes, 28800 row solves"}},
    {"PlaneBodiesAvbd",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Avbd{}); },
     {0x34c4b1d26d69c923, "6 rows laid out, 3600 solves, 19200 row solves"}},
    {"PlaneStackAvbd",
     [] { return after(2, struck_stack(), Avbd{}); },
     {0xe1474c2d6fc72f63, "12 rows laid out, 4800 solves, 39600 row solves"}},
    {"PlaneBodiesRungeKutta",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Accelerations{.substeps = 8}); },
     {0xbeac15d98ede7649, "3840 solves, 23040 rows prepared, 30720 row solves"}},
    {"SpaceBodiesMidpoint",
     [] {
       return after(2, pinned_chain<SpaceBody>(swinging),
                    Accelerations{.scheme = Scheme::implicit_midpoint, .substeps = 8});
     },
     {0x5736e27f7c22a539, "7932 solves, 71388 rows prepared, 87252 row solves"}},
    {"PlaneBodiesRattle",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Rattle{.substeps = 8}); },
     {0xe93c30df572030d8, "1080 solves, 6417 passes, 6480 rows prepared, 27891 row solves"}},
    {"SpaceBodiesRattle",
     [] { return after(2, pinned_chain<SpaceBody>(swinging), Rattle{.substeps = 8}); },
     {0xb268eee64deb30f2, "1080 solves, 6444 passes, 9720 rows prepared, 31212 row solves"}},
    {"PlaneBodiesRattleToATolerance",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Controlled<Rattle>{1e-3}); },
     {0x9bf5b04c54984753, "805 solves, 4925 passes, 4830 rows prepared, 21215 row solves"}},
    {"SpaceBodiesRattleToATolerance",
     [] { return after(2, pinned_chain<SpaceBody>(swinging), Controlled<Rattle>{1e-3}); },
     {0x812f6c425235bfcf, "805 solves, 4884 passes, 7245 rows prepared, 23507 row solves"}},
    {"PlaneBodiesGeneralisedToATolerance",
     [] { return after(2, pinned_chain<PlaneBody>(swinging), Controlled<Generalised>{1e-7}); },
     {0xff2b06fe2b6c59d8, "3300 solves, 360 rows prepared, 9900 row solves"}},
    {"SpaceBodiesGeneralisedToATolerance",
     [] { return after(2, pinned_chain<SpaceBody>(swinging), Controlled<Generalised>{1e-7}); },
     {0xe473666ec7827f40, "3294 solves, 360 rows prepared, 9882 row solves"}},
};

class DeterminismOfMethods : public testing::TestWithParam<Case> {};

TEST_P(DeterminismOfMethods, EndsInTheNumberWrittenDown) { expect_end(GetParam()); }

INSTANTIATE_TEST_SUITE_P(, DeterminismOfMethods, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace determinism_methods_test
