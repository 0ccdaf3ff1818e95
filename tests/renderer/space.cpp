#include "renderer/space.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/renderer/coverage.hpp"

namespace byhand::renderer {
namespace {

class SpaceOnPaper : public testing::Test {
 protected:
  PixelCanvas canvas_{640, 360};
  const SpaceCamera camera_ = fit({0, 0, 0}, 2, {-1, 2, -0.7}, canvas_.page());

  Colour seen(const Space& scene, const Point3& point) {
    canvas_.clear();
    canvas_.draw(scene);
    return colour_at(canvas_.image(), pixel_of(canvas_, scene.project(point)));
  }
  static bool bluish(Colour c) { return c.b > c.r + 20; }
  static bool reddish(Colour c) { return c.r > c.b + 20; }
};

constexpr Colour red{200, 40, 40}, blue{40, 40, 200};

TEST_F(SpaceOnPaper, TheTargetIsInTheMiddleAndUpIsUp) {
  const Space scene(camera_);
  EXPECT_LE((scene.project(camera_.target) - canvas_.page().centre()).norm(),
            1e-12 * canvas_.page().centre().norm());
  EXPECT_GT(scene.project({0, 0, 1}).y(), scene.project({0, 0, 0}).y());
  EXPECT_NEAR(scene.project({0, 0, 1}).x(), canvas_.page().centre().x(), 1e-9);
}

TEST_F(SpaceOnPaper, TheWholeBallIsSeen) {
  const Space scene(camera_);
  for (const Point3& axis : {Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1), Point3(0.6, 0, -0.8)})
    for (const double sign : {-2.0, 2.0}) EXPECT_TRUE(canvas_.page().contains(scene.project(sign * axis)));
}

TEST_F(SpaceOnPaper, WhatIsNearerIsLargerAndCovers) {
  const Point3 towards = (camera_.eye - camera_.target).normalized();
  Space scene(camera_);
  EXPECT_GT(scene.scale_at(towards), scene.scale_at(-towards));
  scene.sphere(towards, 0.3, blue);
  scene.sphere(-towards, 0.5, red);
  EXPECT_TRUE(bluish(seen(scene, towards)));
  Space other(camera_);
  other.sphere(-towards, 0.5, red);
  other.sphere(towards, 0.3, blue);
  EXPECT_TRUE(bluish(seen(other, towards))) << "whatever the order";
}

TEST_F(SpaceOnPaper, AShapeIsDrawnWhereItsPointsAreProjected) {
  Space scene(camera_);
  scene.rod({-1, 0, 0}, {1, 0.5, 0.5}, 0.1, blue);
  scene.box({0, 0, -1}, {0.6, 0.6, 0.6}, Quaternion(), red);
  scene.arrow({0, 1, 0}, {0, 1, 1.2}, 0.06, blue);
  EXPECT_TRUE(bluish(seen(scene, {-1, 0, 0})));
  EXPECT_TRUE(bluish(seen(scene, {1, 0.5, 0.5})));
  EXPECT_TRUE(reddish(seen(scene, {0, 0, -1})));
  EXPECT_TRUE(bluish(seen(scene, {0, 1, 0.5})));
  EXPECT_EQ(seen(scene, {-1.5, 0, 1}), palette::paper);
}

TEST_F(SpaceOnPaper, ASphereHasTheSizeItsScaleSays) {
  Space scene(camera_);
  scene.sphere({0, 0, 0}, 0.5, {0, 0, 0});
  canvas_.clear(white);
  canvas_.draw(scene);
  const Ink drawn = ink(canvas_.image(), 0.3);
  EXPECT_NEAR(drawn.right - drawn.left, 2 * 0.5 * scene.scale_at({0, 0, 0}) * 0.5, 3);
}

TEST_F(SpaceOnPaper, AShapeDarkensTheGroundBeneathIt) {
  Space bare(camera_), scene(camera_);
  for (Space* s : {&bare, &scene}) s->ground({0, 0, -1}, 6, 100);  // no grid line near
  scene.sphere({0.8, -0.5, 0.4}, 0.4, blue);
  canvas_.clear();
  canvas_.draw(bare);
  const Image empty = canvas_.image();
  canvas_.clear();
  canvas_.draw(scene);
  const Image image = canvas_.image();
  int darker = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const bool grey = std::abs(image.rgb[i] - image.rgb[i + 2]) < 12;
    darker += grey && image.rgb[i] < empty.rgb[i] - 30;
  }
  EXPECT_GT(darker, 400);
}

TEST_F(SpaceOnPaper, RefusesACameraThatSeesNothing) {
  SpaceCamera bad = camera_;
  bad.eye = bad.target;
  EXPECT_THROW(Space{bad}, std::invalid_argument);
  bad = camera_;
  bad.up = bad.eye - bad.target;
  EXPECT_THROW(Space{bad}, std::invalid_argument);
  bad = camera_;
  bad.frame = {};
  EXPECT_THROW(Space{bad}, std::invalid_argument);
  bad = camera_;
  bad.eye.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Space{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace byhand::renderer
