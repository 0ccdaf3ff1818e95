#include "lessons/page/html/step_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/page/lesson.hpp"
#include "renderer/canvas.hpp"
#include "tests/site/markup.hpp"

namespace byhand::tests {
namespace {

using namespace course;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The section of one step, as HTML, with a stand-in for each picture.
std::string told(const StepFunction& run) {
  static Lesson lesson({.slug = "98_told"});
  const Step step{.label = "3a", .title = "(17) & *more*", .deeper = true, .run = run};
  const RecordedStep recorded = record_step(lesson, step, true);
  return site::step_html(recorded, {.figure =
                                        [](const Figure&) {
                                          return site::Shown{"<svg></svg>", "LINK"};
                                        },
                                    .film = [](const Sequence&) { return site::Shown{"<svg></svg>"}; }});
}
Markup read(const StepFunction& run) { return of_page(told(run)); }

Claim claim(const char* quantity, double measured, bool claimed = true) {
  return {.quantity = quantity,
          .unit = "m",
          .expected = 1,
          .source = "a law",
          .measured = measured,
          .tolerance = absolute(0.1),
          .range = {claimed, claimed ? "" : "β < 1"}};
}

TEST(StepHtml, IsASectionUnderItsLabel) {
  const Markup section = read([](Page& page) { page.text("Words."); });
  EXPECT_EQ(section.mistake(), "");
  EXPECT_THAT(section.all("/section/@id"), ElementsAre("step-3a"));
  EXPECT_THAT(section.all("/section/@data-step"), ElementsAre("3a"));
  EXPECT_THAT(section.all("/section/h2"), ElementsAre("3a (17) & more deeper"));
  EXPECT_THAT(section.all("/section/h2//a//a"), IsEmpty());
}

TEST(StepHtml, EveryChildHasTheIndexOfItsItem) {
  const Markup section = read([](Page& page) {
    page.text("One.");
    page.measure("a", 1, "m");
    page.measure("b", 2, "m");
    page.claim(claim("c", 1));
    page.claim(claim("d", 1));
    page.equation(17);
    page.claim(claim("e", 1));
  });
  EXPECT_THAT(section.all("/section/*/@data-item"), ElementsAre("0", "1", "3", "5", "6"));
  EXPECT_THAT(section.all("//*/@data-item"), ElementsAre("0", "1", "1", "2", "3", "3", "4", "5", "6", "6"));
}

TEST(StepHtml, AnEquationOfTheArticleCarriesItsNumberAndItsNumbersDoNot) {
  const Markup section = read([](Page& page) { page.equation(22, "JV = −@", "JV = -@", 3.0); });
  EXPECT_THAT(section.all("//*[@class='number']"), ElementsAre("(22)"));
  EXPECT_THAT(section.all("//math"), ElementsAre("JV=−βC", "JV=−3"));
}

TEST(StepHtml, ClaimsAreFoldedToOneLineThatCountsTheVerdicts) {
  const auto in_short = [](const std::vector<Claim>& claims) {
    const Markup section = read([&](Page& page) {
      for (const Claim& one : claims) page.claim(one);
    });
    return section.all("//details[@class='claims']/summary");
  };
  EXPECT_THAT(in_short({claim("a", 1)}), ElementsAre("1 claim holds"));
  EXPECT_THAT(in_short({claim("a", 1), claim("b", 1.05)}), ElementsAre("2 claims hold"));
  EXPECT_THAT(in_short({claim("a", 1), claim("b", 2)}), ElementsAre("1 claim holds, 1 is false"));
  EXPECT_THAT(in_short({claim("a", 1), claim("b", 2, false), claim("c", 2, false)}),
              ElementsAre("1 claim holds, 2 are not made here"));
  EXPECT_THAT(in_short({claim("a", 2, false)}), ElementsAre("1 claim is not made here"));
}

TEST(StepHtml, AFalseClaimIsOpen) {
  EXPECT_THAT(told([](Page& page) { page.claim(claim("a", 1)); }), HasSubstr("data-false=\"0\">"));
  EXPECT_THAT(told([](Page& page) { page.claim(claim("a", 2)); }), HasSubstr("data-false=\"1\" open=\"open\">"));
}

TEST(StepHtml, AQuestionKeepsItsAnswerFolded) {
  const Markup section = read([](Page& page) {
    page.predict({.ask = "How far?",
                  .answer = 2,
                  .unit = "m",
                  .tolerance = 0.1,
                  .wrong = {{4, "Half of it."}},
                  .hints = {"Look.", "(8)"},
                  .right = "So far."});
    page.choose({.ask = "Which?",
                 .options = {{"this", "It is."}, {"that", "It is not."}},
                 .answer = 1,
                 .hints = {"Think."}});
  });
  EXPECT_EQ(section.mistake(), "");
  EXPECT_THAT(section.all("//form/@data-question"), ElementsAre("3a.1", "3a.2"));
  EXPECT_THAT(section.all("//form/@data-kind"), ElementsAre("number", "choice"));
  EXPECT_THAT(section.all("//form[1]//details/summary"), ElementsAre("Hint 1", "Hint 2", "Answer"));
  EXPECT_THAT(section.all("//form[2]//details/summary"), ElementsAre("Hint", "Answer"));
  EXPECT_THAT(section.all("//form[1]//details[@class='solution']/p"),
              ElementsAre("2 m. So far.", "Not 4 m: Half of it."));
  EXPECT_THAT(section.all("//form[2]//details[@class='solution']/p"),
              ElementsAre("Not 1. this: It is.", "2. that. It is not."));
  EXPECT_THAT(section.all("//form//*[not(ancestor-or-self::details)][contains(., 'So far')]"), IsEmpty());
  EXPECT_THAT(section.all("//input[@type='radio']/@value"), ElementsAre("1", "2"));
}

TEST(StepHtml, ACaptionSaysWhereAPanelIsOnScreensAndOnPhones) {
  const Markup section = read([](Page& page) {
    page.figure("two", "A bob. Right: its error.", [](renderer::Canvas&) {});
    page.figure("one", "Right: its error.", renderer::Chart{.curves = {{.x = {0, 1}, .y = {0, 1}}}});
  });
  EXPECT_THAT(section.all("//figcaption/*[@class='on-screens']"), ElementsAre("Right"));
  EXPECT_THAT(section.all("//figcaption/*[@class='on-phones']"), ElementsAre("Below"));
}

TEST(StepHtml, AFigureHasItsPictureCaptionLinksAndWords) {
  const Markup section = read([](Page& page) {
    page.figure("errors", "The *error*.",
                renderer::Chart{.x = {.label = "t (s)"},
                                .y = {.label = "C (m)"},
                                .curves = {{.label = "C", .x = {0, 1, 2}, .y = {3, 1, 5}}}});
  });
  EXPECT_THAT(section.all("//figure/@data-figure"), ElementsAre("errors"));
  EXPECT_THAT(section.all("//figure/div[@class='picture']/svg"), ElementsAre(""));
  EXPECT_THAT(section.all("//figcaption"), ElementsAre(HasSubstr("The error. SaveSVG PNG LINK")));
  EXPECT_THAT(section.all("//figure/figcaption/details[@class='words']"), ElementsAre(HasSubstr("3")));
}

TEST(StepHtml, TablesDerivationsAndSourceAreThere) {
  const Markup section = read([](Page& page) {
    page.table({"symbol", "meaning"}, {{"β", "a *share*"}, {"C", "the error"}});
    page.derivation("Why", {{"by (21)", "a = b", "a = b"}, {"then", "b = c", "b = c"}});
    page.excerpt("tests/lessons/fixture/main.cpp", "correct");
  });
  EXPECT_EQ(section.mistake(), "");
  EXPECT_THAT(section.all("//th[@scope='col']"), ElementsAre("symbol", "meaning"));
  EXPECT_THAT(section.all("//td"), ElementsAre("β", "a share", "C", "the error"));
  EXPECT_THAT(section.all("//details[@class='lines']/summary"), ElementsAre("Derivation: Why"));
  EXPECT_THAT(section.all("//details[@class='lines']//li/p"), ElementsAre("by (21)", "then"));
  EXPECT_THAT(section.all("//figure[@class='excerpt']/figcaption"), ElementsAre(HasSubstr("main.cpp, line ")));
  EXPECT_THAT(section.all("//pre/code"), ElementsAre("const double corrected = error - beta * error;\n"));
}

TEST(StepHtml, AColumnWithoutANameHasNoHeaderCell) {
  const Markup section = read([](Page& page) { page.table({"", "law"}, {{"1", "a law"}}); });
  EXPECT_THAT(section.all("//thead//th"), ElementsAre("law"));
  EXPECT_THAT(section.all("//thead//td"), ElementsAre(""));
}

struct Still final : Held {
  double h() const override { return 1; }
  double time() const override { return 0; }
  std::vector<Body> bodies() const override { return {}; }
  int held() const override { return -1; }
  void grab(const renderer::Point&) override {}
  void move(const renderer::Point&) override {}
  void release() override {}
  void step() override {}
  void reset() override {}
  std::string stopped() const override { return ""; }
  void go_on_from(const Held&) override {}
  void draw(renderer::Canvas& canvas, std::optional<double>) const override { canvas.text({480, 360}, "still"); }
  std::string words(std::optional<double>) const override { return "Energy 3 J."; }
};

TEST(StepHtml, ASceneToHoldComesBeforeTheClaimsAndSaysItsNumbers) {
  Lesson lesson({.slug = "98_told"});
  EXPECT_THROW(lesson.hold({"bob", "A bob.", [] { return std::make_unique<Still>(); }}), LessonError);
  lesson.step("One", [](Page& page) {
    page.text("Words.");
    page.claim(claim("a", 1));
  });
  lesson.hold({"bob", "A *bob*.", [] { return std::make_unique<Still>(); }});
  const RecordedStep recorded = record_step(lesson, lesson.steps().front(), true);
  const Markup section = of_page(site::step_html(recorded, {}));
  EXPECT_EQ(section.mistake(), "");
  EXPECT_THAT(section.all("/section/*/@data-item"), ElementsAre("0", "hold", "1"));
  EXPECT_THAT(section.all("//figure/@data-hold"), ElementsAre("bob"));
  EXPECT_THAT(section.all("//figure/div/@aria-label"), ElementsAre("A bob. Energy 3 J."));
  EXPECT_THAT(section.all("//figure/div/svg"), ElementsAre("still"));
  EXPECT_THAT(section.all("//figcaption"), ElementsAre("A bob."));
}

TEST(StepHtml, IsTheSameEachTime) {
  const auto run = [](Page& page) {
    page.text("β is @.", 0.1);
    page.equation(17);
  };
  EXPECT_EQ(told(run), told(run));
}

}  // namespace
}  // namespace byhand::tests
