#include "renderer/chart.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "tests/renderer/coverage.hpp"
#include "tests/renderer/scenes.hpp"

namespace byhand::renderer {
namespace {

using scenes::infinity;
using scenes::nan;

int difference(Colour a, Colour b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b); }

// How many pixels of `area` (points) have about this colour.
int count(const Canvas& canvas, const Image& image, const Rectangle& area, Colour colour) {
  const auto [left, bottom] = pixel_of(canvas, {area.x, area.y});
  const auto [right, top] = pixel_of(canvas, {area.right(), area.top()});
  int found = 0;
  for (int y = std::max(top, 0); y <= std::min(bottom, image.height - 1); ++y)
    for (int x = std::max(left, 0); x <= std::min(right, image.width - 1); ++x) {
      const Colour c = colour_at(image, {x, y});
      found += difference(c, colour) < 24;
    }
  return found;
}

// The border of a thin line or a marker is mixed with what lies beside it.
bool nearer_than_paper(Colour seen, Colour expected) {
  return difference(seen, expected) < difference(seen, palette::paper);
}

Chart line_of(std::vector<double> x, std::vector<double> y) {
  Chart chart;
  chart.curves = {{.x = std::move(x), .y = std::move(y)}};
  return chart;
}

TEST(ChartRanges, HoldTheFiniteDataAndNothingElse) {
  const ChartRanges r = ranges(line_of({1, 2, 3, 4, nan}, {5, nan, infinity, 9, 1000}));
  EXPECT_EQ(r.x, std::pair(1.0, 4.0));
  EXPECT_LT(r.y.first, 5);
  EXPECT_GT(r.y.first, 4);
  EXPECT_GT(r.y.second, 9);
  EXPECT_LT(r.y.second, 10);
}

TEST(ChartRanges, OfOneValueAreNotEmpty) {
  for (const double v : {0.0, -3.0, 1e-8}) {
    const ChartRanges r = ranges(line_of({v}, {v}));
    EXPECT_LT(r.y.first, r.y.second);
    EXPECT_LE(r.y.first, v);
    EXPECT_GE(r.y.second, v);
  }
  const ChartRanges nothing = ranges({});
  EXPECT_LT(nothing.x.first, nothing.x.second);
}

TEST(ChartRanges, OfBarsAndStemsHoldZero) {
  Chart bars;
  bars.bar_names = {"a", "b"};
  bars.bars = {{.values = {5, 7}}};
  EXPECT_EQ(ranges(bars).y.first, 0);
  Chart stems = line_of({1, 2}, {-5, -7});
  stems.curves[0].style = CurveStyle::stems;
  EXPECT_EQ(ranges(stems).y.second, 0);
}

TEST(ChartRanges, OnALogarithmicAxisSkipWhatHasNoLogarithm) {
  Chart chart = line_of({1, 2, 3}, {0, 1e-3, -5});
  chart.y.scale = Scale::logarithmic;
  EXPECT_GT(ranges(chart).y.first, 0);
  EXPECT_LE(ranges(chart).y.first, 1e-3);
  chart = line_of({1, 2}, {0, -1});
  chart.y.scale = Scale::logarithmic;
  EXPECT_THROW(ranges(chart), std::invalid_argument);
}

TEST(ChartRanges, RefuseLengthsThatDiffer) {
  EXPECT_THROW(ranges(line_of({1, 2}, {1})), std::invalid_argument);
  Chart labels = line_of({1, 2}, {1, 2});
  labels.curves[0].point_labels = {"one"};
  EXPECT_THROW(ranges(labels), std::invalid_argument);
  Chart bars;
  bars.bar_names = {"a"};
  bars.bars = {{.values = {1, 2}}};
  EXPECT_THROW(ranges(bars), std::invalid_argument);
  Chart map;
  map.heat_map = HeatMap{.x = {1, 2}, .y = {1}, .values = {1}};
  EXPECT_THROW(ranges(map), std::invalid_argument);
  Chart empty = line_of({1, 2}, {1, 2});
  empty.x.range = std::pair(3.0, 3.0);
  EXPECT_THROW(ranges(empty), std::invalid_argument);
}

TEST(Chart, ACurvePassesThroughItsPoints) {
  PixelCanvas canvas(960, 540);
  for (const bool logarithmic : {false, true}) {
    canvas.clear();
    Chart chart = line_of({1, 10, 100}, {1, 10, 100});
    chart.x.range = chart.y.range = std::pair(0.5, 200.0);
    chart.x.scale = chart.y.scale = logarithmic ? Scale::logarithmic : Scale::linear;
    const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
    const double share = logarithmic ? std::log(10 / 0.5) / std::log(200 / 0.5) : (10 - 0.5) / (200 - 0.5);
    const Point at(plot.x + share * plot.width, plot.y + share * plot.height);
    EXPECT_TRUE(nearer_than_paper(colour_at(canvas.image(), pixel_of(canvas, at)), palette::series(0)))
        << logarithmic;
  }
}

TEST(Chart, AReversedAxisRunsTheOtherWay) {
  PixelCanvas canvas(960, 540);
  Chart chart = line_of({0, 1}, {0.9, 0.9});
  chart.y.range = std::pair(0.0, 1.0);
  chart.y.reversed = true;
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const Point at(plot.centre().x(), plot.y + 0.1 * plot.height);
  EXPECT_TRUE(nearer_than_paper(colour_at(canvas.image(), pixel_of(canvas, at)), palette::series(0)));
}

TEST(Chart, AFailedRunIsACrossAtTheEdgeOnItsSide) {
  PixelCanvas canvas(960, 540);
  for (const double bad : {infinity, -infinity}) {
    canvas.clear();
    Chart chart = line_of({0, 1, 2}, {1, bad, 1});
    chart.curves[0].style = CurveStyle::markers;
    const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
    const Rectangle top{plot.centre().x() - 30, plot.top() - 20, 60, 20},
        bottom{plot.centre().x() - 30, plot.y, 60, 20};
    const Image image = canvas.image();
    const int above = count(canvas, image, top, palette::series(0)),
              below = count(canvas, image, bottom, palette::series(0));
    EXPECT_EQ(above > 10, bad > 0);
    EXPECT_EQ(below > 10, bad < 0);
  }
}

TEST(Chart, AFailedRunSaysWhy) {
  PixelCanvas canvas(960, 540);
  for (const bool says : {false, true}) {
    canvas.clear();
    Chart chart = line_of({0, 1, infinity}, {1, 2, 1.5});
    chart.curves[0].style = CurveStyle::markers;
    if (says) chart.curves[0].point_labels = {"", "", "explodes"};
    const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
    const Image image = canvas.image();
    int letters = 0;
    for (double x = plot.right() - 90; x < plot.right() - 18; ++x)
      for (double y = plot.centre().y() - 40; y < plot.centre().y() + 40; ++y)
        letters += nearer_than_paper(colour_at(image, pixel_of(canvas, {x, y})), palette::series(0));
    EXPECT_EQ(letters > 20, says);
  }
}

TEST(Chart, AFrontIsLevelFromAPointAndThenUpright) {
  PixelCanvas canvas(960, 540);
  Chart chart = line_of({0, 1}, {2, 1});
  chart.curves[0].style = CurveStyle::front;
  chart.curves[0].colour = palette::series(0);
  chart.x.range = chart.y.range = std::pair(-1.0, 3.0);
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const Image image = canvas.image();
  const auto at = [&](double x, double y) {
    return colour_at(image,
                     pixel_of(canvas, {plot.x + (x + 1) / 4 * plot.width, plot.y + (y + 1) / 4 * plot.height}));
  };
  EXPECT_EQ(at(0.4, 2), palette::series(0));
  EXPECT_EQ(at(1, 1.4), palette::series(0));
  EXPECT_EQ(at(0.4, 1.6), palette::paper) << "not straight across";
  EXPECT_EQ(at(0.1, 1.4), palette::paper) << "not upright first";
}

TEST(Chart, NanLeavesAGap) {
  PixelCanvas canvas(960, 540);
  const Rectangle plot =
      draw(canvas, line_of({0, 1, 2, 3, 4, 5}, {1, 1, nan, nan, 1, 1}), canvas.page().inset(40));
  const Image image = canvas.image();
  const Rectangle gap{plot.x + 0.25 * plot.width, plot.y, 0.5 * plot.width, plot.height};
  EXPECT_EQ(count(canvas, image, gap, palette::series(0)), 0);
  EXPECT_GT(count(canvas, image, plot, palette::series(0)), 100);
}

TEST(Chart, NothingOfACurveLeavesTheAxes) {
  PixelCanvas canvas(960, 540);
  Chart chart = line_of({-10, 0.5, 1, 11}, {-1e6, 1e9, -1e9, 1e6});
  chart.x.range = chart.y.range = std::pair(0.0, 1.0);
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const Image image = canvas.image();
  EXPECT_EQ(count(canvas, image, canvas.page(), palette::series(0)),
            count(canvas, image, plot.inset(-3), palette::series(0)));
  EXPECT_GT(count(canvas, image, plot, palette::series(0)), 100);
}

TEST(Chart, ACellOfAHeatMapHasTheColourOfItsValue) {
  PixelCanvas canvas(960, 540);
  Chart chart;
  chart.heat_map = HeatMap{.x = {0, 1, 2}, .y = {0, 1}, .values = {0, 1, 2, 3, nan, infinity}};
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const Image image = canvas.image();
  const auto cell = [&](int column, int row) {
    const Point at(plot.x + (column + 0.15) / 3 * plot.width, plot.y + (row + 0.15) / 2 * plot.height);
    return colour_at(image, pixel_of(canvas, at));
  };
  EXPECT_EQ(cell(0, 0), palette::sequential(0));
  EXPECT_EQ(cell(1, 0), palette::sequential(43 / 128.0)) << "the nearest of 129 shades";
  EXPECT_EQ(cell(0, 1), palette::sequential(1));
  EXPECT_EQ(cell(1, 1), palette::paper) << "NaN is empty";
  EXPECT_EQ(cell(2, 1), palette::fixed) << "a failed run is crossed out";
}

TEST(Chart, ACellOfAMapOfClassesHasTheColourOfItsClassAndTheLegendShowsAll) {
  PixelCanvas canvas(960, 540);
  Chart chart;
  chart.heat_map = HeatMap{.x = {0, 1}, .y = {0, 1}, .values = {1, 0, nan, infinity}};
  chart.heat_map->classes = {{"calm", palette::force}, {"wild", palette::velocity}, {"never", palette::highlight}};
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const Image image = canvas.image();
  const auto cell = [&](int column, int row) {
    const Point at(plot.x + (column + 0.15) / 2 * plot.width, plot.y + (row + 0.15) / 2 * plot.height);
    return colour_at(image, pixel_of(canvas, at));
  };
  EXPECT_EQ(cell(0, 0), palette::velocity);
  EXPECT_EQ(cell(1, 0), palette::force);
  EXPECT_EQ(cell(0, 1), palette::paper);
  EXPECT_EQ(cell(1, 1), palette::fixed);
  const Rectangle above{0, plot.top() + 2, canvas.page().width, canvas.page().height - plot.top() - 2};
  for (const CellClass& each : chart.heat_map->classes)
    EXPECT_GT(count(canvas, image, above, each.colour), 60) << each.name;
  EXPECT_EQ(class_name(*chart.heat_map, 1), "wild");
  EXPECT_EQ(class_name(*chart.heat_map, nan), "");
}

TEST(Chart, AMapRefusesAClassThatItDoesNotHave) {
  for (const double value : {-1.0, 2.0, 0.5}) {
    Chart chart;
    chart.heat_map = HeatMap{.x = {0}, .y = {0}, .values = {value}, .classes = {{"a", {}}, {"b", {}}}};
    EXPECT_THROW(ranges(chart), std::invalid_argument) << value;
  }
}

TEST(Chart, CellEdgesLieHalfwayOnTheAxis) {
  EXPECT_EQ(cell_edges({1, 2, 4}, Scale::linear), (std::vector{0.5, 1.5, 3.0, 5.0}));
  const std::vector<double> logarithmic = cell_edges({1, 4, 16}, Scale::logarithmic);
  const std::vector<double> expected{0.5, 2, 8, 32};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(logarithmic[i], expected[i], 1e-12);
  EXPECT_EQ(cell_edges({3}, Scale::linear).size(), 2u);
}

TEST(Chart, ADivergingMapIsSymmetricAboutZero) {
  EXPECT_EQ(value_range({.values = {-1, 5, 2}, .diverging = true}), std::pair(-5.0, 5.0));
  EXPECT_EQ(value_range({.values = {-1, 5, infinity}}), std::pair(-1.0, 5.0));
}

TEST(Chart, BarsAreAsHighAsTheirValues) {
  PixelCanvas canvas(960, 540);
  Chart chart;
  chart.bar_names = {"a", "b"};
  chart.bars = {{.values = {2, 4}}};
  chart.y.range = std::pair(0.0, 5.0);
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const Image image = canvas.image();
  const auto top_of = [&](double share) {
    for (double y = plot.top(); y > plot.y; y -= 0.5)
      if (colour_at(image, pixel_of(canvas, {plot.x + share * plot.width, y})) == palette::series(0))
        return (y - plot.y) / plot.height * 5;
    return 0.0;
  };
  EXPECT_NEAR(top_of(0.6 / 2.2), 2, 0.03);
  EXPECT_NEAR(top_of(1.6 / 2.2), 4, 0.03);
}

// Wherever the legend goes, every point of every curve can still be seen.
TEST(Chart, TheLegendCoversNoCurve) {
  PixelCanvas canvas(960, 540);
  for (int shape = 0; shape < 6; ++shape) {
    canvas.clear();
    Chart chart;
    std::vector<Point> expected;
    for (int k = 0; k < 3; ++k) {
      Curve curve{.label = "curve number " + std::to_string(k), .style = CurveStyle::markers};
      for (int i = 0; i <= 20; ++i) {
        const double x = i / 20.0, wiggle = std::sin(7 * x + k);
        const std::array ys{x + 0.1 * k,           1 - x + 0.1 * k, wiggle, x * x * k, std::abs(x - 0.5) + 0.1 * k,
                            0.5 + 0.4 * wiggle * x};
        curve.x.push_back(x), curve.y.push_back(ys[shape]);
      }
      chart.curves.push_back(curve);
    }
    const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
    const ChartRanges r = ranges(chart);
    const Image image = canvas.image();
    for (int k = 2; k >= 0; --k)
      for (std::size_t i = 0; i < chart.curves[k].x.size(); ++i) {
        const double x = (chart.curves[k].x[i] - r.x.first) / (r.x.second - r.x.first);
        const double y = (chart.curves[k].y[i] - r.y.first) / (r.y.second - r.y.first);
        const Colour c = colour_at(image, pixel_of(canvas, {plot.x + x * plot.width, plot.y + y * plot.height}));
        bool marker = false;
        for (int other = 0; other < 3; ++other) marker = marker || nearer_than_paper(c, palette::series(other));
        EXPECT_TRUE(marker) << "shape " << shape << ", curve " << k << ", point " << i;
      }
  }
}

// What a canvas lists of the labels of a chart.
std::vector<Label> labels_of(const Chart& chart) {
  PixelCanvas canvas(960, 540);
  canvas.list_labels();
  draw(canvas, chart, canvas.page().inset(40));
  return canvas.labels();
}

const Label* find(const std::vector<Label>& labels, const std::string& text) {
  const auto found = std::find_if(labels.begin(), labels.end(), [&](const Label& l) { return l.text == text; });
  return found == labels.end() ? nullptr : &*found;
}

// The marks of several runs with a law for each: two dashed lines of one colour.
Chart two_laws() {
  Chart chart;
  for (const double slope : {0.2, 1.0}) {
    Curve law{.label = slope < 1 ? "flat law" : "steep law", .style = CurveStyle::theory};
    Curve run{.label = slope < 1 ? "flat run" : "steep run", .style = CurveStyle::markers};
    for (int i = 0; i <= 10; ++i) {
      law.x.push_back(0.1 * i), law.y.push_back(slope * 0.1 * i * i);
      if (i % 3 == 0) run.x.push_back(law.x.back()), run.y.push_back(law.y.back());
    }
    chart.curves.push_back(law);
    chart.curves.push_back(run);
  }
  return chart;
}

TEST(Chart, LabelsALawBesideItsLineAndNoOther) {
  const Chart chart = two_laws();
  const std::vector<Label> labels = labels_of(chart);
  PixelCanvas canvas(960, 540);
  const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
  const ChartRanges r = ranges(chart);
  const auto nearest = [&](const Curve& curve, const Rectangle& box) {
    double least = 1e9;
    for (double t = 0; t < 10; t += 0.01) {
      const std::size_t i = std::size_t(t);
      const double x = curve.x[i] + (t - double(i)) * (curve.x[i + 1] - curve.x[i]);
      const double y = curve.y[i] + (t - double(i)) * (curve.y[i + 1] - curve.y[i]);
      const Point p(plot.x + (x - r.x.first) / (r.x.second - r.x.first) * plot.width,
                    plot.y + (y - r.y.first) / (r.y.second - r.y.first) * plot.height);
      least = std::min(least, std::hypot(std::max({box.x - p.x(), p.x() - box.right(), 0.0}),
                                         std::max({box.y - p.y(), p.y() - box.top(), 0.0})));
    }
    return least;
  };
  for (const int mine : {0, 2}) {
    const Label* label = find(labels, chart.curves[std::size_t(mine)].label);
    ASSERT_NE(label, nullptr);
    const double own = nearest(chart.curves[std::size_t(mine)], label->box);
    EXPECT_GT(own, 0);
    EXPECT_LT(own, 16);
    EXPECT_GT(nearest(chart.curves[std::size_t(2 - mine)], label->box), 1.8 * own);
  }
  const Label *first = find(labels, "flat run"), *second = find(labels, "steep run");
  ASSERT_TRUE(first && second);
  EXPECT_NEAR(first->box.x, second->box.x, 1e-9) << "marks without a line are named in a legend";
}

TEST(Chart, NamesCurvesThatLieOnEachOtherInALegend) {
  Chart chart = two_laws();
  chart.curves[2].y = chart.curves[0].y;
  const std::vector<Label> labels = labels_of(chart);
  const Label *first = find(labels, "flat law"), *second = find(labels, "steep law");
  ASSERT_TRUE(first && second);
  EXPECT_NEAR(first->box.x, second->box.x, 1e-9);
}

TEST(Chart, AGrowingChartHasTheLayoutOfTheWhole) {
  for (Chart chart : {scenes::damped_oscillation(), scenes::stems(), two_laws()}) {
    const std::vector<Label> whole = labels_of(chart);
    const double last = ranges(chart).x.second;
    for (const double share : {-0.1, 0.0, 0.3, 0.9, 1.0}) {
      chart.until = share * last;
      const std::vector<Label> labels = labels_of(chart);
      ASSERT_EQ(labels.size(), whole.size()) << chart.title << " at " << share;
      for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_EQ(labels[i].text, whole[i].text);
        EXPECT_EQ(labels[i].box.x, whole[i].box.x);
        EXPECT_EQ(labels[i].box.y, whole[i].box.y);
      }
    }
  }
}

