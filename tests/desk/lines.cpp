// Random true lines are accepted and spoiled ones refused. What is true is told by central differences of C along
// the motion of the bodies, in plain doubles, and not by the judge.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "lessons/desk/print.hpp"
#include "lessons/desk/sheet.hpp"

namespace byhand::desk {
namespace {

using Is = Symbol::Is;

/// Makes expressions of positions at random, of kinds and units that fit.
class Maker {
 public:
  Maker(const Vocabulary& words, Random& random) : words_(words), random_(random) {}

  /// A scalar of positions.
  Expression constraint() {
    switch (random_.below(6)) {
      case 0:
        return plus(times(number(1, 1, 2), dotted(length(), length())),
                    negative(times(number(1, 1, 2), power(name("L"), 2))));
      case 1: return minus(make(Op::length, {length()}), name("L"));
      case 2: return dotted(direction(), length());
      case 3: return dotted(direction(), direction());
      case 4: return plus(dotted(direction(), length()), times(scalar(), make(Op::length, {length()})));
      default: return crossing();
    }
  }

 private:
  Expression number(int top, std::int64_t, std::int64_t bottom) {
    return desk::number(static_cast<double>(top) / static_cast<double>(bottom), top, bottom);
  }
  Expression name(const char* of) { return symbol(words_.at(of)); }
  Expression length() {
    static const char* const names[] = {"d", "p1", "p2", "r1", "r2", "x1", "x2"};
    const Expression one = name(names[random_.below(7)]);
    if (random_.below(3) == 0) {
      const Expression other = name(names[random_.below(7)]);
      return random_.below(2) ? make(Op::add, {one, other})
                              : make(Op::subtract, {one, times(desk::number(2), other)});
    }
    return one;
  }
  Expression direction() {
    static const char* const names[] = {"n", "t", "u"};
    if (random_.below(4) == 0) return make(Op::multiply, {name("R2"), name("n")});
    if (random_.below(4) == 0) {
      const Expression of = name("d");
      return make(Op::divide, {of, make(Op::length, {of})});
    }
    return name(names[random_.below(3)]);
  }
  Expression scalar() {
    if (random_.below(3) == 0)
      return make(random_.below(2) ? Op::sine : Op::cosine, {dotted(direction(), direction())});
    return name("k");
  }
  Expression crossing() {
    const Expression of = crossed(direction(), length());
    return of->shape.scalar() ? of : dotted(direction(), of);
  }

