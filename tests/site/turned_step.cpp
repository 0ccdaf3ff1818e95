// Which parameters change what is seen of a picture.
#include "lessons/site/turned_step.hpp"

#include <gtest/gtest.h>

#include "renderer/canvas.hpp"

namespace byhand::tests {
namespace {

using namespace course;

/// A step whose pictures look at one parameter each; `letters` only writes it.
struct Turned {
  Lesson lesson{{.slug = "98_turned", .title = "Turned", .summary = "Turned."}};
  Parameter<double> size = lesson.parameter("size", 40.0, "1", {10, 90}, "of the disc");
  Parameter<double> speed = lesson.parameter("speed", 40.0, "1", {40, 200}, "of the disc of the film");
  Parameter<std::string> side = lesson.parameter("side", "left", {"left", "right"}, "of a chart's curve");
  Parameter<double> height = lesson.parameter("height", 1.0, "1", {1, 2}, "to which its axis grows");
  Parameter<int> resolution = lesson.parameter("resolution", 9, "1", {2, 9}, "of the map");

  Turned() {
    lesson.step("All", [*this](Page& page) {
      page.figure("disc", "", [size = size()](renderer::Canvas& canvas) { canvas.disc({600, 300}, size); });
      page.figure("letters", "", [size = size](renderer::Canvas& canvas) {
        canvas.disc({600, 300}, 40);
        canvas.text({600, 500}, say("@", size()), {.size = 60});
      });
      page.sequence("film", "", Seconds{2}, [speed = speed()](renderer::Canvas& canvas, double time) {
        canvas.disc({300 + speed * time, 300}, 40);
      });
      renderer::Curve curve{.x = {0, 1}, .y = {0, height()}};
      if (side() == "right") std::swap(curve.y[0], curve.y[1]);
      page.figure("chart", "", renderer::Chart{.curves = {curve}});
      page.text("@", resolution);
    });
  }
  bool changes(const char* picture, const char* parameter) {
    return site::TurnedStep(lesson, lesson.steps()[0]).changes(picture, parameter);
  }
};

TEST(TurnedStep, AParameterChangesThePictureThatItMoves) {
  Turned turned;
  EXPECT_TRUE(turned.changes("disc", "size"));
  EXPECT_FALSE(turned.changes("disc", "speed"));
  EXPECT_TRUE(turned.changes("film", "speed")) << "at the other end than the present one, and later";
  EXPECT_FALSE(turned.changes("film", "size"));
  EXPECT_TRUE(turned.changes("chart", "side"));
}

TEST(TurnedStep, LettersAreNoChange) {
  Turned turned;
  EXPECT_FALSE(turned.changes("letters", "size"));
  EXPECT_FALSE(turned.changes("chart", "height")) << "the axis grows with the curve";
}

TEST(TurnedStep, PutsTheValuesBack) {
  Turned turned;
  turned.lesson.set("size", "50");
  EXPECT_TRUE(turned.changes("disc", "size"));
  EXPECT_EQ(turned.size(), 50);
  EXPECT_EQ(turned.resolution(), 9);
}

}  // namespace
}  // namespace byhand::tests
