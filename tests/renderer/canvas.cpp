#include "renderer/canvas.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numbers>

#include "tests/renderer/coverage.hpp"

namespace byhand::renderer {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A white page of 720 × 480 pixels: two thirds of a pixel a point.
class OnWhite : public testing::Test {
 protected:
  OnWhite() { canvas_.clear(white); }
  PixelCanvas canvas_{720, 480};
  const double pixels_ = 480 / 720.0;  // a point
};

TEST_F(OnWhite, ThePageIs720PointsHigh) {
  EXPECT_DOUBLE_EQ(canvas_.page().height, 720);
  EXPECT_DOUBLE_EQ(canvas_.page().width, 1080);
}

TEST_F(OnWhite, ADiscCoversPiRSquared) {
  canvas_.look(fit({-1, -1, 2, 2}, canvas_.page()));
  const double pixels_per_unit = canvas_.camera().scale * pixels_;
  for (const double r : {0.02, 0.1, 0.37, 0.9}) {
    canvas_.clear(white);
    canvas_.look(fit({-1, -1, 2, 2}, canvas_.page()));
    canvas_.disc({0.013, -0.027}, r, black_area);
    const double expected = pi * r * r * pixels_per_unit * pixels_per_unit;
    EXPECT_NEAR(ink(canvas_.image()).area / expected, 1, r < 0.05 ? 0.02 : 0.003) << "r = " << r;
  }
}

TEST_F(OnWhite, ATurnedBoxKeepsItsArea) {
  for (const double angle : {0.0, 0.3, pi / 4, 2.0}) {
    canvas_.clear(white);
    canvas_.look(fit({-1, -1, 2, 2}, canvas_.page()));
    canvas_.box({0.1, 0.05}, {0.8, 0.5}, angle, black_area);
    const double unit = canvas_.camera().scale * pixels_;
    EXPECT_NEAR(ink(canvas_.image()).area / (0.4 * unit * unit), 1, 0.003) << "angle " << angle;
  }
}

TEST_F(OnWhite, ALineCoversItsLengthTimesItsWidth) {
  for (const double width : {0.5, 1.0, 3.0, 12.0}) {
    canvas_.clear(white);
    canvas_.line({100, 120}, {700, 480}, {black, width});
    const double expected = std::hypot(600, 360) * width * pixels_ * pixels_;
    EXPECT_NEAR(ink(canvas_.image()).area / expected, 1, 0.02) << "width " << width;
  }
}

TEST_F(OnWhite, DashesLeaveGaps) {
  canvas_.line({100, 300}, {900, 300}, {black, 4});
  const double solid = ink(canvas_.image()).area;
  canvas_.clear(white);
  canvas_.line({100, 300}, {900, 300}, {black, 4, Dash::dashed});
  EXPECT_NEAR(ink(canvas_.image()).area / solid, 9 / 14.5, 0.03);
}

TEST_F(OnWhite, APointOfTheWorldAppearsWhereTheCameraSays) {
  const Camera camera = fit({-3, 2, 4, 5}, {600, 100, 400, 500});
  canvas_.look(camera);
  for (const Point& p : {Point(-3, 2), Point(0.7, 6.5), Point(-1, 4)}) {
    EXPECT_LE((camera.to_world(camera.to_page(p)) - p).norm(), 1e-12 * p.norm());
    canvas_.disc(p, 0.05, black_area);
    EXPECT_EQ(colour_at(canvas_.image(), pixel_of(canvas_, camera.to_page(p))), black);
  }
}

TEST(Camera, FitsAllOfTheBoxAndTouchesTwoMargins) {
  const Rectangle frame{100, 50, 640, 360};
  for (const Rectangle& world : {Rectangle{-1, -1, 2, 2}, Rectangle{5, -3, 40, 1}, Rectangle{0, 0, 0, 7}}) {
    const Camera camera = fit(world, frame, 30);
    const Point low = camera.to_page({world.x, world.y}), high = camera.to_page({world.right(), world.top()});
    const Rectangle inner = frame.inset(30 - 1e-9);
    EXPECT_TRUE(inner.contains(low));
    EXPECT_TRUE(inner.contains(high));
    EXPECT_NEAR(std::min(low.x() - frame.x, low.y() - frame.y), 30, 1e-9);
    EXPECT_LE((camera.to_page(world.centre()) - frame.centre()).norm(), 1e-12 * frame.centre().norm());
  }
}

TEST(Camera, RefusesAPointANanAndAFrameWithoutRoom) {
  EXPECT_THROW(fit({1, 1, 0, 0}, {0, 0, 100, 100}), std::invalid_argument);
  EXPECT_THROW(fit({nan, 1, 1, 1}, {0, 0, 100, 100}), std::invalid_argument);
  EXPECT_THROW(fit({0, 0, infinity, 1}, {0, 0, 100, 100}), std::invalid_argument);
  EXPECT_THROW(fit({0, 0, 1, 1}, {0, 0, 60, 100}, 32), std::invalid_argument);
}

TEST(Rectangle, BoundsHoldEveryPointAndRefuseNan) {
  const std::array points{Point(1, 2), Point(-3, 5), Point(0, -1)};
  const Rectangle box = bounds(points);
  EXPECT_EQ(box.x, -3);
  EXPECT_EQ(box.y, -1);
  EXPECT_EQ(box.right(), 1);
  EXPECT_EQ(box.top(), 5);
  EXPECT_THROW(bounds({}), std::invalid_argument);
  EXPECT_THROW(bounds(std::array{Point(1, nan)}), std::invalid_argument);
}

TEST(Rectangle, SplittingLosesOnlyTheGaps) {
  const Rectangle whole{10, 20, 300, 200};
  const auto [left, right] = whole.split_columns(0.25, 20);
  EXPECT_DOUBLE_EQ(left.width, 70);
  EXPECT_DOUBLE_EQ(right.x, left.right() + 20);
  EXPECT_DOUBLE_EQ(right.right(), whole.right());
  const auto [upper, lower] = whole.split_rows(0.5, 10);
  EXPECT_DOUBLE_EQ(upper.top(), whole.top());
  EXPECT_DOUBLE_EQ(upper.y, lower.top() + 10);
  EXPECT_DOUBLE_EQ(lower.y, whole.y);
  const std::vector<Rectangle> cells = whole.cells(2, 3, 12);
  ASSERT_EQ(cells.size(), 6u);
  double area = 0;
  for (const Rectangle& cell : cells) area += cell.width * cell.height;
  EXPECT_DOUBLE_EQ(area, (300 - 24.0) * (200 - 12.0));
  EXPECT_DOUBLE_EQ(cells[0].top(), whole.top());
  EXPECT_DOUBLE_EQ(cells[5].right(), whole.right());
}

TEST_F(OnWhite, AnArrowReachesFromTailToTip) {
  for (const double length : {6.0, 30.0, 150.0, 600.0}) {
    canvas_.clear(white);
    canvas_.arrow({200, 300}, {200 + length, 300}, {black, 3});
    const Ink drawn = ink(canvas_.image(), 0.2);
    EXPECT_NEAR(drawn.left, 200 * pixels_, 1.5) << length;
    EXPECT_NEAR(drawn.right, (200 + length) * pixels_, 2) << length;
  }
}

TEST_F(OnWhite, AVectorIsAsLongAsItsScaleSays) {
  const Camera camera = fit({0, 0, 10, 6}, canvas_.page(), 0);
  canvas_.look(camera);
  canvas_.vector({1, 3}, {4, 0}, {black, 1.5, "m/s"});  // 6 world units
  const Ink drawn = ink(canvas_.image(), 0.2);
  EXPECT_NEAR(drawn.right - drawn.left, 6 * camera.scale * pixels_, 2.5);
}

TEST_F(OnWhite, TheKeysArrowHasTheLengthOfTheValueWrittenBesideIt) {
  for (const double scale : {0.003, 0.7, 40.0}) {
    canvas_.clear(white);
    canvas_.look(fit({0, 0, 10, 6}, canvas_.page(), 0));
    const double points_per_unit = scale * canvas_.camera().scale;
    canvas_.arrow_key({20, 300}, {black, scale, ""}, "");
    const Image image = canvas_.image();
    const auto [left, row] = pixel_of(canvas_, {20, 300});
    int tip = left + 1;
    while (darkness(image, tip, row) > 0.2) ++tip;
    const double value = (tip - left) / pixels_ / points_per_unit;
    const double mantissa = value / std::pow(10, std::floor(std::log10(value * 1.05)));
    const double nearest = mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : 5;
    EXPECT_NEAR(mantissa / nearest, 1, 0.1) << scale;
  }
  EXPECT_THROW(canvas_.arrow_key({20, 300}, {black, 0, ""}, ""), std::invalid_argument);
}

TEST_F(OnWhite, NothingIsDrawnOutsideTheClip) {
  canvas_.clip(Rectangle{300, 300, 150, 150});
  canvas_.rectangle(canvas_.page(), black_area);
  canvas_.clip(std::nullopt);
  const Ink drawn = ink(canvas_.image());
  EXPECT_DOUBLE_EQ(drawn.area, 100 * 100);
  EXPECT_EQ(drawn.left, 200);
  EXPECT_EQ(drawn.bottom, 480 - 200);
}

TEST_F(OnWhite, LaterShapesCoverEarlierOnes) {
  canvas_.disc({400, 300}, 100, black_area);
  canvas_.disc({400, 300}, 50, {white, {white, 0}});
  EXPECT_EQ(colour_at(canvas_.image(), pixel_of(canvas_, {400, 300})), white);
  EXPECT_EQ(colour_at(canvas_.image(), pixel_of(canvas_, {475, 300})), black);
}

TEST_F(OnWhite, ATrailFadesTowardsItsBeginning) {
  const std::array points{Point(100, 300), Point(500, 300), Point(900, 300)};
  canvas_.trail(points, {black, 30});
  const Image image = canvas_.image();
  const auto dark = [&](double x) {
    const auto [column, row] = pixel_of(canvas_, {x, 300});
    return darkness(image, column, row);
  };
  EXPECT_NEAR(dark(300), 0.25, 0.02);
  EXPECT_NEAR(dark(500), 0.5, 0.02);
  EXPECT_NEAR(dark(800), 0.875, 0.02);
}

TEST_F(OnWhite, WhatIsNotFiniteIsAGap) {
  canvas_.path(std::array{Point(100, 300), Point(200, 300), Point(nan, 300), Point(600, 300), Point(700, 300)},
               {black, 6});
  EXPECT_NEAR(ink(canvas_.image()).area, 2 * 100 * 6 * pixels_ * pixels_, 10);
  canvas_.clear(white);
  for (const double bad : {nan, infinity, -infinity}) {
    canvas_.disc({bad, 300}, 20, black_area);
    canvas_.disc({300, 300}, bad, black_area);
    canvas_.box({bad, 1}, {20, 20}, 0, black_area);
    canvas_.box({300, 300}, {20, 20}, bad, black_area);
    canvas_.rectangle({bad, 0, 10, 10}, black_area);
    canvas_.line({bad, 0}, {100, 100}, {black, 3});
    canvas_.arrow({0, 0}, {bad, 100}, {black, 3});
    canvas_.rod({0, 0}, {bad, 100}, black_area);
    canvas_.spring({bad, 0}, {100, 100});
    canvas_.mark({bad, 0}, Mark::disc, black);
    canvas_.hinge({bad, 0});
    canvas_.anchor({bad, 0});
    canvas_.ground({bad, 0}, {100, 0});
    canvas_.dimension({bad, 0}, {100, 0}, "L");
    canvas_.text({bad, 0}, "text");
  }
  EXPECT_EQ(ink(canvas_.image()).area, 0);
}

TEST_F(OnWhite, WhatIsFarAwayCostsNothingAndShowsOnlyWhatIsOnThePage) {
  canvas_.line({-1e12, 300}, {1e12, 300}, {black, 6, Dash::solid});
  EXPECT_NEAR(ink(canvas_.image()).area, 720 * 4, 30);
  canvas_.clear(white);
  canvas_.line({-1e15, 300}, {1e15, 300}, {black, 6, Dash::dashed});
  canvas_.ground({-1e15, 300}, {1e15, 300});
  canvas_.disc({1e30, -1e30}, 5, black_area);
  canvas_.box({1e200, 0}, {1, 1}, 0, black_area);
  canvas_.spring({-1e15, 1e15}, {-1e15, -1e15});
  canvas_.text({1e30, 0}, "far");
  EXPECT_GT(ink(canvas_.image()).area, 720 * 4 * 0.4);
}

TEST(Canvas, LooksAlikeAtEverySize) {
  std::array<double, 3> shares{};
  const std::array sizes{480, 720, 1080};
  for (int i = 0; i < 3; ++i) {
    PixelCanvas canvas(sizes[i] * 16 / 9, sizes[i]);
    canvas.clear(white);
    canvas.line({100, 100}, {900, 600}, {black, 3});
    canvas.mark({300, 600}, Mark::square, black, 14);
    canvas.text({600, 200}, "Constraints by Hand", {.size = 30, .colour = black});
    shares[i] = ink(canvas.image()).area / (double(sizes[i]) * sizes[i]);
  }
  EXPECT_NEAR(shares[0] / shares[1], 1, 0.02);
  EXPECT_NEAR(shares[2] / shares[1], 1, 0.02);
}

TEST(Canvas, RefusesAPageThatIsTooSmallOrTooLarge) {
  EXPECT_THROW(PixelCanvas(0, 100), std::invalid_argument);
  EXPECT_THROW(PixelCanvas(100, -1), std::invalid_argument);
  EXPECT_THROW(PixelCanvas(100, 10000), std::invalid_argument);
}

TEST(Canvas, SaysWhatDraws) {
  const std::string text = PixelCanvas(64, 64).describe();
  EXPECT_NE(text.find("OpenGL"), std::string::npos) << text;
  EXPECT_TRUE(text.find("OSMesa") != std::string::npos || text.find("EGL") != std::string::npos) << text;
}

class Text : public OnWhite {
 protected:
  Ink written(const std::string& text, TextStyle style = {}) {
    style.colour = black;
    canvas_.clear(white);
    canvas_.text({500, 300}, text, style);
    return ink(canvas_.image(), 0.1);
  }
};

TEST_F(Text, LiesWithinTheBoxThatIsMeasured) {
  for (const bool upright : {true, false})
    for (const Anchor anchor : {Anchor::centre, Anchor::left, Anchor::right, Anchor::top, Anchor::bottom,
                                Anchor::top_left, Anchor::top_right, Anchor::bottom_left, Anchor::bottom_right}) {
      const TextStyle style{.size = 40, .anchor = anchor, .upright = upright};
      const Ink drawn = written("Hxgy\nwide line", style);
      const Rectangle box = canvas_.measure({500, 300}, "Hxgy\nwide line", style);
      EXPECT_GE(drawn.left, box.x * pixels_ - 1);
      EXPECT_LE(drawn.right, box.right() * pixels_ + 1);
      EXPECT_GE(drawn.top, 480 - box.top() * pixels_ - 1);
      EXPECT_LE(drawn.bottom, 480 - box.y * pixels_ + 1);
      EXPECT_GT(drawn.right - drawn.left, 0.8 * box.width * pixels_);
    }
}

TEST_F(Text, StandsAtItsAnchor) {
  const double x = 500 * pixels_, y = 480 - 300 * pixels_;
  const TextStyle style{.size = 60};
  const auto at = [&](Anchor anchor) {
    TextStyle s = style;
    s.anchor = anchor;
    return written("HH", s);
  };
  EXPECT_NEAR((at(Anchor::centre).left + at(Anchor::centre).right) / 2, x, 1.5);
  EXPECT_NEAR((at(Anchor::centre).top + at(Anchor::centre).bottom) / 2, y, 1.5);
  EXPECT_GE(at(Anchor::left).left, x - 1);
  EXPECT_LE(at(Anchor::right).right, x + 1);
  EXPECT_NEAR(at(Anchor::top).top, y, 1.5);
  EXPECT_LE(at(Anchor::bottom).bottom, y);
}

TEST_F(Text, RaisesAndLowers) {
  const TextStyle style{.size = 60, .anchor = Anchor::left};
  const Ink plain = written("x", style), raised = written("x^2", style), lowered = written("x_2", style);
  EXPECT_LT(raised.top, plain.top - 5);
  EXPECT_GT(lowered.bottom, plain.bottom + 3);
  EXPECT_NEAR(raised.bottom, plain.bottom, 1);
  EXPECT_NEAR(lowered.right, raised.right, 1);
  EXPECT_GT(written("x^{12}", style).right, raised.right + 5);
  EXPECT_EQ(written("a\\_b", style).bottom, written("a_{}\\_b", style).bottom);
  EXPECT_GT(written("x\\^2", style).right, raised.right) << "a backslash prints the sign itself";
}

TEST_F(Text, PutsDotsOnLetters) {
  const TextStyle style{.size = 60, .anchor = Anchor::left};
  for (const char* letter : {"λ", "x", "C", "θ"}) {
    const Ink plain = written(letter, style), dotted = written(std::string(letter) + "̇", style);
    EXPECT_LT(dotted.top, plain.top - 3) << letter;
    EXPECT_NEAR(dotted.right, plain.right, 1) << letter;
    EXPECT_NEAR(dotted.bottom, plain.bottom, 1) << letter;
  }
}

TEST_F(Text, HasEveryLetterTheCourseNeeds) {
  const TextStyle style{.size = 30};
  const Ink box = written("\U0010FFFD", style);  // what stands for a letter that is missing
  for (const char* letter : {"α", "β", "γ", "Δ", "θ", "λ", "μ", "π", "ρ", "ω", "Ċ", "∇", "·", "×",
                             "−", "≤", "≈", "⁻", "²", "½", "√", "∞", "‖", "→", "°", "∂", "∈", "⊥"}) {
    const Ink drawn = written(letter, style);
    EXPECT_GT(drawn.area, 2) << letter;
    EXPECT_GT(std::abs(drawn.area - box.area) + std::abs(drawn.left - box.left), 0.5) << letter << " is missing";
  }
}

TEST_F(Text, AHaloKeepsItReadableOverLines) {
  const auto over_black = [&](double halo) {
    canvas_.clear(white);
    canvas_.rectangle({400, 200, 200, 200}, black_area);
    canvas_.text({500, 300}, "H", {.size = 60, .colour = black, .halo = halo});
    return ink(canvas_.image()).area;
  };
  EXPECT_LT(over_black(6), over_black(0) - 500);
}

TEST_F(Text, BadUtf8IsDrawnAsSomethingAndNeverRead) {
  for (const char* text : {"\xff\xfe", "\xe2\x88", "\xf0", "a\xc3", "^", "_", "x_", "x^{", "\\", "}", ""})
    written(text);
}

}  // namespace
}  // namespace byhand::renderer
