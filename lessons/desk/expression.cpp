#include "lessons/desk/expression.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/desk/print.hpp"
#include "lessons/desk/vocabulary.hpp"

namespace byhand::desk {
namespace {

constexpr int largest = 4000, deepest = 200;

std::string raised(double power) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (power != std::floor(power)) return "^(" + std::to_string(static_cast<int>(std::lround(2 * power))) + "/2)";
  std::string text;
  for (const char digit : std::to_string(static_cast<int>(power)))
    text += digit == '-' ? "⁻" : digits[digit - '0'];
  return text;
}

std::string factor(const char* name, double power) { return name + (power == 1 ? "" : raised(power)); }

const char* kind_of(const Expression& e) {
  return e->shape.scalar() ? "a number" : e->shape.vector() ? "a vector" : "a matrix";
}

std::string named(const Expression& e) { return characters(e) + " is " + kind_of(e); }

[[noreturn]] void refuse(Span where, const std::string& sentence) { throw Misfit(where, sentence); }

/// Units and shapes of a sum's operands have to be alike.
Unit unit_of_sum(Op op, const Expression& a, const Expression& b, Span where) {
  const char* doing = op == Op::add ? "added to" : "subtracted from";
  const Expression &what = b, &from = a;
  if (!(a->shape == b->shape))
    refuse(where, named(what) + " and is " + doing + " " + characters(from) + ", which is " + kind_of(from) + ".");
  if (!a->unit.fits(b->unit))
    refuse(where, characters(what) + " is " + described(what->unit) + "; it is " + doing + " " + characters(from) +
                      ", which is " + described(from->unit) + ".");
  return a->unit.known ? a->unit : b->unit;
}

void require_scalar(const Expression& e, const char* of, Span where) {
  if (!e->shape.scalar()) refuse(where, std::string(of) + " takes a number, and " + named(e) + ".");
}
void require_pure(const Expression& e, const char* of, Span where) {
  require_scalar(e, of, where);
  if (!e->unit.fits(unitless))
    refuse(where, std::string(of) + " takes a number without a unit, and " + characters(e) + " is " +
                      described(e->unit) + ".");
}

void find_type(Node& node) {
  const auto& of = node.of;
  const Span where = node.where;
  const auto a = [&]() -> const Expression& { return of[0]; };
  const auto b = [&]() -> const Expression& { return of[1]; };
  switch (node.op) {
    case Op::number:
    case Op::symbol: break;
    case Op::negate:
      node.shape = a()->shape;
      node.unit = a()->unit;
      break;
    case Op::add:
    case Op::subtract:
      node.unit = unit_of_sum(node.op, a(), b(), where);
      node.shape = a()->shape;
      break;
    case Op::multiply:
      node.unit = a()->unit * b()->unit;
      if (a()->shape.scalar()) {
        node.shape = b()->shape;
      } else if (b()->shape.scalar()) {
        node.shape = a()->shape;
      } else if (a()->shape.vector() && b()->shape.vector()) {
        refuse(where, "Between the vectors " + characters(a()) + " and " + characters(b()) +
                          " write · or ×: their product is one or the other.");
      } else if (a()->shape.cols != b()->shape.rows) {
        refuse(where, characters(a()) + " has " + std::to_string(a()->shape.cols) + " columns and " +
                          characters(b()) + " " + std::to_string(b()->shape.rows) +
                          " rows: they cannot be multiplied.");
      } else {
        node.shape = {a()->shape.rows, b()->shape.cols};
      }
      break;
    case Op::divide:
      if (!b()->shape.scalar())
        refuse(where, "Nothing can be divided by " + characters(b()) + ", which is " + kind_of(b()) +
                          ": divide by its length.");
      node.shape = a()->shape;
      node.unit = a()->unit / b()->unit;
      break;
    case Op::dot:
      if (!a()->shape.vector() || !b()->shape.vector() || !(a()->shape == b()->shape)) {
        const Expression& bad = a()->shape.vector() ? b() : a();
        refuse(where, "The dot product takes two vectors, and " + named(bad) + ".");
      }
      node.unit = a()->unit * b()->unit;
      break;
    case Op::cross: {
      node.unit = a()->unit * b()->unit;
      const bool plane = (a()->shape.vector() ? a() : b())->shape.rows == 2;
      const bool fits =
          a()->shape.vector() && b()->shape.vector()
              ? a()->shape == b()->shape
              : plane && (a()->shape.vector() ? b()->shape.scalar() : a()->shape.scalar() && b()->shape.vector());
      if (!fits) {
        const Expression& bad = a()->shape.vector() ? b() : a();
        refuse(where, "The cross product takes two vectors, in the plane also ω × r, and " + named(bad) + ".");
      }
      if (a()->shape.vector() && b()->shape.vector())
        node.shape = plane ? Shape{} : a()->shape;
      else
        node.shape = a()->shape.vector() ? a()->shape : b()->shape;
      break;
    }
    case Op::length:
      if (a()->shape.rows > 1 && a()->shape.cols > 1)
        refuse(where, "| | takes a vector or a number, and " + named(a()) + ".");
      node.unit = a()->unit;
      node.rational = false;
      break;
    case Op::power:
      require_scalar(a(), "A power", where);
      if (std::fabs(node.number) > 12) refuse(where, "The exponent is larger than 12.");
      node.unit = a()->unit.to(node.number);
      break;
    case Op::root:
      require_scalar(a(), "√", where);
      node.unit = a()->unit.to(0.5);
      node.rational = false;
      break;
    case Op::sine:
    case Op::cosine:
      require_pure(a(), node.op == Op::sine ? "sin" : "cos", where);
      node.rational = false;
      break;
    case Op::arctangent:
      require_scalar(a(), "atan2", where);
      require_scalar(b(), "atan2", where);
      if (!a()->unit.fits(b()->unit))
        refuse(where, "atan2 takes two numbers of one unit, and " + characters(a()) + " is " +
                          described(a()->unit) + ", " + characters(b()) + " " + described(b()->unit) + ".");
      node.rational = false;
      break;
    case Op::transpose:
      node.shape = {a()->shape.cols, a()->shape.rows};
      node.unit = a()->unit;
      break;
    case Op::perp:
      if (a()->shape.rows != 2)
        refuse(where, "perp turns a vector of the plane by a quarter, and " + named(a()) + ".");
      node.shape = a()->shape;
      node.unit = a()->unit;
      break;
    case Op::skew:
      if (!(a()->shape == Shape{3, 1}))
        refuse(where, "skew takes a vector of space, and " + named(a()) +
                          (a()->shape.vector() ? " of the plane: write perp." : "."));
      node.shape = {3, 3};
      node.unit = a()->unit;
      break;
    case Op::rate:
      node.shape = b()->shape;
      node.unit = a()->unit * per_second;
      break;
  }
}

Expression finished(Node node) {
  for (const Expression& part : node.of) {
    node.size += part->size;
    node.depth = std::max(node.depth, part->depth + 1);
    const bool square =
        node.op == Op::power && part->op == Op::length && std::fmod(node.number, 2) == 0;  // |a|² = a·a
    node.rational = node.rational && (square ? part->of[0]->rational : part->rational);
    node.moving = node.moving || part->moving;
  }
  if (node.depth > deepest)
    throw Complaint(node.where, "This is nested more than " + std::to_string(deepest) + " deep.");
  if (node.size > largest)
    throw Complaint(node.where, "This has more than " + std::to_string(largest) + " parts.");
  return std::make_shared<const Node>(std::move(node));
}

}  // namespace

