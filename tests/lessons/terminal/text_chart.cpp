// Charts in characters, and the same charts as data.

#include "lessons/terminal/text_chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "lessons/files/chart_data.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;
using renderer::Chart;
using renderer::Curve;
using renderer::CurveStyle;
using testing::HasSubstr;

Curve curve(std::string label, std::vector<double> x, std::vector<double> y, CurveStyle style = CurveStyle::line) {
  Curve made;
  made.label = std::move(label);
  made.x = std::move(x);
  made.y = std::move(y);
  made.style = style;
  return made;
}

Chart powers() {
  Chart chart;
  chart.x = {.label = "h (s)", .scale = renderer::Scale::logarithmic};
  chart.y = {.label = "error (m)", .scale = renderer::Scale::logarithmic};
  Curve first = curve("first order", {}, {}), second = curve("second order", {}, {}, CurveStyle::theory);
  for (double h = 1e-3; h < 1; h *= 2) {
    first.x.push_back(h);
    first.y.push_back(h);
    second.x.push_back(h);
    second.y.push_back(h * h);
  }
  chart.curves = {first, second};
  return chart;
}

Chart map() {
  Chart chart;
  chart.x.label = "sweeps (1)";
  chart.y.label = "beta (1)";
  chart.heat_map = renderer::HeatMap{};
  chart.heat_map->label = "C (m)";
  chart.heat_map->x = {1, 2, 4};
  chart.heat_map->y = {0.1, 0.2};
  chart.heat_map->values = {0, 1, 2, 3, std::numeric_limits<double>::infinity(), std::nan("")};
  return chart;
}

Chart shares() {
  Chart chart;
  chart.y.label = "share (1)";
  chart.bar_names = {"top", "bottom"};
  chart.bars = {{.label = "one sweep", .values = {0.1, 1}, .colour = {}},
                {.label = "exact", .values = {1, 1}, .colour = {}}};
  return chart;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(TextChart, FitsEightyColumnsWithOrWithoutColours) {
  for (const Chart& chart : {powers(), map(), shares()})
    for (const Style& style : {Style{80, false}, Style{80, true}, Style{40, false}})
      for (const std::string& line : lines_of(text_chart(chart, style)))
        EXPECT_LE(display_width(line), style.width) << line;
}

TEST(TextChart, NamesTheClassesOfAMap) {
  Chart chart = map();
  chart.heat_map->label = "how it ends";
  chart.heat_map->values = {0, 1, 2, 0, 1, 2};
  chart.heat_map->classes = {{"settles", {}}, {"rings", {}}, {"explodes", {}}};
  EXPECT_THAT(text_chart(chart, {}), HasSubstr("how it ends: · settles, ▒ rings, █ explodes"));
}

TEST(TextChart, IsAboutTwentyLines) { EXPECT_LE(lines_of(text_chart(powers(), {})).size(), 22u); }

TEST(TextChart, NamesAxesCurvesAndTicks) {
  const std::string text = text_chart(powers(), {});
  for (const char* words : {"error (m)", "h (s)", "• first order", "· second order", "10⁻²", "┤", "┬"})
    EXPECT_THAT(text, HasSubstr(words));
}

TEST(TextChart, AStraightLineOfSlopeOneRisesFromCornerToCorner) {
  std::vector<int> columns;  // of the left-most mark in each row that has one, from the top
  for (const std::string& line : lines_of(text_chart(powers(), {.rows = 40})))
    if (const auto at = line.find("•"); at != std::string::npos && line.find("order") == std::string::npos)
      columns.push_back(display_width(line.substr(0, at)));
  ASSERT_GE(columns.size(), 6u);
  EXPECT_TRUE(std::is_sorted(columns.rbegin(), columns.rend()));
  EXPECT_GT(columns.front(), columns.back() + 40);
}

TEST(TextChart, AFailedRunIsDrawnAtTheEdge) {
  Chart chart = powers();
  chart.curves[0].y.back() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(lines_of(text_chart(chart, {}))[1], HasSubstr("✗"));
  EXPECT_THAT(text_chart(map(), {}), HasSubstr("✗"));
}

TEST(TextChart, LongerBarsAreLargerValues) {
  const auto lines = lines_of(text_chart(shares(), {}));
  const auto length = [](const std::string& line, const std::string& sign) {
    size_t count = 0;
    for (size_t at = line.find(sign); at != std::string::npos; at = line.find(sign, at + 1)) ++count;
    return count;
  };
  EXPECT_NEAR(static_cast<double>(length(lines[3], "█")), 10.0 * static_cast<double>(length(lines[1], "█")), 5);
  EXPECT_THAT(lines[1], HasSubstr("top"));
  EXPECT_THAT(lines[1], HasSubstr("0.1"));
}

TEST(ChartData, CurvesThatShareXShareItsColumn) {
  const auto rows = lines_of(csv(powers()));
  EXPECT_EQ(rows[0], "h (s),first order: error (m),second order: error (m)");
  EXPECT_EQ(rows[1], "0.001,0.001,1e-06");
}

TEST(ChartData, OthersHaveTheirOwnAndShorterOnesEndEarly) {
  Chart chart;
  chart.x.label = "t (s)";
  chart.y.label = "C (m)";
  chart.curves = {curve("a, b", {0, 1}, {2, std::nan("")}), curve("c", {5}, {6})};
  const auto rows = lines_of(csv(chart));
  EXPECT_EQ(rows[0], "\"a, b: t (s)\",\"a, b: C (m)\",c: t (s),c: C (m)");
  EXPECT_EQ(rows[1], "0,2,5,6");
  EXPECT_EQ(rows[2], "1,,,");
}

TEST(ChartData, AMapIsARowForEachCell) {
  const auto rows = lines_of(csv(map()));
  EXPECT_EQ(rows[0], "sweeps (1),beta (1),C (m)");
  EXPECT_EQ(rows[3], "4,0.1,2");
  EXPECT_EQ(rows[5], "2,0.2,inf");
  EXPECT_EQ(rows[6], "4,0.2,");
}

TEST(ChartData, BarsAreARowForEachName) {
  const auto rows = lines_of(csv(shares()));
  EXPECT_EQ(rows[0], ",one sweep: share (1),exact: share (1)");
  EXPECT_EQ(rows[1], "top,0.1,1");
}

}  // namespace
}  // namespace byhand::tests
