#include <gtest/gtest.h>

#include "lessons/scenes/box_pile.hpp"
#include "lessons/scenes/dominoes.hpp"
#include "tests/solver/hash.hpp"

// As determinism.cpp, for scenes whose contacts are found.
namespace determinism_contacts_test {

using namespace byhand;

Scene<PlaneBody> kicked_stack(int count) {
  Scene<PlaneBody> scene = stack(count);
  kick(scene, 0.02);
  return scene;
}

const Case cases[] = {
    {"StackDirect",
     [] {
       return after_ten_seconds(kicked_stack(12), {Direct{}, Baumgarte{}});
     },
     0x16b06a801e7d0dc3},
    {"StackRedBlack",
     [] {
       return after_ten_seconds(kicked_stack(12), {GaussSeidel{20, true, SweepOrder::coloured}, Baumgarte{}});
     },
     0x684a027b4e23b6ca},
    {"PyramidByGraph",
     [] {
       return after_ten_seconds(pyramid(8), {ByGraph{}, Baumgarte{}});
     },
     0x9e314bf040371bff},
    {"DominoesByGraph",
     [] {
       return after_ten_seconds(dominoes(8, 0.5, 1.5), {ByGraph{}, Baumgarte{}});
     },
     0xb1abebeaf0265586},
    {"PileBounces",
     [] {
       return after_ten_seconds(box_pile<PlaneBody>(7), {GaussSeidel{}, Baumgarte{}});
     },
     0xd5f985d85e72aebd},
    {"SpacePileBounces",
     [] {
       return after_ten_seconds(box_pile<SpaceBody>(7), {GaussSeidel{}, Baumgarte{}});
     },
     0x75bd2fa9321daf73},
    {"SpacePileByGraph",
     [] {
       return after_ten_seconds(box_pile<SpaceBody>(8), {ByGraph{}, Baumgarte{}});
     },
     0xf9f38a93e2e14ff1},
};

class ContactDeterminism : public testing::TestWithParam<Case> {};

TEST_P(ContactDeterminism, EndsInTheNumberWrittenDown) { expect_hash(GetParam()); }

INSTANTIATE_TEST_SUITE_P(, ContactDeterminism, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace determinism_contacts_test
