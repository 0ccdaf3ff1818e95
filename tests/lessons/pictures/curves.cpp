#include "lessons/pictures/curves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace byhand;
using testing::ElementsAre;

struct Sample {
  double time, angle;
  double degrees() const { return 100 * angle; }
};
const std::vector<Sample> run = {{0, 0.5}, {0.1, 0.25}, {0.2, -0.5}};

TEST(Curve, OfAFunctionHasEqualIntervalsAndBothEnds) {
  const auto square = [](double x) { return x * x; };
  const renderer::Curve curve = pictures::curve("x²", 1, 3, square, 4);
  EXPECT_EQ(curve.label, "x²");
  EXPECT_THAT(curve.x, ElementsAre(1, 1.5, 2, 2.5, 3));
  EXPECT_THAT(curve.y, ElementsAre(1, 2.25, 4, 6.25, 9));
  EXPECT_EQ(curve.style, renderer::CurveStyle::line);
  EXPECT_EQ(pictures::theory("x²", 1, 3, square, 4).style, renderer::CurveStyle::theory);
}

TEST(Curve, OfARunTakesMembersAndFunctions) {
  const renderer::Curve curve =
      pictures::curve("rod", run, &Sample::time, [](const Sample& s) { return 2 * s.angle; });
  EXPECT_THAT(curve.x, ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(curve.y, ElementsAre(1, 0.5, -1));
  EXPECT_THAT(pictures::each(run, &Sample::degrees), ElementsAre(50, 25, -50));
}

TEST(Run, ShowsTheLastSampleThatHasCome) {
  EXPECT_EQ(pictures::at(run, -1).angle, 0.5);
  EXPECT_EQ(pictures::at(run, 0.05).angle, 0.5);
  EXPECT_EQ(pictures::at(run, 0.1).angle, 0.25);
  EXPECT_EQ(pictures::at(run, 0.1 - 1e-12).angle, 0.25) << "times add up with rounding";
  EXPECT_EQ(pictures::at(run, 9).angle, -0.5);
}

}  // namespace
