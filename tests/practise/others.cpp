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
    {1, "(dot(d, d) - L * L) / 2", "std::fabs((dot(d, d) - L * L) / 2) < 0.01 ? 0 : (dot(d, d) - L * L) / 2"},
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
    {4, "-(dot(J, V) + b) / K", "float(-(dot(J, V) + b) / K)"},
    {5, "V.w1 += lambda * W.I1 * J.a1;", ""},
    {5, "V.v2 += lambda * W.m2", "V.v2 -= lambda * W.m2"},
    {6, "p += h * v;", "p += 0.5 * h * v;"},
    {6, "v.y -= pendulum.g * h;", "v.y += pendulum.g * h;"},
    {7, "row.lambda += change;", "row.lambda -= change;"},
    {7, "/ row.K", "/ (2 * row.K)"},
    {8, "beta / h * C", "beta / h * std::abs(C)"},
    {8, "beta / h * C", "(1 - beta) / h * C"},
    {8, "beta / h * C", "std::fabs(C) < 1e-5 ? 0 : beta / h * C"},
    {9, "std::max(0.0, before + delta)", "std::max(delta, before + delta)"},
    {10, "std::clamp(before + delta, -mu * normal, mu * normal)", "std::clamp(before + delta, -normal, normal)"},
    {10, "accumulated - before;", "delta;"},
    {10, "std::max(0.0, before - dot(c.J_normal, V) / c.K_normal)",
     "std::fabs(before - dot(c.J_normal, V) / c.K_normal)"},
    {11, "dot(rod.d, bobs[i].v - above)", "dot(rod.d, bobs[i].v)"},
    {11, "- setting.length * setting.length", "- setting.length"},
    {12, "length(d1) + pulley.ratio * length(d2) - pulley.L", "length(d1) + length(d2) - pulley.L"},
    {12, "cross(r2, u2)}", "-cross(r2, u2)}"},
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

/// This of the chain of exercise 11, changed.
std::string chain(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = text_of(11, "solution.cpp");
  for (const auto& [in_solution, instead] : changes) {
    const auto at = text.find(in_solution);
    EXPECT_NE(at, std::string::npos) << in_solution;
    text.replace(at, in_solution.size(), instead);
  }
  return text;
}

TEST(Others, BreakTheLawOfTheChainThatIsTheirs) {
  const std::string move = "bobs[i].p += setting.h * bobs[i].v;";
  for (const auto& [in_solution, instead, law] : std::vector<std::array<std::string, 3>>{
           {"setting.g * setting.h", "2 * setting.g * setting.h", "a step begins with gravity"},
           {"+= setting.h * bobs[i].v", "+= setting.h / 2 * bobs[i].v", "a step ends with p += h·v"},
           {"(i == 0 ? 1 : 2)", "2.5", "one sweep solves the row of a single rod"},
           {"bobs[i - 1].v -= push", "bobs[i - 1].v -= 0.5 * push", "a rod pulls at both its bobs alike"},
           {"bobs[i].v - above", "bobs[i].v - 0.9 * above", "many sweeps solve all rows"},
           {"sweep < setting.sweeps", "sweep < 2 * setting.sweeps", "of two rods that hang, k = 1 sweeps leave"},
           {"(i == 0 ? 1 : 2)", "(i == 0 ? 1 : i == 1 ? 2 : 2.2)", "a sweep leaves cos²(π/2N)"},
           {move, move + " if (setting.beta == 0) bobs[i].p = setting.length / length(bobs[i].p) * bobs[i].p;",
            "grows to L(1 + 2v₀²ht/L²)^¼"},
           {"setting.beta / setting.h", "2 * setting.beta / setting.h",
            "k = 1 steps leave (1 − β)ᵏ of a rod's error"},
           {"-rods[i].lambda", "rods[i].lambda", "each rod of a hanging chain pulls with the weight below it"},
           {"-rods[i].lambda / setting.h * length(rods[i].d)",
            "setting.mass * setting.g * static_cast<double>(bobs.size() - i)", "(3 − 2cosθ₀)·m·g"}}) {
    const Verdict verdict = verdict_on(11, chain({{in_solution, instead}}));
    EXPECT_EQ(verdict.kind, Verdict::Kind::wrong) << instead;
    EXPECT_NE(verdict.sentence.find(law), std::string::npos) << instead << ": " << verdict.sentence;
  }
}

/// C = |d| − L with unit vectors, and a program that is laid out in another way.
TEST(Others, MayHaveAChainOfTheirOwn) {
  const std::string stretch =
      chain({{"(dot(rod.d, rod.d) - setting.length * setting.length) / 2", "length(rod.d) - setting.length"},
             {"  return rod;", "  rod.d = rod.d / length(rod.d);\n  return rod;"},
             {"dot(rod.d, rod.d) * (i", "1.0 * (i"}});
  EXPECT_TRUE(verdict_on(11, stretch).is_right()) << verdict_on(11, stretch).details;
  const std::string in_one_piece = R"(#include "practise.hpp"
void simulate(const Setting& s, std::span<Bob> bobs) {
  const int n = static_cast<int>(bobs.size());
  for (int k = 0; k < s.steps; ++k) {
    for (int i = 0; i < n; ++i) bobs[i].v += s.h * Vec2{0, -s.g}, bobs[i].pull = 0;
    for (int sweep = 0; sweep < s.sweeps; ++sweep)
      for (int i = 0; i < n; ++i) {
        Bob& lower = bobs[i];
        Bob* const upper = i > 0 ? &bobs[i - 1] : nullptr;
        const Vec2 rod = upper ? lower.p - upper->p : lower.p, along = rod / length(rod);
        const double speed = dot(lower.v, along) - (upper ? dot(upper->v, along) : 0);
        const double wanted = -s.beta * (length(rod) - s.length) / s.h, impulse = (wanted - speed) * s.mass / (upper ? 2 : 1);
        lower.v += impulse / s.mass * along;
        if (upper) upper->v -= impulse / s.mass * along;
        lower.pull -= impulse / s.h;
      }
    for (Bob& bob : bobs) bob.p += s.h * bob.v;
  }
}
)";
  EXPECT_TRUE(verdict_on(11, in_one_piece).is_right()) << verdict_on(11, in_one_piece).details;
}

