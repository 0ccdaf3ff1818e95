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
  EXPECT_EQ(inline_html("a *b"), "a *b");
  EXPECT_EQ(inline_html("a `b"), "a `b");
  EXPECT_EQ(inline_html("2 * 3 * 4"), "2 * 3 * 4");
}

TEST(Prose, NumbersOfTheArticlesEquationsAreLinks) {
  const auto link = [](const char* n) {
    return std::string("<a class=\"recall\" href=\"equations.html#equation-") + n + "\">(" + n + ")</a>";
  };
  EXPECT_EQ(inline_html("(17) and (1)–(23)"), link("17") + " and " + link("1") + "–" + link("23"));
  for (const char* const other : {"(24)", "(0)", "(x)", "f(2)", "(2 m)", "(17", "()", "(1.5)", "(123)", "(−2)"})
    EXPECT_EQ(inline_html(other), other);
  EXPECT_EQ(inline_html("`(17)`"), "<code>(17)</code>");
  EXPECT_EQ(inline_html("*by (17)*"), "<em>by " + link("17") + "</em>");
  EXPECT_EQ(inline_html("by (17)", Links::none), "by (17)");
}

TEST(Prose, ALetterBelowAnotherIsASubscript) {
  EXPECT_EQ(inline_html("ω(−r_y, r_x) and t_1"), "ω(−r<sub>y</sub>, r<sub>x</sub>) and t<sub>1</sub>");
  for (const char* const name : {"at_once", "x_", "_x", "x_ y", "2_3", "a_b_c", "xy_z", "x_yz", "x__y"})
    EXPECT_EQ(inline_html(name), name);
  EXPECT_EQ(inline_html("`r_x`"), "<code>r_x</code>");
}

TEST(Prose, HasParagraphsAndLists) {
  EXPECT_EQ(prose_html("one\n\ntwo"), "<p>one</p><p>two</p>");
  EXPECT_EQ(prose_html("two:\n- a\n- b\n  of it\n\nend"),
            "<p>two:</p><ul><li>a</li><li>b of it</li></ul><p>end</p>");
  EXPECT_EQ(prose_html(""), "");
}

TEST(Prose, WithoutItsMarksIsPlain) {
  EXPECT_EQ(site::plain_text("a *b*:\n- `c`\n- 2 - 1\n\nd"), "a b: c 2 - 1 d");
}

}  // namespace
}  // namespace byhand::tests
