#include "lessons/desk/parse.hpp"

#include <cmath>
#include <cstdlib>
#include <map>

#include "lessons/desk/derivative.hpp"
#include "lessons/desk/lexer.hpp"

namespace byhand::desk {
namespace {

constexpr std::size_t longest = 4000;
constexpr int deepest = 100;

class Parser {
 public:
  Parser(std::string_view line, const Vocabulary& words, std::vector<Token> read)
      : line_(line), words_(words), tokens_(std::move(read)) {}

  const Token& now() const { return tokens_[at_]; }
  const Token& ahead(std::size_t by) const { return tokens_[std::min(at_ + by, tokens_.size() - 1)]; }
  bool is(const char* sign) const { return now().is == Token::Is::sign && now().text == sign; }
  bool ended() const { return now().is == Token::Is::end; }
  bool take(const char* sign) {
    if (!is(sign)) return false;
    ++at_;
    return true;
  }
  Span since(int begin) const { return {begin, at_ == 0 ? begin : tokens_[at_ - 1].where.end}; }
  [[noreturn]] void refuse(const std::string& sentence) const { throw Complaint(now().where, sentence); }
  std::string said() const {
    return ended() ? "the end of the line"
                   : "\"" +
                         std::string(line_.substr(static_cast<std::size_t>(now().where.begin),
                                                  static_cast<std::size_t>(now().where.end - now().where.begin))) +
                         "\"";
  }

  Side side() {
    Side result;
    result.where.begin = now().where.begin;
    if (is("[")) {
      ++at_;
      result.row = true;
      do {
        while (take(",")) {
        }
        result.parts.push_back(sum());
      } while (is(","));
      if (!take("]")) refuse("Here " + said() + " stands where a comma or ] is expected.");
      if (is("^")) {
        ++at_;
        if (!take("T") && !(now().is == Token::Is::name && now().text == "T" && ++at_))
          refuse("Behind ] only T may stand.");
      }
    } else {
      result.parts.push_back(sum());
    }
    result.where.end = since(result.where.begin).end;
    return result;
  }

 private:
  struct Deeper {
    explicit Deeper(Parser& p) : parser(p) {
      if (++parser.depth_ > deepest)
        parser.refuse("This is nested more than " + std::to_string(deepest) + " deep.");
    }
    ~Deeper() { --parser.depth_; }
    Parser& parser;
  };

  Expression sum() {
    const Deeper deeper(*this);
    const int begin = now().where.begin;
    Expression left = term();
    while (is("+") || is("-")) {
      const Op op = is("+") ? Op::add : Op::subtract;
      ++at_;
      const Expression right = term();
      left = make(op, {left, right}, since(begin));
    }
    return left;
  }

  Expression signed_term() {
    const Deeper deeper(*this);
    const int begin = now().where.begin;
    if (take("+")) return term();
    ++at_;
    Expression of = term();
    return make(Op::negate, {of}, since(begin));
  }

  Expression term() {
    if (is("-") || is("+")) return signed_term();
    const int begin = now().where.begin;
    Expression left = crossing();
    while (true) {
      if (is("*")) {
        ++at_;
        const Expression right = factor();
        left = make(Op::multiply, {left, right}, since(begin));
      } else if (is("/")) {
        ++at_;
        const Expression right = factor();
        left = make(Op::divide, {left, right}, since(begin));
      } else if (is(".")) {
        ++at_;
        const Expression right = factor();
        const bool vectors = !left->shape.scalar() && !right->shape.scalar();
        left = make(vectors ? Op::dot : Op::multiply, {left, right}, since(begin));
      } else if (begins_operand()) {
        const Expression right = crossing();
        left = make(Op::multiply, {left, right}, since(begin));
      } else {
        return left;
      }
    }
  }

  /// Behind · * /: a sign may stand before it.
  Expression factor() {
    const Deeper deeper(*this);
    const int begin = now().where.begin;
    if (take("-")) {
      Expression of = factor();
      return make(Op::negate, {of}, since(begin));
    }
    return crossing();
  }

  Expression crossing() {
    const int begin = now().where.begin;
    Expression left = postfix();
    if (!take("x")) return left;
    const bool negated = take("-");
    Expression right = postfix();
    if (negated) right = make(Op::negate, {right}, right->where);
    if (is("x")) refuse("a × b × c depends on which product comes first: write brackets.");
    return make(Op::cross, {left, right}, since(begin));
  }

  bool begins_operand() const {
    if (now().is == Token::Is::name || now().is == Token::Is::number) return true;
    if (is("(") || is("{") || is("frac") || is("sqrt") || is("hat") || is("dot")) return true;
    return is("|") && bars_ == 0;
  }

  Expression postfix() {
    const int begin = now().where.begin;
    Expression base = primary();
    while (true) {
      if (take("^")) {
        base = raised(base, begin);
      } else if (take("'")) {
        base = rate_of(base, since(begin));
      } else {
        return base;
      }
    }
  }