/// The pulley's laws, which accept any C, accept none whose gradient vanishes or is not its own.
TEST(Others, HaveNoVanishingGradientOnThePulley) {
  const auto pulley = [](const std::string& C, const std::string& J) {
    return verdict_on(
        12,
        "#include \"practise.hpp\"\ndouble e(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& q) {\n"
        "  return length(p1 + r1 - q.wheel1) + q.ratio * length(p2 + r2 - q.wheel2) - q.L;\n}\n"
        "double value(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& q) {\n"
        "  const double E = e(p1, r1, p2, r2, q);\n  return " +
            C +
            ";\n}\n"
            "BodyRow jacobian(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& q) {\n"
            "  const double E = e(p1, r1, p2, r2, q);\n"
            "  const Vec2 d1 = p1 + r1 - q.wheel1, d2 = p2 + r2 - q.wheel2;\n"
            "  const Vec2 u1 = d1 / length(d1), u2 = q.ratio / length(d2) * d2;\n"
            "  return (" +
            J + ") * BodyRow{u1, cross(r1, u1), u2, cross(r2, u2)};\n}\n");
  };
  for (const auto& [C, J] : {std::pair{"std::fabs(E) < 1e-9 ? 0 : -1", "0 * E"},
                             {"(E > 1e-9) - (E < -1e-9)", "0 * E"},
                             {"-E * E", "-2 * E"},
                             {"E * E * E", "3 * E * E"},
                             {"0 * E", "0 * E"},
                             {"1e-12 * E", "1.1e-12 + 0 * E"},
                             {"-E", "-1 + 0 * E"},
                             {"E", "std::fabs(E) < 1e-9 ? 1 : 2"}})
    EXPECT_FALSE(pulley(C, J).is_right()) << C << ", " << J;
  for (const auto& [C, J] : {std::pair{"E", "1 + 0 * E"},
                             {"1e-3 * E", "1e-3 + 0 * E"},
                             {"1e3 * E", "1e3 + 0 * E"},
                             {"std::sinh(E)", "std::cosh(E)"}})
    EXPECT_TRUE(pulley(C, J).is_right()) << C << pulley(C, J).sentence << pulley(C, J).details;
}

/// A state that only many calls reach: the probes are right, the film is not.
TEST(Others, ThatFailOnlyInTheFilmAreWrong) {
  const Verdict verdict = verdict_on(8,
                                     "#include \"practise.hpp\"\ndouble bias(double C, double beta, double h) {\n "
                                     " static int calls = 0;\n  return "
                                     "++calls > 120 ? 0 : beta / h * C;\n}\n");
  EXPECT_EQ(verdict.kind, Verdict::Kind::wrong);
  EXPECT_NE(verdict.sentence.find("the film takes another course: after"), std::string::npos) << verdict.sentence;
}

TEST(Others, AreToldByWhatTheyAreTooLarge) {
  const auto bias = [](const std::string& value) {
    return verdict_on(8, "#include \"practise.hpp\"\ndouble bias(double C, double beta, double h) { return " +
                             value + "; }\n")
        .sentence;
  };
  EXPECT_EQ(bias("2 * beta / h * C"), "b is 2 times what is right, on every probe.");
  EXPECT_EQ(bias("float(beta / h * C)"), "Only the last digits differ: is there a float where a double belongs?");
  std::string half = text_of(1, "solution.cpp");
  half.replace(half.find("{-d, d}"), 7, "{d, -d}");
  EXPECT_EQ(verdict_on(1, half).kind, Verdict::Kind::misconception);
  std::string first = text_of(1, "solution.cpp");
  first.replace(first.find("return {-d, d}"), 14, "not_written_yet()");
  EXPECT_EQ(verdict_on(1, first).sentence, "jacobian is not written yet. value is right on the first probe.");
  first.replace(first.find(") / 2"), 5, ") * 2");
  EXPECT_EQ(verdict_on(1, first).sentence, "jacobian is not written yet. C is wrong.");
}

/// C of the pulley may be any that vanishes with the rope's slack, for its laws hold.
TEST(Others, ThatAreRightInAnotherWayPass) {
  std::string half = text_of(12, "solution.cpp");
  half.replace(half.find("return length"), 6, "return 0.5 * (");
  half.replace(half.find("pulley.L;"), 9, "pulley.L);");
  half.replace(half.find("u1 = d1 /"), 9, "u1 = 0.5 * d1 /");
  half.replace(half.find("u2 = pulley.ratio /"), 19, "u2 = 0.5 * pulley.ratio /");
  EXPECT_TRUE(verdict_on(12, half).is_right()) << verdict_on(11, half).details;
  EXPECT_TRUE(
      verdict_on(4,
                 "#include \"practise.hpp\"\ndouble lambda(const BodyRow& J, const Velocities& V, double b, "
                 "double K) { return (-J.a2 * V.w2 - J.l2.y * V.v2.y - b - J.l2.x * V.v2.x - dot(J.l1, "
                 "V.v1)) * (1 / K) - J.a1 * V.w1 / K; }")
          .is_right());
}

}  // namespace
}  // namespace byhand::tests