  const Vocabulary& words_;
  Random& random_;
};

/// Other forms of the same value.
Expression rewritten(const Expression& e, Random& random) {
  std::vector<Expression> of;
  for (const Expression& part : e->of) of.push_back(rewritten(part, random));
  const Expression same_parts = e->of.empty() ? e : with(e, of);
  switch (e->op) {
    case Op::add: return random.below(2) ? make(Op::add, {of[1], of[0]}) : same_parts;
    case Op::subtract:
      return random.below(3) == 0 ? make(Op::negate, {make(Op::subtract, {of[1], of[0]})}) : same_parts;
    case Op::dot:
      if (of[1]->op == Op::cross && of[1]->shape.vector() && of[1]->of[0]->shape.vector() &&
          of[1]->of[1]->shape.vector() && random.below(2))
        return make(Op::dot, {of[1]->of[0], make(Op::cross, {of[1]->of[1], of[0]})});
      return random.below(2) ? make(Op::dot, {of[1], of[0]}) : same_parts;
    case Op::cross: return random.below(2) ? make(Op::negate, {make(Op::cross, {of[1], of[0]})}) : same_parts;
    case Op::multiply:
      return of[0]->shape.scalar() && random.below(4) == 0
                 ? make(Op::divide,
                        {make(Op::multiply, {make(Op::multiply, {number(2), of[0]}), of[1]}), number(2)})
                 : same_parts;
    case Op::symbol:
      return e->symbol->definition && random.below(2) ? rewritten(e->symbol->definition, random) : e;
    default: return same_parts;
  }
}

/// One part of the line is spoiled.
Expression spoiled(const Expression& e, const Vocabulary& words, Random& random) {
  int parts = 0;
  visit(e, [&](const Expression&) { ++parts; });
  int at = random.below(parts);
  const std::function<Expression(const Expression&)> copy = [&](const Expression& one) -> Expression {
    if (at-- == 0) {
      if (one->symbol)
        if (const Symbol* other = counterpart(words, *one->symbol)) return symbol(*other);
      if (one->op == Op::cross) return make(Op::cross, {one->of[1], one->of[0]});
      if (one->op == Op::add) return make(Op::subtract, one->of);
      if (one->op == Op::subtract) return random.below(2) ? make(Op::add, one->of) : one->of[0];
      return random.below(2) ? make(Op::negate, {one}) : make(Op::multiply, {number(2), one});
    }
    if (one->of.empty()) return one;
    std::vector<Expression> of;
    for (const Expression& part : one->of) of.push_back(copy(part));
    return with(one, std::move(of));
  };
  return copy(e);
}

/// The state after a time at constant v and ω.
State<double> moved(const Vocabulary& words, State<double> state, double time) {
  for (const std::string body : {"1", "2"}) {
    const auto of = [&](const char* name) -> Value<double>& {
      return state[static_cast<std::size_t>(words.at(name + body).id)];
    };
    const int n = words.world().dimension;
    for (int i = 0; i < n; ++i) of("x")[i] += time * of("v")[i];
    Value<double>& R = of("R");
    const Value<double> spin = of("ω"), before = R;
    if (n == 2) {
      of("θ")[0] += time * spin[0];
      const double c = std::cos(time * spin[0]), s = std::sin(time * spin[0]);
      for (int j = 0; j < 2; ++j) {
        R(0, j) = c * before(0, j) - s * before(1, j);
        R(1, j) = s * before(0, j) + c * before(1, j);
      }
    } else {
      // Rodrigues.
      const double speed = std::sqrt(inner(spin, spin)), angle = speed * time;
      for (int j = 0; j < 3; ++j) {
        Value<double> a(Shape{3, 1});
        for (int i = 0; i < 3; ++i) a[i] = before(i, j);
        const Value<double> once = cross(spin, a), twice = cross(spin, once);
        for (int i = 0; i < 3; ++i)
          R(i, j) = a[i] + std::sin(angle) / speed * once[i] + (1 - std::cos(angle)) / (speed * speed) * twice[i];
      }
    }
  }
  return state;
}

enum class Truth { yes, no, unclear };

Truth truth(const Vocabulary& words, const Expression& C, const Expression& rate, Random& random) {
  int right = 0, wrong = 0;
  for (int i = 0; i < 8; ++i) {
    const State<double> state = random_state(words, random);
    const double h = 1e-5;
    const auto at = [&](double time) {
      return evaluate(*C, environment<double>(words, moved(words, state, time)))[0];
    };
    const double slope = (at(h) - at(-h)) / (2 * h), typed = evaluate(*rate, environment<double>(words, state))[0];
    const double error = std::fabs(slope - typed) / (1 + std::fabs(slope) + std::fabs(typed));
    if (!(error < 1e300)) continue;
    (error < 1e-7 ? right : wrong) += 1;
    if (error >= 1e-7 && error < 1e-4) return Truth::unclear;
  }
  return wrong == 0 && right >= 4 ? Truth::yes : wrong >= 1 ? Truth::no : Truth::unclear;
}

TEST(Desk, AcceptsAThousandTrueLinesAndRefusesAThousandSpoiledOnes) {
  int accepted = 0, refused = 0, printed = 0;
  for (int dimension : {2, 3}) {
    Random random(static_cast<std::uint64_t>(dimension));
    const Vocabulary words({dimension, true});
    const Judge judge(words);
    Maker maker(words, random);
    for (int i = 0; accepted < 500 * (dimension - 1) || refused < 500 * (dimension - 1); ++i) {
      ASSERT_LT(i, 5000);
      const Expression C = maker.constraint();
      Expression rate;
      rate = derivative(C, words);
      if (is_number(rate, 0)) continue;
      const Expression line = rewritten(rate, random);
      const Samples wanted = judge.rates(C);
      // The line is read back from its characters and from its LaTeX.
      const Expression read = parse_expression(i % 2 ? characters(line) : latex(line), words);
      ASSERT_TRUE(judge.compare(read, line).equal) << characters(line) << "\n" << characters(read);
      ++printed;
      const Truth told = truth(words, C, read, random);
      if (told == Truth::yes && accepted < 500 * (dimension - 1)) {
        EXPECT_TRUE(judge.compare(judge.samples(read), wanted).equal) << characters(C) << "\n" << characters(read);
        ++accepted;
      }
      ASSERT_NE(told, Truth::no) << characters(C) << "\n" << characters(read);
      Expression wrong;
      try {
        wrong = spoiled(line, words, random);
      } catch (const Complaint&) {
        continue;
      }
      if (truth(words, C, wrong, random) != Truth::no || refused >= 500 * (dimension - 1)) continue;
      EXPECT_FALSE(judge.compare(judge.samples(wrong), wanted).equal) << characters(C) << "\n"
                                                                      << characters(wrong);
      ++refused;
      if (refused % 10 == 0) {
        const Finding finding = why_not_the_rate(judge, C, wrong);
        EXPECT_FALSE(finding.sentence.empty());
      }
    }
  }
  EXPECT_EQ(accepted, 1000);
  EXPECT_EQ(refused, 1000);
  EXPECT_GE(printed, 1000);
}

TEST(Desk, DifferentiatesByRuleAsByDualNumbers) {
  for (const World world : {World{2, true}, World{3, true}, World{2, false}, World{3, false}}) {
    const Vocabulary words(world);
    const Judge judge(words);
    std::vector<std::string> formulas = {
        "(d . d - L^2)/2",     "|d| - L",   "d . n/|d|", "sqrt(d . d + L^2)", "sin(d . n/L) cos(k d . t/L)",
        "atan2(d . n, d . t)", "(d . n)^3", "1/|d|",     "|d . n|",           "d"};
    if (world.turning)
      formulas.insert(formulas.end(),
                      {"u . d", "(R1 n) . (R2 t)", "n^T R1^T R2 t", "(R1 u) . d", "(u x d) . (u x d)"});
    if (world.turning && world.dimension == 2)
      formulas.insert(formulas.end(), {"θ2 - k θ1", "perp(r1) . d", "sin(θ1) - cos(2 θ2)"});
    if (world.dimension == 3) formulas.insert(formulas.end(), {"d x n", "n . (d x t)", "skew(d) t"});
    for (const std::string& formula : formulas) {
      const Expression C = parse_expression(formula, words);
      EXPECT_TRUE(judge.compare(judge.samples(derivative(C, words)), judge.rates(C)).equal)
          << formula << ": " << characters(derivative(C, words));
    }
  }
}

TEST(Desk, JudgesRationalLinesExactly) {
  const Vocabulary words({3, true});
  const Judge judge(words);
  const auto verdict = [&](const char* a, const char* b) {
    return judge.compare(parse_expression(a, words), parse_expression(b, words));
  };
  EXPECT_TRUE(verdict("|d|^2", "d . d").exact);
  EXPECT_TRUE(verdict("n . n", "1").equal);
  EXPECT_TRUE(verdict("n . t", "0").equal);
  EXPECT_TRUE(verdict("n x t", "t2").equal);
  EXPECT_TRUE(verdict("R1^T R1 d", "d").equal);
  EXPECT_TRUE(verdict("0.1 d + 0.2 d", "0.3 d").equal);
  EXPECT_FALSE(verdict("d . d", "d . d + L^2/1000000000000").equal);
  EXPECT_FALSE(verdict("d . d", "1.0000000000001 d . d").equal);
  EXPECT_TRUE(verdict("|d|", "sqrt(d . d)").equal);
  EXPECT_FALSE(verdict("|d|", "sqrt(d . d)").exact);
}

}  // namespace
}  // namespace byhand::desk