  Expression raised(const Expression& base, int begin) {
    int braces = 0;
    while (take("{")) ++braces;
    const bool braced = braces > 0;
    Expression result;
    if (take("T") || (now().is == Token::Is::name && now().text == "T" && ++at_)) {
      result = make(Op::transpose, {base}, since(begin));
    } else {
      const bool open = !braced && take("("), negative = take("-");
      if (now().is != Token::Is::number) refuse("Behind ^ stands a whole number or T, and not " + said() + ".");
      const double exponent = std::strtod(now().text.c_str(), nullptr);
      const Span where = now().where;
      if (exponent == 0.5 && !negative) {
        ++at_;
        result = make(Op::root, {base}, since(begin));
      } else {
        if (exponent != std::floor(exponent) || exponent > 12)
          throw Complaint(where, "The exponent is a whole number up to 12.");
        ++at_;
        result = power(base, static_cast<int>(negative ? -exponent : exponent), since(begin));
      }
      if (open && !take(")")) refuse("The bracket of the exponent is not closed.");
    }
    while (braces-- > 0)
      if (!take("}")) refuse("The brace of the exponent is not closed.");
    return result;
  }

  Expression rate_of(const Expression& of, Span where) {
    if (of->moving)
      throw Complaint(where, "Accelerations do not belong here: the derivative is taken of positions alone.");
    const Expression by_rule = derivative(of, words_);
    return rate(of, by_rule, where);
  }

  Expression closed(Expression inside, const char* by, Span open) {
    if (take(by)) return inside;
    if (ended())
      throw Complaint(open, std::string("This ") +
                                (by[0] == '|'   ? "bar"
                                 : by[0] == '}' ? "brace"
                                                : "bracket") +
                                " is not closed.");
    refuse("Here " + said() + " stands where " + by + " is expected.");
  }

  Expression in_bars(Span open) {
    ++bars_;
    Expression inside = sum();
    inside = closed(inside, "|", open);
    --bars_;
    return make(Op::length, {inside}, since(open.begin));
  }

  Expression bracketed(const char* by) {
    const Span open = now().where;
    ++at_;
    const int outer = bars_;
    bars_ = 0;
    Expression inside = closed(sum(), by, open);
    bars_ = outer;
    return inside;
  }

  /// What stands in { } or is a single token, behind \frac, \sqrt, \dot.
  Expression argument() {
    if (is("{")) return bracketed("}");
    if (now().is == Token::Is::number && now().text.size() > 1 && now().text.find('.') == std::string::npos) {
      // \frac12: a digit each.
      Token& token = tokens_[at_];
      const std::string first = token.text.substr(0, 1);
      token.text.erase(0, 1);
      return number(first[0] - '0');
    }
    return primary();
  }

  Expression primary() {
    const Deeper deeper(*this);
    const Token token = now();
    const Span where = token.where;
    if (token.is == Token::Is::number) {
      ++at_;
      return literal(token);
    }
    if (is("(")) return bracketed(")");
    if (is("{")) return bracketed("}");
    if (take("|")) return in_bars(where);
    if (take("frac")) {
      const Expression above = argument();
      const Expression below = argument();
      return make(Op::divide, {above, below}, since(where.begin));
    }
    if (take("sqrt")) {
      const Expression of = argument();
      return make(Op::root, {of}, since(where.begin));
    }
    if (take("hat")) return argument();
    if (take("dot")) {
      const Expression of = argument();
      return rate_of(of, since(where.begin));
    }
    if (token.is == Token::Is::name) return name();
    if (is("[")) refuse("[ ] holds the parts of J and stands alone behind its =.");
    refuse(ended() ? "The line ends where a quantity is expected."
                   : "Here " + said() + " stands where a quantity is expected.");
  }

  Expression literal(const Token& token) {
    const double value = std::strtod(token.text.c_str(), nullptr);
    if (!std::isfinite(value)) throw Complaint(token.where, "This number is too large.");
    // Exactly, where numerator and denominator are small.
    std::int64_t numerator = 0, divisor = 1;
    const auto point = token.text.find('.');
    if (token.text.size() > 16) return number(value, 0, 0, token.where);
    for (std::size_t i = 0; i < token.text.size(); ++i) {
      if (i == point) continue;
      numerator = 10 * numerator + (token.text[i] - '0');
      if (point != std::string::npos && i > point) divisor *= 10;
    }
    return number(value, numerator, divisor, token.where);
  }

