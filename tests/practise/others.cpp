// Wrong solutions that no list foresees get a failing probe, never the sentence of a misconception that is not
// theirs.

#include <gtest/gtest.h>

#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using namespace practise;

struct Wrong {
  int number;
  const char* in_solution;  // this of the solution
  const char* instead;
};

constexpr Wrong wrongs[] = {
    {1, "(dot(d, d) - L * L) / 2", "(dot(d, d) + L * L) / 2"},
    {1, "(dot(d, d) - L * L) / 2", "dot(d, d) / 2 - L"},
    {1, "{-d, d}", "{-d, 2 * d}"},
    {1, "{-d, d}", "{-d / length(d), d / length(d)}"},
    {2, "-cross(r1, d)", "-2 * cross(r1, d)"},
    {2, "cross(r2, d)}", "dot(r2, d)}"},
    {2, "cross(r2, d)}", "cross(r2 - r1, d)}"},
    {3, "dot(J.l1, J.l1) / m1", "length(J.l1) / m1"},
    {3, "J.a2 * J.a2 / I2", "J.a2 / I2"},
    {3, "dot(J.l2, J.l2) / m2", "dot(J.l2, J.l2) / m1"},
    {4, "-(dot(J, V) + b) / K", "-dot(J, V) / K + b"},
    {4, "-(dot(J, V) + b) / K", "-(dot(J, V) + 2 * b) / K"},
    {5, "V.w1 += lambda * W.I1 * J.a1;", ""},
    {5, "V.v2 += lambda * W.m2", "V.v2 -= lambda * W.m2"},
    {6, "p += h * v;", "p += 0.5 * h * v;"},
    {6, "v.y -= pendulum.g * h;", "v.y += pendulum.g * h;"},
    {7, "row.lambda += change;", "row.lambda -= change;"},
    {7, "/ row.K", "/ (2 * row.K)"},
    {8, "beta / h * C", "beta / h * std::abs(C)"},
    {8, "beta / h * C", "(1 - beta) / h * C"},
    {9, "accumulated - before;", "accumulated;"},
    {9, "std::max(0.0, before + delta)", "std::max(delta, before + delta)"},
    {10, "std::clamp(before + delta, -mu * normal, mu * normal)", "std::clamp(before + delta, -normal, normal)"},
    {10, "accumulated - before;", "delta;"},
    {11, "length(d1) + pulley.ratio * length(d2) - pulley.L", "length(d1) + length(d2) - pulley.L"},
    {11, "cross(r2, u2)}", "-cross(r2, u2)}"},
};

class Others : public testing::TestWithParam<Wrong> {};
INSTANTIATE_TEST_SUITE_P(All, Others, testing::ValuesIn(wrongs));

TEST_P(Others, GetAFailingProbe) {
  const auto& [number, in_solution, instead] = GetParam();
  std::string text = text_of(number, "solution.cpp");
  const auto at = text.find(in_solution);
  ASSERT_NE(at, std::string::npos) << in_solution;
  text.replace(at, std::string(in_solution).size(), instead);
  const Verdict verdict = verdict_on(number, text);
  EXPECT_EQ(verdict.kind, Verdict::Kind::wrong) << instead << ": " << verdict.sentence << verdict.details;
  EXPECT_NE(verdict.details.find("Probe "), std::string::npos) << instead;
}

/// C of the pulley may be any that vanishes with the rope's slack, for its laws hold.
TEST(Others, ThatAreRightInAnotherWayPass) {
  std::string half = text_of(11, "solution.cpp");
  half.replace(half.find("return length"), 6, "return 0.5 * (");
  half.replace(half.find("pulley.L;"), 9, "pulley.L);");
  half.replace(half.find("u1 = d1 /"), 9, "u1 = 0.5 * d1 /");
  half.replace(half.find("u2 = pulley.ratio /"), 19, "u2 = 0.5 * pulley.ratio /");
  EXPECT_TRUE(verdict_on(11, half).is_right()) << verdict_on(11, half).details;
  EXPECT_TRUE(
      verdict_on(4,
                 "#include \"practise.hpp\"\ndouble lambda(const BodyRow& J, const Velocities& V, double b, "
                 "double K) { return (-J.a2 * V.w2 - J.l2.y * V.v2.y - b - J.l2.x * V.v2.x - dot(J.l1, "
                 "V.v1)) * (1 / K) - J.a1 * V.w1 / K; }")
          .is_right());
}

}  // namespace
}  // namespace byhand::tests
