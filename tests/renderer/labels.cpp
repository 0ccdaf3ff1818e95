#include "renderer/labels.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace byhand::renderer {
namespace {

TEST(Labels, DoNotCoverOneAnotherNorLeaveTheFrame) {
  std::mt19937 random(20131207);
  std::uniform_real_distribution<double> x(100, 1100), y(80, 640);
  PixelCanvas canvas(640, 360);
  for (int trial = 0; trial < 50; ++trial) {
    canvas.clear();
    const Rectangle frame{60, 40, 1100, 640};
    Labels labels(canvas, frame);
    std::vector<Rectangle> boxes;
    for (int i = 0; i < 25; ++i)
      boxes.push_back(labels.place({x(random), y(random)}, "label " + std::to_string(i)));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_NEAR(boxes[i].overlap(frame), boxes[i].width * boxes[i].height, 1e-6);
      for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(boxes[i].overlap(boxes[j]), 0) << i << " over " << j;
    }
  }
}

TEST(Labels, StandClearOfDiscsAndPaths) {
  PixelCanvas canvas(640, 360);
  canvas.look(fit({-2, -2, 4, 4}, canvas.page()));
  Labels labels(canvas, canvas.page());
  labels.avoid_disc({0, 0}, 0.3);
  labels.avoid_path(std::array{Point(0, 0), Point(2, 0)});
  const Rectangle box = labels.place({0, 0}, "bob");
  const Camera& camera = canvas.camera();
  const Point centre = camera.to_page({0, 0});
  const double radius = 0.3 * camera.scale;
  EXPECT_EQ(box.overlap({centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius}), 0);
  EXPECT_EQ(box.overlap({centre.x(), centre.y() - 2, 2 * camera.scale, 4}), 0);
}

TEST(Labels, ALonelyLabelStandsAtTheRight) {
  PixelCanvas canvas(640, 360);
  Labels labels(canvas, canvas.page());
  const Rectangle box = labels.place({300, 300}, "bob", {}, 12);
  EXPECT_DOUBLE_EQ(box.x, 312);
}

TEST(Labels, WithNoRoomAtAllTheTextIsStillDrawn) {
  PixelCanvas canvas(640, 360);
  Labels labels(canvas, canvas.page());
  labels.avoid(canvas.page());
  const Image before = canvas.image();
  labels.place({300, 300}, "bob");
  EXPECT_NE(canvas.image(), before);
}

}  // namespace
}  // namespace byhand::renderer
