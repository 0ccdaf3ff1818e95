// Work that is done side by side comes back as if it had been done one after the other.

#include "lessons/page/side_by_side.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "lessons/page/page.hpp"

namespace byhand::course {
namespace {

TEST(SideBySide, ReturnsResultsInTheirOrder) {
  const std::vector<double> squares = Page().side_by_side(1000, [](int i) { return 1.0 * i * i; });
  ASSERT_EQ(squares.size(), 1000u);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(squares[static_cast<std::size_t>(i)], 1.0 * i * i);
}

TEST(SideBySide, DoesEachPieceOnce) {
  std::array<std::atomic<int>, 300> done{};
  side_by_side(
      300, [&](int i) { ++done[static_cast<std::size_t>(i)]; }, nullptr);
  for (const auto& times : done) EXPECT_EQ(times, 1);
}

TEST(SideBySide, HasNothingToDoForNothing) {
  EXPECT_TRUE(Page().side_by_side(0, [](int i) { return i; }).empty());
}

TEST(SideBySide, HandsOnWhatAPieceThrows) {
  const auto work = [](int i) {
    if (i == 17) throw std::invalid_argument("seventeen");
  };
  EXPECT_THAT([&] { side_by_side(100, work, nullptr); },
              testing::ThrowsMessage<std::invalid_argument>("seventeen"));
}

}  // namespace
}  // namespace byhand::course