  Expression name() {
    const Token token = now();
    const Span where = token.where;
    ++at_;
    const std::string& text = token.text;
    const auto argument_of = [&](const char* function) {
      if (!is("(") && !is("{")) refuse(std::string("Behind ") + function + " stands its argument in brackets.");
      return bracketed(is("(") ? ")" : "}");
    };
    static const std::map<std::string, Op> functions = {
        {"sin", Op::sine},    {"cos", Op::cosine}, {"sqrt", Op::root}, {"abs", Op::length},
        {"norm", Op::length}, {"perp", Op::perp},  {"skew", Op::skew}};
    if (const auto it = functions.find(text); it != functions.end()) {
      const bool bare = (text == "sin" || text == "cos") && !is("(") && !is("{");
      const Expression of = bare ? postfix() : argument_of(text.c_str());
      return make(it->second, {of}, since(where.begin));
    }
    if (text == "T" && is("(")) {
      const Expression of = argument_of("T");
      return make(Op::transpose, {of}, since(where.begin));
    }
    if (text == "unit") {
      const Expression of = argument_of("unit");
      return make(Op::divide, {of, make(Op::length, {of})}, since(where.begin));
    }
    if (text == "atan2") {
      const Span open = now().where;
      if (!take("(")) refuse("Behind atan2 stand its two arguments in brackets.");
      const Expression y = sum();
      if (!take(",")) refuse("atan2 takes two arguments, y and x, with a comma between them.");
      const Expression x = sum();
      closed(x, ")", open);
      return make(Op::arctangent, {y, x}, since(where.begin));
    }
    if (text == "E") return identity(words_.world().dimension);
    if (const Symbol* known = words_.find(text)) return symbol(*known, where);
    throw Complaint(where, words_.unknown(text));
  }

  std::string_view line_;
  const Vocabulary& words_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0, bars_ = 0;

 public:
  std::size_t position() const { return at_; }
  void go_to(std::size_t token) { at_ = token; }
};

bool is_sign(const Token& token, const char* text) { return token.is == Token::Is::sign && token.text == text; }

/// "C", "dC", "J" and their digits; "" if the tokens before "=" are none of them.
std::string head_of(const std::vector<Token>& read, std::size_t end) {
  std::string all;
  for (std::size_t i = 0; i < end; ++i)
    if (!is_sign(read[i], "{") && !is_sign(read[i], "}") && !is_sign(read[i], "(") && !is_sign(read[i], ")"))
      all += read[i].text;
  std::string digits;
  const auto cut = [&](std::string_view before, std::string_view behind) -> bool {
    if (!all.starts_with(before) || !all.ends_with(behind) || all.size() < before.size() + behind.size())
      return false;
    digits = all.substr(before.size(), all.size() - before.size() - behind.size());
    return digits.empty() || (digits.size() <= 2 && digits.find_first_not_of("0123456789") == std::string::npos);
  };
  if (cut("C", "")) return "C" + digits;
  if (cut("dC", "") || cut("dC", "/dt") || cut("C", "'") || cut("dotC", "") || cut("d/dtC", "") ||
      cut("fracdCdt", ""))
    return "dC" + digits;
  if (cut("J", "")) return "J" + digits;
  if (end == 1 && read[0].is == Token::Is::name) return read[0].text;
  return "";
}

}  // namespace

Line parse(std::string_view line, const Vocabulary& words) {
  if (line.size() > longest)
    throw Complaint({0, static_cast<int>(line.size())},
                    "A line has at most " + std::to_string(longest) + " characters.");
  std::vector<Token> read = tokens(line);
  Line result;
  std::size_t equals = 0;
  while (equals < read.size() && !is_sign(read[equals], "=")) ++equals;
  if (equals == read.size())
    throw Complaint(
        {0, static_cast<int>(line.size())},
        "There is no = in this line. It says C = …, dC = …, = …, J = [ … ], name = … or name: what it is.");
  result.head_where = {read.front().where.begin,
                       equals == 0 ? read.front().where.begin : read[equals - 1].where.end};
  if (equals > 0) {
    result.head = head_of(read, equals);
    if (result.head.empty())
      throw Complaint(result.head_where, "Before the first = stands C, dC, J, a name, or nothing.");
  }
  Parser parser(line, words, std::move(read));
  parser.go_to(equals);
  while (parser.take("=")) result.sides.push_back(parser.side());
  if (parser.take(">=")) {
    result.inequality = true;
    const Expression bound = parser.side().parts.front();
    if (!is_number(bound, 0))
      throw Complaint(bound->where, "An inequality is written C = … ≥ 0: move everything to its left side.");
  }
  if (!parser.ended()) parser.refuse("Here " + parser.said() + " has no place.");
  return result;
}

Expression parse_expression(std::string_view text, const Vocabulary& words) {
  if (text.size() > longest)
    throw Complaint({0, static_cast<int>(text.size())},
                    "A line has at most " + std::to_string(longest) + " characters.");
  Parser parser(text, words, tokens(text));
  const Side side = parser.side();
  if (!parser.ended()) parser.refuse("Here " + parser.said() + " has no place.");
  return side.parts.front();
}

}  // namespace byhand::desk
