#include "lessons/site/reading.hpp"

#include <gtest/gtest.h>

namespace byhand::tests {
namespace {

using site::Digest;
using site::reading_time;

Digest::Step step(int words, int questions, bool deeper = false) {
  Digest::Step made{.deeper = deeper, .questions = questions};
  for (int i = 0; i < words; ++i) made.words += "word ";
  return made;
}

TEST(ReadingTime, GrowsWithWordsAndQuestionsOfEachPart) {
  Digest lesson{.steps = {step(1800, 0)}};
  const int of_words = reading_time(lesson).core;
  EXPECT_GT(of_words, 0);
  EXPECT_EQ(of_words % 5, 0);
  EXPECT_EQ(reading_time(lesson).deeper, 0);
  lesson.steps.push_back(step(0, 10));
  EXPECT_GT(reading_time(lesson).core, of_words);
  lesson.steps.push_back(step(1800, 0, true));
  EXPECT_EQ(reading_time(lesson).deeper, of_words);
}

TEST(ReadingTime, IsNeverNothing) { EXPECT_EQ(in_words(reading_time(Digest{})), "about 5 minutes"); }

}  // namespace
}  // namespace byhand::tests
