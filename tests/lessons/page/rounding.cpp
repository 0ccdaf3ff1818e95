#include "lessons/page/rounding.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace byhand::tests {
namespace {

using namespace byhand::course;

TEST(WithoutRounding, IsZeroForRoundingAloneAndTheValueBeyond) {
  EXPECT_EQ(without_rounding(0.99e-13, 1), 0);
  EXPECT_EQ(without_rounding(-1.01e-13, 1), -1.01e-13);
  EXPECT_EQ(without_rounding(-5.0, 20), -5.0);
  EXPECT_EQ(without_rounding(3e-15, 100), 0) << "measured by the size of what was added up";
}

TEST(WithoutRounding, ComparesAVectorsComponentsWithItsLargest) {
  const Eigen::Vector2d hanging = without_rounding(Eigen::Vector2d(2.4e-16, -2));
  EXPECT_EQ(hanging, Eigen::Vector2d(0, -2));
  const Eigen::Vector2d small(2.4e-16, -2e-16);
  EXPECT_EQ(without_rounding(small), small);
}

TEST(SmallError, HasANumberDownToTenToTheMinusEleven) {
  EXPECT_EQ(small_error(0.99e-11).plain(), "less than 10⁻¹¹");
  EXPECT_EQ(small_error(0).plain(), "less than 10⁻¹¹");
  EXPECT_EQ(small_error(1.04e-11).plain(), "10⁻¹¹");
  EXPECT_EQ(small_error(-0.25).plain(), "−0.25");
}

}  // namespace
}  // namespace byhand::tests