std::string text_of(const Unit& unit) {
  if (!unit.known) return "unknown";
  if (unit.m == 0 && unit.s == 0) return "1";
  std::string text = unit.m == 0  ? (unit.s < 0 ? "1" : "")
                     : unit.m > 0 ? factor("m", unit.m)
                     : unit.s > 0 ? ""
                                  : "1";
  if (unit.s > 0) text += factor("s", unit.s);
  if (unit.m < 0) text += "/" + factor("m", -unit.m);
  if (unit.s < 0) text += (unit.m < 0 ? " " : "/") + factor("s", -unit.s);
  return text;
}

std::string described(const Unit& unit) {
  if (!unit.known) return "of unknown unit";
  const auto is = [&](double m, double s) { return unit.m == m && unit.s == s; };
  if (is(0, 0)) return "a number without a unit";
  const char* name = is(1, 0)    ? "a length"
                     : is(2, 0)  ? "an area"
                     : is(1, -1) ? "a velocity"
                     : is(0, -1) ? "a rate of turn"
                     : is(1, -2) ? "an acceleration"
                                 : "a quantity";
  return std::string(name) + " [" + text_of(unit) + "]";
}

Expression make(Op op, std::vector<Expression> of, Span where) {
  Node node{op, {}, {}, std::move(of)};
  node.where = where;
  find_type(node);
  return finished(std::move(node));
}