TEST(Chart, AGrowingCurveEndsBetweenItsPointsAtTheTimeThatIsShown) {
  PixelCanvas canvas(960, 540);
  Chart chart{.curves = {{.x = {0, 1}, .y = {0, 1}}}};
  for (const double until : {0.2, 0.55, 0.9}) {
    canvas.clear();
    chart.until = until;
    const Rectangle plot = draw(canvas, chart, canvas.page().inset(40));
    const Image image = canvas.image();
    const auto is_drawn = [&](double share) {
      return nearer_than_paper(
          colour_at(image, pixel_of(canvas, {plot.x + share * plot.width,
                                             plot.y + (share - ranges(chart).y.first) * plot.height /
                                                          (ranges(chart).y.second - ranges(chart).y.first)})),
          palette::series(0));
    };
    EXPECT_TRUE(is_drawn(until - 0.01));
    EXPECT_FALSE(is_drawn(until + 0.03));
  }
}

TEST(Chart, RefusesAFrameWithoutRoom) {
  PixelCanvas canvas(320, 180);
  EXPECT_THROW(draw(canvas, scenes::two_orders(), {0, 0, 40, 30}), std::invalid_argument);
}

TEST(Chart, LeavesTheCameraAsItWas) {
  PixelCanvas canvas(320, 180);
  const Camera camera = fit({0, 0, 3, 2}, canvas.page());
  canvas.look(camera);
  draw(canvas, scenes::two_orders(), canvas.page());
  EXPECT_EQ(canvas.camera().scale, camera.scale);
}

TEST(Chart, EveryKindFitsIntoASmallFrame) {
  PixelCanvas canvas(960, 540);
  for (const Chart& chart : {scenes::two_orders(), scenes::joint_forces(), scenes::stable_region(),
                             scenes::sparse_matrix(), scenes::stems(), scenes::damped_oscillation()}) {
    canvas.clear(white);
    const Rectangle frame{300, 200, 380, 240};
    const Rectangle plot = draw(canvas, chart, frame);
    EXPECT_GT(plot.width, 90) << chart.title;
    EXPECT_GT(plot.height, 80) << chart.title;
    const Ink drawn = ink(canvas.image(), 0.02);
    EXPECT_GE(drawn.left, frame.x * 0.75 - 2) << chart.title;
    EXPECT_LE(drawn.right, frame.right() * 0.75 + 2) << chart.title;
    EXPECT_GE(drawn.top, 540 - frame.top() * 0.75 - 2) << chart.title;
    EXPECT_LE(drawn.bottom, 540 - frame.y * 0.75 + 2) << chart.title;
  }
}

}  // namespace
}  // namespace byhand::renderer
