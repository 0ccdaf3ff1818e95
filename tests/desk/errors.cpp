// The names of wrong lines are found under renaming, reordering and scaling.
#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <set>

#include "lessons/desk/print.hpp"
#include "lessons/desk/sheet.hpp"

namespace byhand::desk {
namespace {

struct Case {
  const char* name;
  std::vector<std::string> lines;  // all right but the last
};

const std::vector<Case>& cases() {
  static const std::string rod = "C = |d|^2/2 - L^2/2", rate = "dC = d . (v2 + w2 x r2 - v1 - w1 x r1)";
  static const std::vector<Case> all = {
      {"half a product rule", {"C = u . d", "dC = (w1 x u) . d"}},
      {"half a product rule", {"in space", "C = (d . n) (d . t)/L", "dC = (d . n)' (d . t)/L"}},
      {"product of the rates", {"C = (u . d)/L (d . n)", "dC = (u . d)'/L (d . n)'"}},
      {"2 of a square", {rod, "dC = 1/2 d . (v2 + w2 x r2 - v1 - w1 x r1)"}},
      {"ω × r forgotten", {rod, "dC = d . (v2 - v1)"}},
      {"ω × r forgotten", {"in space", rod, "dC = d . (v2 + w2 x r2 - v1)"}},
      {"r × ω", {rod, "dC = d . (v2 + r2 x w2 - v1 - r1 x w1)"}},
      {"r × ω", {"in space", "C = |d| - L", "dC = d . (v2 + r2 x w2 - v1 - w1 x r1)/|d|"}},
      {"arm of the other body", {rod, "dC = d . (v2 + w2 x r1 - v1 - w1 x r1)"}},
      {"spin of the other body", {rod, "dC = d . (v2 + w1 x r2 - v1 - w1 x r1)"}},
      {"ω × the whole position", {rod, "dC = d . (v2 + w2 x p2 - v1 - w1 x r1)"}},
      {"v forgotten", {rod, "dC = d . (w2 x r2 - v1 - w1 x r1)"}},
      {"sign of a body", {rod, "dC = d . (v2 + w2 x r2 + v1 + w1 x r1)"}},
      {"sign of a turn", {rod, "dC = d . (v2 + w2 x r2 - v1 + w1 x r1)"}},
      {"frame held", {"C = u . d", "dC = u . (v2 + w2 x r2 - v1 - w1 x r1)"}},
      {"frame the wrong way", {"C = u . d", "dC = u . d' + (u x w1) . d"}},
      {"frame of the other body", {"in space", "C = u . d", "dC = u . d' + (w2 x u) . d"}},
      {"world turned", {"C = n . d", "dC = n . d' + (w1 x n) . d"}},
      {"length of the rate", {"C = |d| - L", "dC = |v2 + w2 x r2 - v1 - w1 x r1|"}},
      {"length not divided", {"C = |d| - L", "dC = d . (v2 + w2 x r2 - v1 - w1 x r1)"}},
      {"length counted twice", {"C = |d| - L", "dC = 2 d . (v2 + w2 x r2 - v1 - w1 x r1)/|d|"}},
      {"divisor held", {"C = (d . n)/|d|", "dC = (v2 + w2 x r2 - v1 - w1 x r1) . n/|d|"}},
      {"numerator held", {"C = (d . n)/(d . t)", "dC = -(d . n) (d . t)'/(d . t)^2"}},
      {"sign of a quotient", {"C = (d . n)/|d|", "dC = (d . n)'/|d| + (d . n) (d . d')/|d|^3"}},
      {"half of a root", {"C = sqrt(d . d + L^2)", "dC = (d . d)'/sqrt(d . d + L^2)"}},
      {"sign of a sine", {"C = sin(θ2 - θ1)", "dC = -cos(θ2 - θ1) (w2 - w1)"}},
      {"sign of a cosine", {"C = cos(θ2 - θ1)", "dC = sin(θ2 - θ1) (w2 - w1)"}},
      {"sine kept", {"C = sin(θ2 - θ1)", "dC = sin(θ2 - θ1) (w2 - w1)"}},
      {"sign of an angle's rate",
       {"C = atan2(d . t, d . n)", "dC = ((d . t) (d . n)' - (d . n) (d . t)')/((d . n)^2 + (d . t)^2)"}},
      {"angle's rate not divided", {"C = atan2(d . t, d . n)", "dC = (d . n) (d . t)' - (d . t) (d . n)'"}},
      {"exponent lost", {"C = (d . n)^3", "dC = (d . n)^2 (d . n)'"}},
      {"order of a triple product", {rod, rate, "= d . v2 + w2 . (d x r2) - d . v1 - w1 . (r1 x d)"}},
      {"order of a triple product", {"in space", rod, rate, "= d . v2 + w2 . (d x r2) - d . v1 - w1 . (d x r1)"}},
      {"order of a triple product",
       {"in space", "C = d . n", "dC = n . v2 + w2 . (n x r2) - n . v1 - w1 . (r1 x n)"}},
      {"triple product exchanged", {"in space", rod, rate, "= d . v2 + r2 . (w2 x d) - d . v1 - d . (w1 x r1)"}},
      {"cross product commuted", {rod, rate, "= d . v2 + d . (r2 x w2) - d . v1 - d . (w1 x r1)"}},
      {"sign of the whole", {rod, "dC = d . (v1 + w1 x r1 - v2 - w2 x r2)"}},
      {"factor", {rod, "dC = 2 d . (v2 + w2 x r2 - v1 - w1 x r1)"}},
      {"divided by a length", {rod, "dC = d . (v2 + w2 x r2 - v1 - w1 x r1)/|d|"}},
      {"multiplied by a length", {"C = n . d", "dC = |d| n . d'"}},
      {"branch of an angle", {"C = atan2(sin(θ2 - θ1), cos(θ2 - θ1))", "= θ2 - θ1"}},
      {"sign of a term", {rod, rate, "= d . v2 + d . (w2 x r2) + d . v1 - d . (w1 x r1)"}},
      {"turning lost", {rod, rate, "= d . (v2 - v1)"}},
      {"terms of a body lost", {rod, rate, "= d . (v2 + w2 x r2)"}},
      {"sign of the turns", {rod, rate, "= d . (v2 - w2 x r2 - v1 + w1 x r1)"}},
      {"term lost", {rod, rate, "= d . v2 + d . (w2 x r2) - d . (w1 x r1)"}},
      {"term twice", {rod, rate, "= 2 d . v2 + d . (w2 x r2) - d . v1 - d . (w1 x r1)"}},
      {"half a term", {rod, rate, "= 1/2 d . v2 + d . (w2 x r2) - d . v1 - d . (w1 x r1)"}},
      {"square of a sum", {"C = |p2 - p1|^2 - L^2", "= |p2|^2 - |p1|^2 - L^2"}},
      {"square of a sum", {"C = |p2 - p1|^2 - L^2", "= |p2|^2 + |p1|^2 - L^2"}},
      {"length of a sum", {"C = |p2 - p1| - L", "= |p2| - |p1| - L"}},
      {"cross product regrouped", {"in space", "C = n . (t x (d x r1))", "= n . ((t x d) x r1)"}},
      {"transposed product", {"in space", "C = n . ((R1 R2)^T d)", "= n . (R1^T R2^T d)"}},
      {"turned back", {"C = n . (R1^T d)", "= n . (R1 d)"}},
      {"not normalised", {"q, s: constants", "C = q (d/|d|) . n - s", "= q d . n - s"}},
      {"one body twice", {rod, rate, "= d . (v2 + w2 x r1 - v1 - w1 x r1)"}},
      {"another symbol", {"C = d . n + L", "= d . t + L"}},
      {"only where C = 0", {"C = |d|^2/2 - L^2/2", "dC = d . d'", "= d . d' + (|d|^2 - L^2) (n . v2)/L"}},
      {"spin times the arm", {rod, rate, "= d . (v2 + w2 r2 - v1 - w1 x r1)"}},
      {"bodies swapped", {rod, rate, "J = [d, r2 x d, -d, -(r1 x d)]"}},
      {"parts in another order", {"in space", rod, rate, "J = [-d, d, -(r1 x d), r2 x d]"}},
      {"sign of J", {rod, rate, "J = [d, r1 x d, -d, -(r2 x d)]"}},
      {"J of another scale", {"C = |d|^2 - L^2", "J = [-d, -(r1 x d), d, r2 x d]"}},
      {"J of the length", {rod, "J = [-d/|d|, -(r1 x d)/|d|, d/|d|, r2 x d/|d|]"}},
      {"J of the square", {"C = |d| - L", "J = [-d, -(r1 x d), d, r2 x d]"}},
      {"equal ends", {rod, rate, "J = [d, -(r1 x d), d, r2 x d]"}},
      {"sign of a part", {rod, rate, "J = [-d, -(r1 x d), d, -(r2 x d)]"}},
      {"signs of the turns", {rod, rate, "J = [-d, -(d x r1), d, d x r2]"}},
      {"signs of a rod", {"C = |p1| + k |p2| - L", "J = [-p1/|p1|, -(r1 x p1)/|p1|, k p2/|p2|, k r2 x p2/|p2|]"}},
      {"no turning", {rod, rate, "J = [-d, 0, d, 0]"}},
      {"part forgotten", {"C = u . d", "J = [-u, 0, u, r2 x u]"}},
      {"arm copied", {rod, rate, "J = [-d, -(r1 x d), d, r1 x d]"}},
      {"lever from the anchor", {"in space", "C = u . d", "J = [-u, -(r1 x u), u, r2 x u]"}},
      {"part in the body's frame", {"in space", rod, rate, "J = [-d, -(r1 x d), d, R2^T (r2 x d)]"}},
      {"ratio left out", {"C = |p1| + k |p2| - L", "J = [p1/|p1|, r1 x p1/|p1|, p2/|p2|, r2 x p2/|p2|]"}},
      {"kinds and units", {rod, "dC = d . (v2 + w2 x r2 - L)"}},
      {"kinds and units", {"C = d . n + L^2"}},
  };
  return all;
}

/// The name that the last line gets; all before it have to be right.
std::string name_of(const std::vector<std::string>& lines, std::string* said = nullptr) {
  Sheet sheet;
  std::string name = "(right)";
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const Check& check : sheet.add(lines[i])) {
      const bool bad = check.outcome == Check::Outcome::wrong || check.outcome == Check::Outcome::unreadable;
      if (i + 1 < lines.size()) {
        EXPECT_FALSE(bad) << lines[i] << ": " << check.sentence;
      } else if (bad) {
        name = check.finding.name.empty() ? "(none)" : check.finding.name;
        if (said) *said = check.sentence;
        EXPECT_FALSE(check.finding.hints[0].empty()) << lines[i];
      }
    }
  return name;
}

TEST(DeskErrors, AreNamed) {
  std::set<std::string> names;
  for (const Case& one : cases()) {
    std::string said;
    EXPECT_EQ(name_of(one.lines, &said), one.name) << one.lines.back() << "\n" << said;
    names.insert(one.name);
  }
  EXPECT_GE(names.size(), 25u);
}

TEST(DeskErrors, AreNamedUnderRenaming) {
  for (const Case& one : cases()) {
    std::vector<std::string> lines = one.lines;
    for (std::string& line : lines) {
      line = std::regex_replace(line, std::regex("\\bn\\b"), "b1");
      line = std::regex_replace(line, std::regex("\\bd\\b"), "e");
    }
    const bool world = lines[0].starts_with("in ");
    lines.insert(lines.begin() + (world ? 1 : 0), {"b1: unit vector in the world", "e = p2 - p1"});
    EXPECT_EQ(name_of(lines), one.name) << lines.back();
  }
}

TEST(DeskErrors, AreNamedUnderScaling) {
  for (const Case& one : cases()) {
    const bool rows = one.lines.back()[0] == 'J';
    if (rows || std::string(one.name) == "branch of an angle" || std::string(one.name) == "kinds and units")
      continue;
    std::vector<std::string> lines = one.lines;
    for (std::string& line : lines)
      if (const auto equals = line.find('='); equals != std::string::npos)
        line = line.substr(0, equals + 1) + " 3 (" + line.substr(equals + 1) + ")";
    EXPECT_EQ(name_of(lines), one.name) << lines.back();
  }
}

TEST(DeskErrors, AreNamedInReorderedLatex) {
  for (const Case& one : cases()) {
    std::vector<std::string> lines = one.lines;
    Sheet sheet;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) sheet.add(lines[i]);
    const Vocabulary& words = sheet.words();
    const auto equals = lines.back().find('=');
    if (lines.back()[0] == 'J' || std::string(one.name) == "kinds and units") continue;
    // Sums the other way round, printed as LaTeX.
    const std::function<Expression(const Expression&)> turned = [&](const Expression& e) -> Expression {
      if (e->of.empty()) return e;
      std::vector<Expression> of;
      for (const Expression& part : e->of) of.push_back(turned(part));
      if (e->op == Op::add) return make(Op::add, {of[1], of[0]});
      if (e->op == Op::subtract) return make(Op::add, {make(Op::negate, {of[1]}), of[0]});
      if (e->op == Op::dot) return make(Op::dot, {of[1], of[0]});
      return with(e, std::move(of));
    };
    lines.back() = lines.back().substr(0, equals + 1) +
                   latex(turned(parse_expression(lines.back().substr(equals + 1), words)));
    EXPECT_EQ(name_of(lines), one.name) << lines.back();
  }
}

