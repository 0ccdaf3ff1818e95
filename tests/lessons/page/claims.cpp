#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lessons/page/claim_words.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/page.hpp"
#include "lessons/page/recording.hpp"

// A claim's range and a verdict's condition print themselves.
namespace {

using namespace byhand::course;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Condition, PrintsWhatItTests) {
  const Quantity beta("β", 1.5);
  EXPECT_EQ((beta < 1.5).words, "β < 1.5");
  EXPECT_EQ((beta <= 1.5).words, "β ≤ 1.5");
  EXPECT_EQ((beta > 1.5).words, "β > 1.5");
  EXPECT_EQ((beta >= 1.5).words, "β ≥ 1.5");
  EXPECT_EQ((beta >= 1.5).found, "β = 1.5");
  EXPECT_FALSE(beta < 1.5);
  EXPECT_TRUE(beta <= 1.5);
  EXPECT_FALSE(beta > 1.5);
  EXPECT_TRUE(beta >= 1.5);
}

TEST(Condition, PrintsUnits) {
  EXPECT_EQ((Quantity("release", 90, "°") <= 120).words, "release ≤ 120°");
  EXPECT_EQ((Quantity("h", 0.01, "s") <= 0.02).words, "h ≤ 0.02 s");
  EXPECT_EQ((Quantity("C", -1e-5, "m") > -2e-5).words, "C > −2·10⁻⁵ m");
}

TEST(Condition, CallsRoundingByItsName) {
  EXPECT_EQ((Quantity("slip", 4e-17) < 1e-6).found, "slip = 4·10⁻¹⁷ (rounding)");
  EXPECT_EQ((Quantity("slip", 0) == 0).found, "slip = 0");
  EXPECT_TRUE(Quantity("slip", 0) == 0);
  EXPECT_FALSE(Quantity("slip", 4e-17) == 0);
}

TEST(Condition, ComparesWithALimitThatHasAName) {
  const Condition condition = Quantity("β", 0.2) < Quantity("(1 − q)/q", 0.5);
  EXPECT_TRUE(condition);
  EXPECT_EQ(condition.words, "β < (1 − q)/q");
  EXPECT_EQ(condition.found, "β = 0.2, (1 − q)/q = 0.5");
  EXPECT_FALSE(Quantity("β", 0.5) < Quantity("(1 − q)/q", 0.5));
}

TEST(Condition, WithinHasClosedEnds) {
  for (const auto& [angle, inside] : {std::pair{29.9, false}, {30, true}, {120, true}, {120.1, false}})
    EXPECT_EQ(within(30, Quantity("release", angle, "°"), 120).met, inside) << angle;
  EXPECT_EQ(within(30, Quantity("release", 60, "°"), 120).words, "30° ≤ release ≤ 120°");
}

TEST(Condition, WhereNeedsAllOfThemEitherNeedsOne) {
  const Quantity beta("β", 1.8), links("N", 5);
  const Condition all = where(beta <= 2, links <= 12, links >= 6);
  EXPECT_FALSE(all);
  EXPECT_EQ(all.words, "β ≤ 2, N ≤ 12, N ≥ 6");
  EXPECT_EQ(all.found, "β = 1.8, N = 5") << "a number is printed once";
  EXPECT_EQ(both(beta <= 2, beta < Quantity("limit", 1.9)).found, "β = 1.8, limit = 1.9");
  const Quantity stood("stood, cold", 5);
  EXPECT_EQ(both(stood < 7, stood < 6).words, "stood, cold < 7, stood, cold < 6");
  const Condition one = either(beta <= 1.5, both(beta <= 2, links <= 12));
  EXPECT_TRUE(one);
  EXPECT_EQ(one.words, "β ≤ 1.5, or β ≤ 2, N ≤ 12");
  EXPECT_FALSE(either(beta <= 1.5, links > 12));
}

TEST(Condition, IsNeverMetByANumberThatIsNone) {
  const Quantity lost("C", std::nan(""));
  for (const Condition& condition : {lost<1, lost <= 1, lost> 1, lost >= 1, within(0, lost, 1)})
    EXPECT_FALSE(condition) << condition.words;
}

