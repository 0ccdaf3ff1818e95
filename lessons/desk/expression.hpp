#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lessons/desk/value.hpp"

namespace byhand::desk {

/// Where a part of a line is, in bytes.
struct Span {
  int begin = 0, end = 0;
};

/// One sentence about a line that cannot be read, and where.
class Complaint : public std::runtime_error {
 public:
  Complaint(Span at, const std::string& sentence) : std::runtime_error(sentence), where(at) {}
  Span where;
};

/// A line that can be read but has no meaning: kinds or units do not fit.
class Misfit : public Complaint {
 public:
  using Complaint::Complaint;
};

/// Powers of metre and second. Of constants that were not given a unit, and of 0, it is not known and fits any.
struct Unit {
  double m = 0, s = 0;
  bool known = true;

  friend Unit operator*(const Unit& a, const Unit& b) { return {a.m + b.m, a.s + b.s, a.known && b.known}; }
  friend Unit operator/(const Unit& a, const Unit& b) { return {a.m - b.m, a.s - b.s, a.known && b.known}; }
  Unit to(double power) const { return {power * m, power * s, known}; }
  bool fits(const Unit& other) const { return !known || !other.known || (m == other.m && s == other.s); }
};
inline constexpr Unit any_unit{0, 0, false}, unitless{}, metre{1, 0}, per_second{0, -1}, metre_per_second{1, -1};

/// "m²/s"; "1" for a number.
std::string text_of(const Unit& unit);
/// "a velocity [m/s]", "a length [m]", "a quantity in m³".
std::string described(const Unit& unit);

enum class Op {
  number,
  symbol,
  negate,
  add,
  subtract,
  multiply,  // of scalars, of a scalar with anything, of matrices with matrices and vectors
  divide,
  dot,
  cross,
  length,  // |a| of a vector or scalar
  power,   // of a scalar to an integer; a² of a vector is a·a
  root,    // of a scalar
  sine,
  cosine,
  arctangent,  // atan2(y, x)
  transpose,
  perp,
  skew,
  rate,  // of[0] as it was typed, of[1] its derivative by rule
};

struct Symbol;
struct Node;
using Expression = std::shared_ptr<const Node>;

struct Node {
  Op op;
  Shape shape = {};
  Unit unit = {};
  std::vector<Expression> of = {};
  double number = 0;  // of Op::number, times the identity for a matrix; exponent of Op::power
  std::int64_t numerator = 0, divisor = 0;  // the number exactly; divisor 0: not known
  const Symbol* symbol = nullptr;           // of Op::symbol; lives as long as the vocabulary
  Span where = {};
  int size = 1, depth = 1;
  bool rational = true;  // built of + − · × ÷ alone
  bool moving = false;   // contains v or ω
};

/// An expression of operands; throws Misfit where kinds or units do not fit, with the sentence that says so.
Expression make(Op op, std::vector<Expression> of, Span where = {});
Expression number(double value, std::int64_t numerator, std::int64_t divisor, Span where = {});
Expression number(int value);
Expression zero(Shape shape, Unit unit = any_unit);
Expression identity(int dimension);
Expression symbol(const Symbol& of, Span where = {});
Expression power(const Expression& base, int exponent, Span where = {});
/// A rate as it was typed and what it is by rule.
Expression rate(const Expression& typed, const Expression& by_rule, Span where);

bool is_number(const Expression& e, double value);
bool same(const Expression& a, const Expression& b);
/// Calls visit on the expression and all its parts; definitions are not entered.
void visit(const Expression& e, const std::function<void(const Expression&)>& visit);
bool contains(const Expression& e, const std::function<bool(const Node&)>& test);
/// The expression with other operands.
Expression with(const Expression& e, std::vector<Expression> of);

// The same without the terms and factors that are nothing: what a reader would write.
Expression plus(const Expression& a, const Expression& b);
Expression minus(const Expression& a, const Expression& b);
Expression negative(const Expression& a);
Expression times(const Expression& a, const Expression& b);
Expression dotted(const Expression& a, const Expression& b);
Expression crossed(const Expression& a, const Expression& b);
Expression divided(const Expression& a, const Expression& b);

/// The terms of a sum once all products are multiplied out.
std::vector<Expression> addends(const Expression& e);
/// Their sum.
Expression sum(const std::vector<Expression>& terms, const Expression& like);

}  // namespace byhand::desk
