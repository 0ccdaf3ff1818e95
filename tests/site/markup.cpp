#include "lessons/page/html/markup.hpp"

#include <gtest/gtest.h>

namespace byhand::tests {
namespace {

using site::inline_html;
using site::Links;
using site::prose_html;

TEST(Prose, MarksBecomeElementsAndTheRestIsEscaped) {
  EXPECT_EQ(inline_html("a *share* of `beta < 1` & **more**"),
            "a <em>share</em> of <code>beta &lt; 1</code> &amp; <strong>more</strong>");
  EXPECT_EQ(inline_html("`*p` points"), "<code>*p</code> points");
}

TEST(Prose, AMarkWithoutAPartnerIsACharacter) {
  EXPECT_EQ(inline_html("2 * 3"), "2 * 3");
  EXPECT_EQ(inline_html("one *two"), "one *two");
  EXPECT_EQ(inline_html("one `two"), "one `two");
  EXPECT_EQ(inline_html("2 * 3 * 4"), "2 * 3 * 4");
}

TEST(Prose, NumbersOfTheArticlesEquationsAreLinks) {
  const auto link = [](const char* n) {
    return std::string("<a class=\"recall\" href=\"equations.html#equation-") + n + "\">(" + n + ")</a>";
  };
  EXPECT_EQ(inline_html("(17) and (1)–(23)"), link("17") + " and " + link("1") + "–" + link("23"));
  for (const char* const other : {"(24)", "(0)", "(one)", "(2 m)", "(17", "()", "(1.5)", "(123)", "(−2)"})
    EXPECT_EQ(inline_html(other, Links::none), other);
  EXPECT_EQ(inline_html("f(2)"), "<span class=\"whole\"><math><mi>f</mi></math>(2)</span>");
  EXPECT_EQ(inline_html("`(17)`"), "<code>(17)</code>");
  EXPECT_EQ(inline_html("*by (17)*"), "<em>by " + link("17") + "</em>");
  EXPECT_EQ(inline_html("by (17)", Links::none), "by (17)");
}

TEST(Prose, ALetterBelowAnotherIsASubscript) {
  const auto quantity = [](const char* letter) { return std::string("<math><mi>") + letter + "</mi></math>"; };
  const auto whole = [](const std::string& word) { return "<span class=\"whole\">" + word + "</span>"; };
  EXPECT_EQ(inline_html("ω(−r_y, r_x) and t_1"), whole(quantity("ω") + "(−" + quantity("r") + "<sub>y</sub>,") +
                                                     " " + whole(quantity("r") + "<sub>x</sub>)") + " and " +
                                                     whole(quantity("t") + "<sub>1</sub>"));
  for (const char* const name : {"at_once", "x_", "_x", "x_ one", "2_3", "a_b_c", "xy_z", "x_yz", "x__y"})
    EXPECT_EQ(inline_html(name), name);
  EXPECT_EQ(inline_html("`r_x`"), "<code>r_x</code>");
}

TEST(Prose, AnOptionOfACommandStaysWhole) {
  EXPECT_EQ(inline_html("`./lessons/run 2 --step 7b`"),
            "<code>./lessons/run 2 <span class=\"whole\">--step</span> 7b</code>");
  EXPECT_EQ(inline_html("`a - b`"), "<code>a - b</code>");
}

TEST(Prose, AnExponentInBracketsIsRaised) {
  EXPECT_EQ(inline_html("4^(1/3)"), "4<sup>1/3</sup>");
  EXPECT_EQ(inline_html("(2)^(3)", Links::none), "(2)<sup>3</sup>");
  EXPECT_EQ(inline_html("e^(−βt)"),
            "<span class=\"whole\"><math><mi>e</mi></math><sup>"
            "<span class=\"whole\">−<math><mi>β</mi><mi>t</mi></math></span></sup></span>");
  for (const char* const other : {"^(", "2 ^(3)", "2^(3"}) EXPECT_EQ(inline_html(other, Links::none), other);
}

TEST(Prose, QuantitiesAreSetAsInADisplay) {
  EXPECT_EQ(inline_html("JV = −(β/h)C"),
            "<math><mi>J</mi><mi>V</mi></math> = <span class=\"whole\">−(<math><mi>β</mi></math>/<math><mi>h</mi>"
            "</math>)<math><mi>C</mi></math></span>");
  const std::string rate = "<math><mover accent=\"true\"><mi>C</mi><mo stretchy=\"false\">˙</mo></mover></math>";
  EXPECT_EQ(inline_html("Ċ"), rate);
  EXPECT_EQ(inline_html("C\u0307"), rate);
  EXPECT_EQ(inline_html("*h* is 2 s"), "<em><math><mi>h</mi></math></em> is 2 s");
}

TEST(Prose, AQuantityStaysInOneLineWithWhatTouchesIt) {
  const std::string h = "<math><mi>h</mi></math>", begin = "<span class=\"whole\">", end = "</span>";
  EXPECT_EQ(inline_html("with h, and (h)."), "with " + h + ", and " + begin + "(" + h + ")." + end);
  EXPECT_EQ(inline_html("in |h|/2 of"), "in " + begin + "|" + h + "|/2" + end + " of");
  EXPECT_EQ(inline_html("**h in bold**/2"), "<strong>" + h + " in bold</strong>/2");
  EXPECT_EQ(inline_html("a word of **h/2**"), "a word of <strong>" + begin + h + "/2" + end + "</strong>");
  EXPECT_EQ(inline_html("1/(1+h+1/2+1/3+1/4+1/5+1/6+1/7+1/8+1/9)").find("whole"), std::string::npos)
      << "what is longer than a phone is wide may break";
}

TEST(Prose, OtherLettersAreNoQuantities) {
  for (const char* const other : {"A step of a second", "see step 7b and steps 4c, 5", "in C++ and in 3D",
                                  "R. Gaul, e.g. i.e.", "2 m/s, 3 N", "3.2·10⁻⁷ m of 4·10⁻¹⁵ kg m²/s",
                                  "in N·s/m, m²/s, kg m² or 1/s", "Box2D", "the joint's", "`h` and `C`"})
    EXPECT_EQ(inline_html(other).find("<math>"), std::string::npos) << inline_html(other);
}

TEST(Prose, HasParagraphsAndLists) {
  EXPECT_EQ(prose_html("one\n\ntwo"), "<p>one</p><p>two</p>");
  EXPECT_EQ(prose_html("two:\n- one\n- the other\n  of it\n\nend"),
            "<p>two:</p><ul><li>one</li><li>the other of it</li></ul><p>end</p>");
  EXPECT_EQ(prose_html(""), "");
}

TEST(Prose, WithoutItsMarksIsPlain) {
  EXPECT_EQ(site::plain_text("a *b*:\n- `c`\n- 2 - 1\n\nd"), "a b: c 2 - 1 d");
}

}  // namespace
}  // namespace byhand::tests