Expression number(double value, std::int64_t numerator, std::int64_t divisor, Span where) {
  Node node{Op::number, {}, {}, {}};
  node.number = value;
  node.numerator = numerator;
  node.divisor = divisor;
  node.rational = divisor != 0;
  if (value == 0) node.unit = any_unit;
  node.where = where;
  return std::make_shared<const Node>(std::move(node));
}
Expression number(int value) { return number(value, value, 1); }

Expression zero(Shape shape, Unit unit) {
  Node node{Op::number, shape, unit, {}};
  node.divisor = 1;
  return std::make_shared<const Node>(std::move(node));
}

Expression identity(int dimension) {
  Node node{Op::number, {dimension, dimension}, unitless, {}};
  node.number = 1;
  node.numerator = node.divisor = 1;
  return std::make_shared<const Node>(std::move(node));
}

Expression symbol(const Symbol& of, Span where) {
  Node node{Op::symbol, of.shape, of.unit, {}};
  node.symbol = &of;
  node.where = where;
  node.moving = of.is == Symbol::Is::velocity || of.is == Symbol::Is::spin;
  node.rational = of.is != Symbol::Is::angle;
  if (of.definition) {
    node.rational = of.definition->rational;
    node.moving = of.definition->moving;
    // As large as what it stands for, so that definitions of definitions stay within bounds too.
    node.size = of.definition->size + 1;
    node.depth = of.definition->depth + 1;
  }
  return std::make_shared<const Node>(std::move(node));
}

Expression power(const Expression& base, int exponent, Span where) {
  if (base->shape.vector() && exponent == 2) return make(Op::dot, {base, base}, where);
  if (!base->shape.scalar()) refuse(where, "Of a vector there is a square, a·a, and no other power.");
  Node node{Op::power, {}, {}, {base}};
  node.number = exponent;
  node.where = where;
  find_type(node);
  return finished(std::move(node));
}

Expression rate(const Expression& typed, const Expression& by_rule, Span where) {
  return make(Op::rate, {typed, by_rule}, where);
}

bool is_number(const Expression& e, double value) { return e->op == Op::number && e->number == value; }

bool same(const Expression& a, const Expression& b) {
  if (a == b) return true;
  if (a->op != b->op || a->of.size() != b->of.size() || a->number != b->number || a->symbol != b->symbol ||
      !(a->shape == b->shape))
    return false;
  for (std::size_t i = 0; i < a->of.size(); ++i)
    if (!same(a->of[i], b->of[i])) return false;
  return true;
}

void visit(const Expression& e, const std::function<void(const Expression&)>& visitor) {
  visitor(e);
  for (const Expression& part : e->of) visit(part, visitor);
}

bool contains(const Expression& e, const std::function<bool(const Node&)>& test) {
  return test(*e) ||
         std::any_of(e->of.begin(), e->of.end(), [&](const Expression& part) { return contains(part, test); }) ||
         (e->symbol && e->symbol->definition && contains(e->symbol->definition, test));
}

Expression with(const Expression& e, std::vector<Expression> of) {
  Node node{e->op, {}, {}, std::move(of)};
  node.number = e->number;
  node.symbol = e->symbol;
  node.where = e->where;
  if (node.of.empty()) return e;
  find_type(node);
  return finished(std::move(node));
}

