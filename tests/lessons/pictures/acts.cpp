#include "lessons/pictures/acts.hpp"

#include <gtest/gtest.h>

#include "renderer/svg_canvas.hpp"

namespace byhand::pictures {
namespace acts_test {

TEST(Eased, BeginsAndEndsAtRestAndNeverTurnsBack) {
  EXPECT_EQ(eased(-1), 0);
  EXPECT_EQ(eased(0), 0);
  EXPECT_EQ(eased(0.5), 0.5);
  EXPECT_EQ(eased(1), 1);
  EXPECT_EQ(eased(7), 1);
  const double d = 1e-6;
  EXPECT_LT(eased(d) / d, 1e-5);
  EXPECT_LT((1 - eased(1 - d)) / d, 1e-5);
  for (double s = 0; s < 1; s += 0.01) EXPECT_GT(eased(s + 0.01), eased(s));
}

class ThreeActs : public testing::Test {
 protected:
  Acts acts_{
      {{"V = hg", "Gravity adds hg to V, straight down, in every step of the run, before anything is solved."},
       {"JV", "The part along d."},
       {"λ", "The impulse."}}};
};

TEST_F(ThreeActs, OneTermMovesAtATime) {
  for (double time = 0; time <= acts_.seconds(); time += 0.01) {
    int moving = 0;
    for (std::size_t i = 0; i < 3; ++i) moving += acts_.share(i, time) > 0 && acts_.share(i, time) < 1;
    EXPECT_LE(moving, 1) << time;
    for (std::size_t i = 0; i < acts_.now(time); ++i) EXPECT_EQ(acts_.share(i, time), 1) << time;
    for (std::size_t i = acts_.now(time) + 1; i < 3; ++i) EXPECT_EQ(acts_.share(i, time), 0) << time;
  }
}

TEST_F(ThreeActs, EachCanBeSeenForSevenTenthsOfASecondAtRest) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double end = double(i + 1) * (Acts::moving + Acts::holding);
    EXPECT_EQ(acts_.share(i, end - 0.7), 1);
    EXPECT_EQ(acts_.now(end - 1e-9), i);
  }
  EXPECT_EQ(acts_.now(acts_.seconds() + 100), 2u);
}

TEST_F(ThreeActs, TheTextsKeepTheirPlaces) {
  renderer::SvgCanvas canvas(1280, "acts");
  canvas.list_labels();
  const auto labels = [&](double time) {
    canvas.clear();
    acts_.draw(canvas, {700, 20, 500, 680}, time);
    return canvas.labels();
  };
  const auto first = labels(0);
  ASSERT_EQ(first.size(), 6u);
  for (const double time : {1.0, 3.0, 6.0, 100.0}) {
    const auto now = labels(time);
    ASSERT_EQ(now.size(), first.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_EQ(now[i].text, first[i].text);
      EXPECT_EQ(now[i].box.x, first[i].box.x);
      EXPECT_EQ(now[i].box.top(), first[i].box.top());
    }
  }
  for (const auto& label : first) EXPECT_LE(label.box.right(), 1200) << label.text;
}

}  // namespace acts_test
}  // namespace byhand::pictures
