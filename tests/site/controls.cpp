// Which parameters stand under a picture, and where a page keeps a place for them.
#include "lessons/site/controls.hpp"

#include <gmock/gmock.h>

#include "lessons/page/lesson.hpp"

namespace byhand::tests {
namespace {

using namespace course;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Every parameter changes every picture.
bool all(const std::string& /*picture*/, const std::string& /*parameter*/) { return true; }

const Step drift{"1", "Drift", false, {}}, share{"2", "A share β of the error", false, {}};

std::vector<RecordedStep> lesson() {
  return {{&drift, {}, {"beta", "h", "end_mass", "speed"}}, {&share, {}, {"beta", "h", "end_mass"}}};
}

TEST(Controls, WhatTheCaptionNamesComesFirstThenTheTitleThenWhatFewStepsRead) {
  const auto steps = lesson();
  EXPECT_THAT(site::knobs(steps[0], "swing", "The end mass swings.", steps, all),
              ElementsAre("end_mass", "speed"));
  EXPECT_THAT(site::knobs(steps[1], "swing", "After h seconds.", steps, all), ElementsAre("h", "beta"));
  EXPECT_THAT(site::knobs(steps[1], "swing", "The heights.", steps, all), ElementsAre("beta", "h"));
}

TEST(Controls, UnderAPictureStandOnlyParametersThatChangeIt) {
  const auto steps = lesson();
  const auto changes = [](const std::string& picture, const std::string& parameter) {
    return picture == "swing" && parameter != "end_mass";
  };
  EXPECT_THAT(site::knobs(steps[0], "swing", "The end mass swings.", steps, changes),
              ElementsAre("speed", "beta"));
  EXPECT_THAT(site::knobs(steps[0], "cone", "The end mass swings.", steps, changes), testing::IsEmpty());
}

TEST(Controls, HowFinelyAMapIsDrawnIsNotOffered) {
  const std::vector<RecordedStep> steps{{&drift, {}, {"resolution", "beta"}}, {&drift, {}, {"resolution"}}};
  EXPECT_THAT(site::knobs(steps[0], "map", "A map of some resolution.", steps, all), ElementsAre("beta"));
  EXPECT_THAT(site::knobs(steps[1], "map", "A map.", steps, all), testing::IsEmpty());
}

TEST(Controls, AStepThatReadsNothingHasNoPlaceForParametersAndSaysWhereItsNumbersComeFrom) {
  const std::vector<RecordedStep> steps{{&drift, {}, {}}};
  const std::string section = site::with_controls("<section>\n</section>\n", steps[0], steps, all);
  EXPECT_THAT(section, Not(HasSubstr("others")));
  EXPECT_THAT(section, HasSubstr("<p class=\"recorded\">This step reads no parameter"));
  EXPECT_THAT(site::with_controls("<section>\n</section>\n", lesson()[0], lesson(), all),
              HasSubstr("<div class=\"others\"></div>\n</section>"));
}

}  // namespace
}  // namespace byhand::tests