Expression plus(const Expression& a, const Expression& b) {
  if (is_number(a, 0)) return b;
  if (is_number(b, 0)) return a;
  return b->op == Op::negate ? make(Op::subtract, {a, b->of[0]}) : make(Op::add, {a, b});
}
Expression minus(const Expression& a, const Expression& b) {
  if (is_number(b, 0)) return a;
  if (is_number(a, 0)) return negative(b);
  return b->op == Op::negate ? make(Op::add, {a, b->of[0]}) : make(Op::subtract, {a, b});
}
Expression negative(const Expression& a) {
  if (is_number(a, 0)) return a;
  return a->op == Op::negate ? a->of[0] : make(Op::negate, {a});
}
Expression times(const Expression& a, const Expression& b) {
  const Shape shape = a->shape.scalar()   ? b->shape
                      : b->shape.scalar() ? a->shape
                                          : Shape{a->shape.rows, b->shape.cols};
  if (is_number(a, 0) || is_number(b, 0)) return zero(shape);
  if (is_number(a, 1)) return b;
  if (is_number(b, 1)) return a;
  if (a->op == Op::negate) return negative(times(a->of[0], b));
  if (b->op == Op::negate) return negative(times(a, b->of[0]));
  // Halves meet twos: ½ (2 a) = a.
  if (a->op == Op::number && b->op == Op::multiply && b->of[0]->op == Op::number && a->divisor &&
      b->of[0]->divisor && a->shape.scalar()) {
    const double product = a->number * b->of[0]->number;
    if (product == std::floor(product) && std::fabs(product) < 1e6)
      return times(number(static_cast<int>(product)), b->of[1]);
  }
  return make(Op::multiply, {a, b});
}
Expression dotted(const Expression& a, const Expression& b) {
  if (is_number(a, 0) || is_number(b, 0)) return zero({});
  if (a->op == Op::negate) return negative(dotted(a->of[0], b));
  if (b->op == Op::negate) return negative(dotted(a, b->of[0]));
  return make(Op::dot, {a, b});
}
Expression crossed(const Expression& a, const Expression& b) {
  if (is_number(a, 0) || is_number(b, 0)) {
    const bool vectors = a->shape.vector() && b->shape.vector();
    return zero(vectors && a->shape.rows == 2 ? Shape{} : a->shape.vector() ? a->shape : b->shape);
  }
  if (a->op == Op::negate) return negative(crossed(a->of[0], b));
  if (b->op == Op::negate) return negative(crossed(a, b->of[0]));
  return make(Op::cross, {a, b});
}
Expression divided(const Expression& a, const Expression& b) {
  if (is_number(a, 0)) return a;
  if (is_number(b, 1)) return a;
  if (a->op == Op::negate) return negative(divided(a->of[0], b));
  if (b->op == Op::number && a->op == Op::multiply && a->of[0]->op == Op::number && a->of[0]->shape.scalar() &&
      b->number != 0) {
    const double ratio = a->of[0]->number / b->number;
    if (ratio == std::floor(ratio)) return times(number(static_cast<int>(ratio)), a->of[1]);
  }
  return make(Op::divide, {a, b});
}

namespace {

constexpr std::size_t most_terms = 400;

/// op(x, y) of every term of a with every one of b.
template <class F>
std::vector<Expression> spread(const Expression& a, const Expression& b, F&& op) {
  // Positions before a velocity stay together: they become a part of J.
  const auto terms = [&](const Expression& side, const Expression& other) {
    return side->moving || !other->moving ? addends(side) : std::vector<Expression>{side};
  };
  const auto left = terms(a, b), right = terms(b, a);
  if (left.size() * right.size() > most_terms) return {op(a, b)};
  std::vector<Expression> all;
  for (const Expression& x : left)
    for (const Expression& y : right) all.push_back(op(x, y));
  return all;
}

std::vector<Expression> negated(std::vector<Expression> terms) {
  for (Expression& term : terms) term = negative(term);
  return terms;
}

}  // namespace

std::vector<Expression> addends(const Expression& e) {
  switch (e->op) {
    case Op::negate: return negated(addends(e->of[0]));
    case Op::add:
    case Op::subtract: {
      auto left = addends(e->of[0]), right = addends(e->of[1]);
      if (e->op == Op::subtract) right = negated(std::move(right));
      left.insert(left.end(), right.begin(), right.end());
      return left;
    }
    case Op::multiply: return spread(e->of[0], e->of[1], times);
    case Op::dot: return spread(e->of[0], e->of[1], dotted);
    case Op::cross: return spread(e->of[0], e->of[1], crossed);
    case Op::divide: {
      auto terms = addends(e->of[0]);
      for (Expression& term : terms) term = divided(term, e->of[1]);
      return terms;
    }
    case Op::rate: return addends(e->of[1]);
    default:
      if (is_number(e, 0)) return {};
      return {e};
  }
}

Expression sum(const std::vector<Expression>& terms, const Expression& like) {
  Expression all = zero(like->shape, like->unit);
  for (const Expression& term : terms) all = plus(all, term);
  return all;
}

}  // namespace byhand::desk
