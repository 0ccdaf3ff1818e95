// The time left is that of the rest at the pace so far.

#include "lessons/tutor/progress.hpp"

#include <gtest/gtest.h>

namespace byhand::tutor {
namespace {

TEST(TimeLeft, IsThatOfTheRestAtThePaceSoFar) {
  EXPECT_EQ(time_left(10, 1, 5), "40 s left");
  EXPECT_EQ(time_left(10, 4, 5), "3 s left") << "rounded up: nothing takes 0 s";
  EXPECT_EQ(time_left(1, 1, 100), "99 s left");
  EXPECT_EQ(time_left(1, 1, 122), "3 min left");
}

TEST(TimeLeft, IsUnknownBeforeTheFirstPieceAndNoneAfterTheLast) {
  EXPECT_EQ(time_left(10, 0, 5), "");
  EXPECT_EQ(time_left(10, 0, 0), "");
  EXPECT_EQ(time_left(10, 5, 5), "");
}

}  // namespace
}  // namespace byhand::tutor
