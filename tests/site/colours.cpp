// One colour per quantity in a picture and in the formulas of its step.

#include "lessons/page/html/colours.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "lessons/page/html/drawn.hpp"
#include "lessons/page/html/mathml.hpp"
#include "renderer/palette.hpp"
#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

using renderer::Canvas;
using testing::HasSubstr;
using testing::Not;

std::string picture(const std::string& words, renderer::Colour colour) {
  return site::drawn("picture", [=](Canvas& canvas) { canvas.text({100, 100}, words, {.colour = colour}); });
}
std::string with(const std::string& picture) {
  return site::with_colours(picture + site::display_mathml(R"(\lambda = J V)"));
}

TEST(Colours, ASymbolHasTheColourThatItsPictureGivesIt) {
  const std::string step = with(picture("λ d = 3", renderer::palette::force));
  EXPECT_THAT(step, HasSubstr("<mi class=\"force\">λ</mi>"));
  EXPECT_THAT(step, HasSubstr("<mi>J</mi>")) << "which the picture does not name";
}

TEST(Colours, OfSeveralTextsAreThoseOfEach) {
  const std::string both = site::drawn("picture", [](Canvas& canvas) {
    for (const char* words : {"J", "λ", "V"}) canvas.text({100, 100}, words, {.colour = renderer::palette::force});
    canvas.text({100, 100}, "V", {.colour = renderer::palette::velocity});
  });
  const std::string step = with(both);
  EXPECT_THAT(step, HasSubstr("<mi class=\"force\">λ</mi>"));
  EXPECT_THAT(step, HasSubstr("<mi class=\"velocity\">V</mi>"));
  EXPECT_THAT(step, HasSubstr("<mi>J</mi>"));
}

TEST(Colours, WithoutSuchAPictureItIsBlack) {
  EXPECT_THAT(with(""), Not(HasSubstr("class=\"force\"")));
  EXPECT_THAT(with(picture("λ", renderer::palette::ink)), Not(HasSubstr("class=\"force\"")));
  EXPECT_THAT(with(picture("λ", renderer::palette::constraint)), Not(HasSubstr("<mi class")))
      << "the colour of another quantity";
  EXPECT_THAT(with(picture("10 N", renderer::palette::force)), Not(HasSubstr("<mi class"))) << "no variable";
}

renderer::Colour colour_of(const std::string& hex) {
  const auto part = [&](std::size_t at) {
    return static_cast<std::uint8_t>(std::stoi(hex.substr(at, 2), nullptr, 16));
  };
  return {part(0), part(2), part(4)};
}

/// The values of a property of the style sheet, in light and in dark.
std::vector<renderer::Colour> values(const std::string& css, const std::string& name) {
  const std::regex rule("--" + name + ": #([0-9a-f]{6});");
  std::vector<renderer::Colour> all;
  for (auto it = std::sregex_iterator(css.begin(), css.end(), rule); it != std::sregex_iterator(); ++it)
    all.push_back(colour_of((*it)[1]));
  return all;
}

TEST(Colours, CanBeReadInLightAndDark) {
  const std::string css = contents(BYHAND_STYLE);
  for (const char* ground : {"paper", "wash"})
    for (const char* quantity : {"constraint", "force", "velocity", "error"}) {
      const auto behind = values(css, ground), letters = values(css, quantity);
      ASSERT_EQ(behind.size(), 2U) << ground;
      ASSERT_EQ(letters.size(), 2U) << quantity;
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_GE(renderer::contrast(letters[i], behind[i]), 4.5) << quantity << " on " << ground << i;
    }
}

}  // namespace
}  // namespace byhand::tests