TEST(Claim, InOneLineIsTheSameAsByItsFields) {
  Page page;
  page.claim("period", 2.001, "s", is(2, "elliptic integral", relative(1e-3)), Quantity("h", 0.5, "s") <= 0.1);
  page.claim("largest C", 3, "m", is_at_most(2, "a bound"));
  page.claim("smallest C", 3, "m", is_at_least(2, "a bound"));
  const std::vector<Claim> made = claims(page);
  ASSERT_THAT(made, SizeIs(3));
  EXPECT_EQ(verdict(made[0]), "not claimed");
  EXPECT_EQ(made[0].range.words, "h ≤ 0.1 s");
  EXPECT_EQ(made[0].source, "elliptic integral");
  EXPECT_EQ(measurement(made[0]), "2.001 s");
  EXPECT_EQ(verdict(made[1]), "false");
  EXPECT_EQ(verdict(made[2]), "holds");
}

/// What is said of a ratio; nothing from 0.5 to 0.9.
std::string said(Page& page, double ratio, const Condition& law = {}) {
  const Quantity left("C/C₀", ratio);
  return page.verdict({{.when = left < 0.5, .say = "The error is\n    halved.", .law = law},
                       {.when = left > 0.9, .say = "The error stays."}});
}

TEST(Verdict, IsTheFirstSentenceThatItsNumberMeets) {
  Page page;
  EXPECT_EQ(said(page, 0.25), "The error is halved.");
  EXPECT_EQ(said(page, 0.95), "The error stays.");
  EXPECT_EQ(page.verdict(
                {{.when = Quantity("N", 3) > 1, .say = "First."}, {.when = Quantity("N", 3) > 2, .say = "Next."}}),
            "First.");
}

TEST(Verdict, IsAClaimBelowItsText) {
  Page page;
  page.text("It is so. @", said(page, 0.25));
  ASSERT_THAT(page.items(), SizeIs(2));
  EXPECT_EQ(std::get<Text>(page.items()[0]).words, "It is so. The error is halved.");
  const Claim claim = claims(page).at(0);
  EXPECT_EQ(claim.quantity, "“The error is halved.”");
  EXPECT_EQ(expectation(claim), "C/C₀ < 0.5");
  EXPECT_EQ(measurement(claim), "C/C₀ = 0.25");
  EXPECT_EQ(verdict(claim), "holds");
  page.text("Further.");
  EXPECT_THAT(claims(page), SizeIs(1)) << "claimed once";
}

// Compilers differ in which argument of a call they compute first.
TEST(Verdict, ComesWhereItsSentenceStandsInTheText) {
  Page page;
  const std::string last = said(page, 0.95), first = said(page, 0.25);
  page.text("@ @", first, last);
  ASSERT_THAT(claims(page), SizeIs(2));
  EXPECT_EQ(claims(page)[0].quantity, "“The error is halved.”");
  EXPECT_EQ(claims(page)[1].quantity, "“The error stays.”");
}

TEST(Verdict, SaysAndClaimsNothingWhereNoSentenceFits) {
  for (const double ratio : {0.5, 0.7, 0.9, std::nan("")}) {
    Page page;
    EXPECT_EQ(said(page, ratio), "") << ratio;
    page.text("Further.");
    EXPECT_THAT(claims(page), IsEmpty());
  }
}

TEST(Verdict, IsFalseWhereTheLawPredictsAnother) {
  const auto by_law = [](double limit) {
    Page page;
    page.text("@", said(page, 0.25, Quantity("β", 1) < Quantity("limit", limit)));
    return claims(page).at(0);
  };
  EXPECT_FALSE(by_law(2).is_false());
  EXPECT_TRUE(by_law(0.5).is_false());
  EXPECT_EQ(expectation(by_law(0.5)), "C/C₀ < 0.5, β < limit");
  EXPECT_EQ(measurement(by_law(0.5)), "C/C₀ = 0.25, β = 1, limit = 0.5");
}

TEST(Verdict, NamesItsNumbers) {
  Page page;
  try {
    page.verdict({{.when = Condition{true, "always"}, .say = "It is so."}});
    ADD_FAILURE() << "a condition without a number was accepted";
  } catch (const LessonError& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"It is so.\" does not name the number that it judges"));
  }
}

}  // namespace
