// A page in the browser asks which parameters a step reads, to tell only what a change concerns.

#include "lessons/page/parameter.hpp"

#include <gtest/gtest.h>

#include "lessons/page/side_by_side.hpp"

namespace byhand::course {
namespace {

ParameterRecord beta() { return {.name = "beta", .unit = "1", .range = {0, 3}, .initial = 0.2, .value = 0.2}; }

TEST(Parameter, RemembersThatItsValueWasRead) {
  const ParameterRecord record = beta();
  const Parameter<double> parameter(record);
  EXPECT_FALSE(record.was_read) << "made, but not yet read";
  EXPECT_EQ(parameter(), 0.2);
  EXPECT_TRUE(record.was_read);

  record.was_read = false;
  EXPECT_EQ(Value(parameter).plain(), "0.2");
  EXPECT_TRUE(record.was_read) << "in a text";
}

TEST(Parameter, OfferedAsAChoiceRemembersToo) {
  const ParameterRecord record{.name = "scene", .value = 1, .choices = {"chain", "stack"}};
  const Parameter<std::string> parameter(record);
  EXPECT_EQ(parameter(), "stack");
  EXPECT_TRUE(record.was_read);
}

TEST(Parameter, IsNotReadByBeingSetOrDescribed) {
  ParameterRecord record = beta();
  record.set("1/3");
  EXPECT_EQ(record.typed(record.value), "1/3");
  EXPECT_EQ(record.allowed(), "0 … 3");
  EXPECT_FALSE(record.was_read);
}

TEST(Parameter, MayBeReadByThreadsAtOnce) {
  const ParameterRecord record = beta();
  const Parameter<double> parameter(record);
  side_by_side(
      100, [&](int) { EXPECT_EQ(parameter(), 0.2); }, nullptr);
  EXPECT_TRUE(record.was_read);
}

TEST(Parameter, RefusesWhatNoDoubleHoldsAndKeepsItsValue) {
  ParameterRecord record = beta();
  EXPECT_THROW(record.set("1e400"), std::invalid_argument);
  EXPECT_THROW(record.set("1e-400"), std::invalid_argument) << "would be zero";
  EXPECT_THROW(record.set("."), std::invalid_argument);
  EXPECT_THROW(record.set("1.2.3"), std::invalid_argument);
  EXPECT_EQ(record.value, 0.2);
  record.set("2.5e-1");
  EXPECT_EQ(record.value, 0.25);
}

}  // namespace
}  // namespace byhand::course
