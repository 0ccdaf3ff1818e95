// Lines as a learner types them: what can be read, what is said, and with what status it ends.
#include "lessons/desk/sheet.hpp"

#include <gtest/gtest.h>

#include "lessons/desk/lexer.hpp"
#include "lessons/desk/print.hpp"
#include "lessons/desk/report.hpp"

namespace byhand::desk {
namespace {

Sheet sheet_of(const std::vector<std::string>& lines) {
  Sheet sheet;
  for (const std::string& line : lines) sheet.add(line);
  return sheet;
}

TEST(DeskSheet, TheArticlesDerivationIsRight) {
  for (const char* world : {"in the plane", "in space"}) {
    const Sheet sheet =
        sheet_of({world, "C  = |p2 - p1|^2/2 - L^2/2", "dC = (p2 - p1) . (v2 + w2 x r2 - v1 - w1 x r1)",
                  "   = (p2 - p1) . v2 + (p2 - p1) . (w2 x r2) - (p2 - p1) . v1 - (p2 - p1) . (w1 x r1)",
                  "   = (p2 - p1) . v2 + w2 . (r2 x (p2 - p1)) - (p2 - p1) . v1 - w1 . (r1 x (p2 - p1))",
                  "J  = [ -d, -(r1 x d), d, r2 x d ]"});
    EXPECT_EQ(sheet.status(), 0);
    EXPECT_TRUE(sheet.complete());
  }
}

TEST(DeskSheet, LatexIsPasted) {
  const Sheet sheet = sheet_of({R"($$C = \frac{1}{2}\left[ \right]$$)"});
  EXPECT_EQ(sheet.status(), 2);
  const Sheet article = sheet_of({R"(C = \frac{1}{2} \left( (P_2 - P_1)^2 - L^2 \right))"});
  EXPECT_EQ(article.status(), 0) << "the article's P is p";
  const Sheet right =
      sheet_of({R"(C &= \tfrac12 \lVert \mathbf{p}_2 - p_1 \rVert^2 - \frac{L^2}{2} \\)",
                R"(\dot{C} &= (p_2 - p_1) \cdot ((v_2 + \omega_2 \times r_2) - (v_1 + \omega_1 \times r_1)))",
                R"(J = \begin{bmatrix} -d & -r_1 \times d & d & r_2 \times d \end{bmatrix})"});
  EXPECT_EQ(right.status(), 0);
  EXPECT_TRUE(right.complete());
}

TEST(DeskSheet, ErrorsPointAtTheCharacter) {
  Sheet sheet;
  const auto at = [&](const char* line) {
    const auto checks = sheet.add(line);
    EXPECT_EQ(checks.size(), 1u);
    return checks.empty() ? std::pair{-1, std::string()} : std::pair{checks[0].where.begin, checks[0].sentence};
  };
  EXPECT_EQ(at("C = d . q").first, 8);
  EXPECT_EQ(at("C = d . (n + ").first, 13);
  EXPECT_EQ(at("C = (d . n").first, 4);
  EXPECT_EQ(at("C = d # n").first, 6);
  EXPECT_EQ(at("C = r1 r2").second,
            "Between the vectors r1 and r2 write · or ×: their product is one or the other.");
  EXPECT_TRUE(at("C = d . n + omga1").second.starts_with("omga1 is not known; did you mean ω1?"));
  EXPECT_EQ(at("C = n . (r1 + w1 x r1)").second,
            "ω1 × r1 is a velocity [m/s]; it is added to r1, which is a length [m].");
}

TEST(DeskSheet, StatusesAreOfTheWorstLine) {
  EXPECT_EQ(sheet_of({"C = d . n"}).status(), 0);
  EXPECT_EQ(sheet_of({"C = d . n", "dC = n . v2"}).status(), 1);
  EXPECT_EQ(sheet_of({"C = d . n", "dC = n . v2", "J = ["}).status(), 2);
}

TEST(DeskSheet, ALineIsHeldAgainstTheOneBefore) {
  Sheet sheet = sheet_of({"C = d . n", "dC = n . v2"});
  EXPECT_EQ(sheet.add("= v2 . n")[0].outcome, Check::Outcome::right);
  EXPECT_EQ(sheet.add("= n . d'")[0].outcome, Check::Outcome::right) << "back to the right line";
  EXPECT_EQ(sheet.add("= n . d' + n . v1")[0].outcome, Check::Outcome::wrong);
}

TEST(DeskSheet, RatesWithoutAC) {
  Sheet sheet = sheet_of({"in the plane", "dC = perp(u) . v1"});
  EXPECT_NE(sheet.add("J = [perp(u), 0, 0, 0]")[0].sentence.find("Right"), std::string::npos);
  EXPECT_TRUE(sheet.complete());
  EXPECT_NE(text_of(report(sheet)).find("There is no C"), std::string::npos);
  Sheet squared;
  EXPECT_EQ(squared.add("dC = v1 . v1 - L v1 . n")[0].outcome, Check::Outcome::wrong);
  Sheet quadratic;
  EXPECT_NE(quadratic.add("dC = v1 . v1")[0].sentence.find("not linear"), std::string::npos);
}

TEST(DeskSheet, SeveralRowsAndVectorRows) {
  Sheet pin = sheet_of(
      {"in the plane", "C = p2 - p1", "dC = v2 + w2 x r2 - v1 - w1 x r1", "J = [-E, -perp(r1), E, perp(r2)]"});
  EXPECT_EQ(pin.status(), 0);
  EXPECT_TRUE(pin.complete());
  EXPECT_EQ(report(pin).rank, 2);
  Sheet space = sheet_of({"in space", "C = p2 - p1", "J = [-E, skew(r1), E, -skew(r2)]"});
  EXPECT_EQ(space.status(), 0);
  EXPECT_EQ(report(space).rank, 3);
  Sheet two = sheet_of({"in the plane", "C1 = d . n", "C2 = 2 d . n", "J1 = [-n, -(r1 x n), n, r2 x n]",
                        "J2 = [-2 n, -2 (r1 x n), 2 n, 2 (r2 x n)]"});
  EXPECT_EQ(two.status(), 0);
  const Report both = report(two);
  EXPECT_EQ(both.count, 2);
  EXPECT_EQ(both.rank, 1);
}

TEST(DeskSheet, SaysWhereCHasNoDerivativeAndWhereJVanishes) {
  const auto said = [](const char* C) {
    const Vocabulary words({2, true});
    std::string all;
    for (const std::string& sentence : singularities(words, parse_expression(C, words))) all += sentence + "\n";
    return all;
  };
  EXPECT_NE(said("|d| - L").find("not differentiable where d = 0"), std::string::npos) << said("|d| - L");
  EXPECT_EQ(said("|d|^2/2 - L^2/2").find("not differentiable"), std::string::npos);
  EXPECT_NE(said("|d|^2/2 - L^2/2").find("J vanishes where d = 0; there C is not 0"), std::string::npos)
      << said("|d|^2/2 - L^2/2");
  EXPECT_NE(said("d . d").find("C = 0 itself"), std::string::npos) << said("d . d");
  EXPECT_NE(said("atan2(d . n, d . t)").find("jumps"), std::string::npos);
  EXPECT_EQ(said("d . n"), "");
}

TEST(DeskSheet, SaysAtWhatAnglesJVanishes) {
  const auto said = [](const World& world, const char* C) {
    Vocabulary words(world);
    std::string all;
    for (const std::string& sentence : singularities(words, parse_expression(C, words))) all += sentence + "\n";
    return all;
  };
  const World plane{2, true}, space{3, true};
  EXPECT_NE(said(plane, "1 - cos(θ2 - θ1)").find("vanishes at angles at which C = 0"), std::string::npos);
  EXPECT_NE(said(plane, "cos(θ2 - θ1)").find("vanishes at some angles; there C is not 0"), std::string::npos);
  EXPECT_NE(said(space, "1 - u . (R2 ex)").find("vanishes at angles at which C = 0"), std::string::npos)
      << said(space, "1 - u . (R2 ex)");
  for (const char* never : {"θ2 - θ1", "u . d", "sin(θ2 - θ1) + 2 (θ2 - θ1)"})
    EXPECT_EQ(said(plane, never), "") << never;
}

TEST(DeskSheet, InequalitiesSayWhatChanges) {
  Sheet sheet;
  EXPECT_NE(sheet.add("C = d . n >= 0")[0].sentence.find("λ is kept ≥ 0"), std::string::npos);
}

TEST(DeskSheet, KnowsTheConstraintsOfTheCourse) {
  const auto ours = [](const std::vector<std::string>& lines) { return text_of(report(sheet_of(lines))); };
  EXPECT_NE(ours({"C = d . d - L^2", "J = [-2 d, -2 (r1 x d), 2 d, 2 (r2 x d)]"})
                .find("solver/constraints/distance.hpp"),
            std::string::npos);
  EXPECT_NE(ours({"a: unit vector on body 1", "C = a . d", "J = [-a, -((r1 + d) x a), a, r2 x a]"})
                .find("slide along an axis of body 1"),
            std::string::npos);
  EXPECT_NE(ours({"C = d . n", "J = [-n, -(r1 x n), n, r2 x n]"}).find("(15)"), std::string::npos);
}

}  // namespace
}  // namespace byhand::desk
