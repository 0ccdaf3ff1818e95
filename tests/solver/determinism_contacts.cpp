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
     {0x16b06a801e7d0dc3,
      "36 rows laid out, 600 solves, 612 passes, 21600 rows prepared, 84244 row solves, 888 numbers read in "
      "plans"}},
    {"StackRedBlack",
     [] {
       return after_ten_seconds(kicked_stack(12), {GaussSeidel{20, true, SweepOrder::coloured}, Baumgarte{}});
     },
     {0x684a027b4e23b6ca, "396 rows laid out, 600 solves, 12000 passes, 21600 rows prepared, 432000 row solves"}},
    {"PyramidByGraph",
     [] {
       return after_ten_seconds(pyramid(8), {ByGraph{}, Baumgarte{}});
     },
     {0xf8644e7e41ab6be0,
      "192 rows laid out, 600 solves, 30000 passes, 115200 rows prepared, 5760000 row solves"}},
    {"DominoesByGraph",
     [] {
       return after_ten_seconds(dominoes(8, 0.5, 1.5), {ByGraph{}, Baumgarte{}});
     },
     {0x3cb1b6a51b9029fe, "954 rows laid out, 600 solves, 6504 passes, 25401 rows prepared, 362632 row solves"}},
    {"PileBounces",
     [] {
       return after_ten_seconds(box_pile<PlaneBody>(7), {GaussSeidel{}, Baumgarte{}});
     },
     {0xd5f985d85e72aebd, "1467 rows laid out, 662 solves, 6620 passes, 17442 rows prepared, 174420 row solves"}},
    {"SpacePileBounces",
     [] {
       return after_ten_seconds(box_pile<SpaceBody>(7), {GaussSeidel{}, Baumgarte{}});
     },
     {0x75bd2fa9321daf73, "4482 rows laid out, 730 solves, 7300 passes, 35193 rows prepared, 351930 row solves"}},
    {"SpacePileByGraph",
     [] {
       return after_ten_seconds(box_pile<SpaceBody>(8), {ByGraph{}, Baumgarte{}});
     },
     {0x29717a7b776cee85, "5178 rows laid out, 705 solves, 7862 passes, 36876 rows prepared, 874212 row solves"}},
};

class ContactDeterminism : public testing::TestWithParam<Case> {};

TEST_P(ContactDeterminism, EndsInTheNumberWrittenDown) { expect_end(GetParam()); }

INSTANTIATE_TEST_SUITE_P(, ContactDeterminism, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace determinism_contacts_test