TEST(DeskErrors, EveryNameHasItsCaseAndItsWords) {
  std::set<std::string> tried, all;
  for (const Case& one : cases()) tried.insert(one.name);
  for (const Error& error : errors()) {
    EXPECT_TRUE(all.insert(error.name).second) << error.name;
    EXPECT_TRUE(tried.count(error.name)) << error.name;
    EXPECT_TRUE(std::string(error.sentence).ends_with('.') || std::string(error.sentence).ends_with('?'))
        << error.name;
    EXPECT_TRUE(std::string(error.question).ends_with('?')) << error.name;
  }
}

/// The wrong derivations of exercises 1, 2 and 11 (lessons/practise/*/mutants), written as formulas.
TEST(DeskErrors, MutantsOfTheExercisesGetTheirSentence) {
  const std::string rod = "C = |d|^2/2 - L^2/2", pulley = "C = |d1| + k |d2| - L";
  struct Mutant {
    const char *file, *name;
    std::vector<std::string> lines;
  };
  const std::vector<std::string> hung = {"a1, a2: points of the world", "d1 = p1 - a1", "d2 = p2 - a2", pulley};
  const auto pulled = [&](const char* J) {
    auto lines = hung;
    lines.emplace_back(J);
    return lines;
  };
  const std::vector<Mutant> mutants = {
      {"01 equal_ends", "equal ends", {"particles in the plane", rod, "J = [d, d]"}},
      {"01 no_half", "J of another scale", {"particles in the plane", "C = d . d - L^2", "J = [-d, d]"}},
      {"01 signs_swapped", "sign of J", {"particles in the plane", rod, "J = [d, -d]"}},
      {"01 stretch", "J of the square", {"particles in the plane", "C = |d| - L", "J = [-d, d]"}},
      {"02 d_cross_r", "signs of the turns", {rod, "J = [-d, -(d x r1), d, d x r2]"}},
      {"02 minus_kept", "sign of a part", {rod, "J = [-d, -(r1 x d), d, -(r2 x d)]"}},
      {"02 no_turning", "no turning", {rod, "J = [-d, 0, d, 0]"}},
      {"02 one_sign", "sign of a part", {rod, "J = [-d, r1 x d, d, r2 x d]"}},
      {"02 r1_twice", "arm copied", {rod, "J = [-d, -(r1 x d), d, r1 x d]"}},
      {"11 no_ratio", "ratio left out", pulled("J = [d1/|d1|, r1 x d1/|d1|, d2/|d2|, r2 x d2/|d2|]")},
      {"11 no_turning", "no turning", pulled("J = [d1/|d1|, 0, k d2/|d2|, 0]")},
      {"11 not_normalised", "J of the square", pulled("J = [d1, r1 x d1, k d2, k r2 x d2]")},
      {"11 rod_signs", "signs of a rod", pulled("J = [-d1/|d1|, -(r1 x d1)/|d1|, k d2/|d2|, k r2 x d2/|d2|]")},
  };
  for (const Mutant& mutant : mutants) {
    std::string said;
    EXPECT_EQ(name_of(mutant.lines, &said), mutant.name) << mutant.file << ": " << said;
    EXPECT_FALSE(said.empty());
  }
}

TEST(DeskErrors, WithoutANameTheDifferingTermIsSaid) {
  Sheet sheet;
  sheet.add("C = |d|^2/2 - L^2/2");
  const auto checks = sheet.add("dC = d . (v2 + w2 x r2 - v1 - w1 x r1) + 7 L n . v2");
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].outcome, Check::Outcome::wrong);
  EXPECT_NE(checks[0].sentence.find("7 L n · v2"), std::string::npos) << checks[0].sentence;
  EXPECT_NE(checks[0].numbers.find("yours is"), std::string::npos);
}

}  // namespace
}  // namespace byhand::desk
