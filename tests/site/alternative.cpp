#include "lessons/page/html/alternative.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lessons/page/chart_words.hpp"

namespace byhand::tests {
namespace {

using course::Figure;
using renderer::Chart;
using site::alternative;

std::string label(Chart chart) { return alternative(Figure{"name", "caption", std::move(chart)}, "").label; }

Chart chart(std::vector<renderer::Curve> curves) {
  return {.x = {.label = "β (1)"}, .y = {.label = "error (m)"}, .curves = std::move(curves)};
}

TEST(Alternative, OfACurveSaysWhereItBeginsAndEndsAndItsExtremesBetween) {
  EXPECT_EQ(label(chart({{.label = "run", .x = {0, 1, 2}, .y = {0.16, 0.01, 5e-6}}})),
            "Chart of error (m) over β (1). run: from 0.16 to 5·10⁻⁶");
  EXPECT_EQ(label(chart({{.label = "run", .x = {0, 1, 2}, .y = {1, 7, 2}}})),
            "Chart of error (m) over β (1). run: from 1 to 2, at most 7");
  EXPECT_EQ(label(chart({{.label = "run", .x = {0, 1, 2}, .y = {1, -7, 2}}})),
            "Chart of error (m) over β (1). run: from 1 to 2, at least −7");
}

TEST(Alternative, CallsACurveWithoutANameACurveAndTellsItAfterTheOthers) {
  EXPECT_EQ(label(chart({{.x = {0, 1}, .y = {1, 2}}})), "Chart of error (m) over β (1). a curve: from 1 to 2");
  EXPECT_EQ(label(chart({{.x = {0, 1}, .y = {1, 2}}, {.label = "run", .x = {0, 1}, .y = {3, 4}}})),
            "Chart of error (m) over β (1). run: from 3 to 4; a curve: from 1 to 2");
  EXPECT_EQ(
      label(chart(
          {{.x = {0, 1}, .y = {1, 2}}, {.x = {0, 1}, .y = {1, 3}}, {.label = "run", .x = {0, 1}, .y = {3, 4}}})),
      "Chart of error (m) over β (1). run: from 3 to 4; 2 lines without a name");
}

TEST(Alternative, OfAMapOfClassesCountsTheCellsOfEach) {
  Chart map = chart({});
  map.heat_map = renderer::HeatMap{.x = {1, 2}, .y = {1, 2}, .values = {0, 1, 1, 1}};
  map.heat_map->label = "end";
  map.heat_map->classes = {{"stands"}, {"falls"}, {"rings"}};
  EXPECT_EQ(label(map), "Chart of end over β (1) and error (m). stands: 1 cell; falls: 3 cells");
}

TEST(Alternative, CallsRoundingZero) {
  EXPECT_NE(course::chart_in_words(chart({{.label = "sine", .x = {0, 1, 2}, .y = {0, 1, 1.2e-16}}}))
                .find("from (0, 0) to (2, 0)"),
            std::string::npos);
  EXPECT_NE(
      course::chart_in_words(chart({{.label = "tiny", .x = {0, 1}, .y = {0, 1.2e-16}}})).find("to (1, 1.2·10⁻¹⁶)"),
      std::string::npos);
  EXPECT_EQ(label(chart({{.label = "sine", .x = {0, 1, 2}, .y = {0, 1, 1.2e-16}}})),
            "Chart of error (m) over β (1). sine: from 0 to 0, at most 1");
}

TEST(Alternative, LeavesFailedRunsOutAndCountsWhatDoesNotFit) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(label(chart({{.label = "run", .x = {0, 1}, .y = {inf, 2}}})), "Chart of error (m) over β (1). run: 2");
  EXPECT_EQ(label(chart({{.label = "run", .x = {0}, .y = {inf}}})),
            "Chart of error (m) over β (1). run: no finite value");
  const renderer::Curve one{.label = "c", .x = {0, 1}, .y = {1, 2}};
  EXPECT_EQ(
      label(chart({one, one, one, one, one, one})),
      "Chart of error (m) over β (1). c: from 1 to 2; c: from 1 to 2; c: from 1 to 2; c: from 1 to 2; and 2 more");
}

TEST(Alternative, OfADrawingIsWhatIsWrittenInItWithoutTheNumbersOfAxes) {
  const Figure drawing{"name", "caption", course::Drawing([](renderer::Canvas&) {})};
  EXPECT_EQ(alternative(drawing,
                        "<svg><text x=\"1\">P<tspan>1</tspan></text><text>0.5</text><text>−10</text>"
                        "<text>C &lt; 0</text><text>C &lt; 0</text></svg>")
                .label,
            "Written in it: P1; C < 0");
  EXPECT_EQ(alternative(drawing, "<svg></svg>").label, "");
  EXPECT_EQ(alternative(drawing, "<svg><text>The rod is at a right</text><text>angle to v.</text></svg>").label,
            "Written in it: The rod is at a right angle to v.");
}

TEST(Alternative, OfRunningTimesHasNoNumbers) {
  const Figure clocked{"name", "caption", course::TimedChart{[]() -> const Chart& { throw 0; }}};
  EXPECT_EQ(alternative(clocked, "").label.find_first_of("0123456789"), std::string::npos);
}

}  // namespace
}  // namespace byhand::tests
