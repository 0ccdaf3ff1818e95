#include "lessons/page/typed_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace byhand::course {
namespace {

/// A quantity while it is read. Powers of ten of prefixes are kept apart: 200 µs is 200/10⁶ s without rounding.
struct Term : TypedQuantity {
  int decades = 0;

  void keep_kind(const Term& other) {
    has_number |= other.has_number;
    has_pi |= other.has_pi;
    has_unit |= other.has_unit;
  }
};

struct Unit {
  std::string_view name;
  double value;
  int decades;
  Dimension dimension;
  bool takes_prefix;
};

constexpr double degree = std::numbers::pi / 180;
constexpr std::array<Unit, 13> units = {{{"m", 1, 0, {1, 0, 0}, true},
                                         {"s", 1, 0, {0, 0, 1}, true},
                                         {"g", 1, -3, {0, 1, 0}, true},
                                         {"N", 1, 0, {1, 1, -2}, true},
                                         {"J", 1, 0, {2, 1, -2}, true},
                                         {"W", 1, 0, {2, 1, -3}, true},
                                         {"Pa", 1, 0, {-1, 1, -2}, true},
                                         {"Hz", 1, 0, {0, 0, -1}, true},
                                         {"rad", 1, 0, {}, false},
                                         {"deg", degree, 0, {}, false},
                                         {"degree", degree, 0, {}, false},
                                         {"degrees", degree, 0, {}, false},
                                         {"percent", 1, -2, {}, false}}};
constexpr std::array<std::pair<char, int>, 7> prefixes = {
    {{'n', -9}, {'u', -6}, {'m', -3}, {'c', -2}, {'d', -1}, {'k', 3}, {'M', 6}}};

Term operator*(const Term& a, const Term& b) {
  Term product = a;
  product.value *= b.value;
  product.number *= b.number;
  product.decades += b.decades;
  product.dimension = {a.dimension.metre + b.dimension.metre, a.dimension.kilogram + b.dimension.kilogram,
                       a.dimension.second + b.dimension.second};
  product.keep_kind(b);
  return product;
}

Term power(Term base, int exponent) {
  base.value = std::pow(base.value, exponent);
  base.number = std::pow(base.number, exponent);
  base.decades *= exponent;
  base.dimension = {base.dimension.metre * exponent, base.dimension.kilogram * exponent,
                    base.dimension.second * exponent};
  return base;
}

Term operator/(const Term& a, const Term& b) {
  Term quotient = a * power(b, -1);
  quotient.value = a.value / b.value;  // 1/60, and not 1 · (1/60)
  quotient.number = a.number / b.number;
  return quotient;
}

double ten_to(double value, int decades) {
  return decades < 0 ? value / std::pow(10, -decades) : value * std::pow(10, decades);
}

Term plain_number(double value) {
  Term term;
  term.value = term.number = value;
  term.has_number = true;
  return term;
}

std::optional<Term> simple_unit(std::string_view name) {
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
  if (found == units.end()) return std::nullopt;
  Term term;
  term.value = found->value;
  term.number = 1;
  term.decades = found->decades;
  term.dimension = found->dimension;
  term.has_unit = true;
  return term;
}

/// A unit, one with a prefix, or several without a sign between them: "Ns".
std::optional<Term> named(std::string_view name) {
  if (name == "pi") {
    Term term = plain_number(std::numbers::pi);
    term.has_pi = true;
    return term;
  }
  if (const auto unit = simple_unit(name)) return unit;
  for (const auto& [letter, decades] : prefixes) {
    if (name.size() < 2 || name.front() != letter) continue;
    const auto base =
        std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name.substr(1); });
    if (base == units.end() || !base->takes_prefix) continue;
    Term term = *simple_unit(base->name);
    term.decades += decades;
    return term;
  }
  constexpr size_t longest = 8;  // "kgms"; trying all ways to part a long word takes long
  for (size_t first = name.size() - 1; first > 0 && name.size() <= longest; --first) {
    const auto left = named(name.substr(0, first)), right = named(name.substr(first));
    if (left && right) return *left * *right;
  }
  return std::nullopt;
}

/// What people type for one and the same, in ASCII.
std::string in_ascii(std::string_view text) {
  static const std::array<std::pair<std::string_view, std::string_view>, 19> others = {{{"−", "-"},
                                                                                        {"–", "-"},
                                                                                        {"·", "*"},
                                                                                        {"⋅", "*"},
                                                                                        {"×", "*"},
                                                                                        {"π", " pi "},
                                                                                        {"°", " deg "},
                                                                                        {"%", " percent "},
                                                                                        {"µ", "u"},
                                                                                        {"μ", "u"},
                                                                                        {"½", "(1/2)"},
                                                                                        {"¼", "(1/4)"},
                                                                                        {"√", " sqrt "},
                                                                                        {"\u00a0", " "},
                                                                                        {"\u202f", " "},
                                                                                        {"\u2009", " "},
                                                                                        {"\t", " "},
                                                                                        {"**", "^"},
                                                                                        {"∕", "/"}}};
  static const std::array<std::string_view, 11> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁻"};
  std::string ascii;
  bool in_superscript = false;
  while (!text.empty()) {
    const auto begins = [&](std::string_view sign) { return text.starts_with(sign); };
    if (const auto sign = std::find_if(raised.begin(), raised.end(), begins); sign != raised.end()) {
      if (!in_superscript) ascii += '^';
      in_superscript = true;
      ascii += "0123456789-"[sign - raised.begin()];
      text.remove_prefix(sign->size());
      continue;
    }
    in_superscript = false;
    const auto other = std::find_if(others.begin(), others.end(), [&](const auto& o) { return begins(o.first); });
    ascii += other == others.end() ? text.substr(0, 1) : other->second;
    text.remove_prefix(other == others.end() ? 1 : other->first.size());
  }
  return ascii;
}

class Reader {
 public:
  explicit Reader(std::string_view typed) : typed_(typed), text_(in_ascii(typed)), rest_(text_) {}

  TypedQuantity read() {
    constexpr size_t longest = 200;  // what nests more deeply was not typed
    if (typed_.size() > longest) fail();
    Term term = sum();
    skip_blanks();
    if (!rest_.empty()) fail();
    term.value = ten_to(term.value, term.decades);
    if (!std::isfinite(term.value)) {
      if (typed_.find('/') != std::string_view::npos)
        throw std::invalid_argument(fmt::format("\"{}\" divides by zero", typed_));
      fail();
    }
    return term;
  }

 private:
  [[noreturn]] void fail() const { throw std::invalid_argument(fmt::format("\"{}\" is not a number", typed_)); }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  bool take(char sign) {
    skip_blanks();
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool letter() const { return !rest_.empty() && std::isalpha(static_cast<unsigned char>(rest_.front())); }
  bool digit() const { return !rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())); }

  Term sum() {
    Term total = product();
    while (true) {
      const bool minus = take('-');
      if (!minus && !take('+')) return total;
      Term more = product();
      if (!(more.dimension == total.dimension)) fail();
      for (Term* const term : {&total, &more}) {
        term->value = ten_to(term->value, std::exchange(term->decades, 0));
        if (minus && term == &more) term->value = -term->value, term->number = -term->number;
      }
      total.value += more.value;
      total.number += more.number;
      total.keep_kind(more);
    }
  }

  Term product() {
    Term all = signed_factor();
    while (true) {
      if (take('*')) {
        all = all * signed_factor();
      } else if (take('/')) {
        all = all / signed_factor();
      } else {
        // Side by side: "2 pi", "N s", "2 1/s", but not two numbers.
        skip_blanks();
        const bool reciprocal = rest_.starts_with("1/") && rest_.size() > 2 && std::isalpha(rest_[2]);
        if (!letter() && !reciprocal && !rest_.starts_with('(')) return all;
        all = all * factor();
      }
    }
  }

  Term signed_factor() {
    if (take('-')) return plain_number(-1) * signed_factor();
    take('+');
    return factor();
  }

  Term factor() {
    skip_blanks();
    if (letter()) {
      const std::string_view name = word();
      if (name == "sqrt") return square_root(factor());
      const auto unit = named(name);
      if (!unit) fail();
      return digit() ? power(*unit, integer()) : raised(*unit);  // "m2"
    }
    if (take('(')) {
      const Term inside = sum();
      if (!take(')')) fail();
      return raised(inside);
    }
    return raised(plain_number(decimal()));
  }

  Term raised(const Term& base) {
    if (!take('^')) return base;
    const bool bracket = take('(');
    const int exponent = integer();
    if (bracket && !take(')')) fail();
    return power(base, exponent);
  }

  Term square_root(Term term) const {
    if (term.has_unit || term.value < 0) fail();
    term.value = term.number = std::sqrt(term.value);
    return term;
  }

  std::string_view word() {
    size_t end = 0;
    while (end < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[end]))) ++end;
    const std::string_view name = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return name;
  }

  int integer() {
    skip_blanks();
    int value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{} || std::abs(value) > 400) fail();
    rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
    return value;
  }

  /// "1,500" is a thousand and a half to some and one and a half to others; "0,500" and "1,50" are clear.
  void refuse_thousands(const std::string& digits) const {
    const size_t comma = digits.find(',');
    if (comma == std::string::npos || digits.size() != comma + 4 || comma < 1 || comma > 3 || digits[0] == '0' ||
        digits.find('.') != std::string::npos)
      return;
    std::string point = digits, none = digits;
    point[comma] = '.';
    none.erase(comma, 1);
    throw std::invalid_argument(fmt::format("\"{}\" may mean {} or {}; write one of them", typed_, none, point));
  }

  /// A decimal number with a point or a comma.
  double decimal() {
    size_t length = std::min(rest_.find_first_not_of("0123456789.,"), rest_.size());
    std::string digits(rest_.substr(0, length));
    refuse_thousands(digits);
    std::replace(digits.begin(), digits.end(), ',', '.');
    rest_.remove_prefix(length);
    const size_t sign = rest_.size() > 1 && (rest_[1] == '-' || rest_[1] == '+') ? 2 : 1;
    if (!digits.empty() && (rest_.starts_with('e') || rest_.starts_with('E')) && rest_.size() > sign &&
        std::isdigit(static_cast<unsigned char>(rest_[sign]))) {
      length = std::min(rest_.find_first_not_of("0123456789", sign), rest_.size());
      digits += rest_.substr(0, length);
      rest_.remove_prefix(length);
    }
    // libc++ reads no double with from_chars before version 20.
    char* end = nullptr;
    errno = 0;
    const double value = std::strtod(digits.c_str(), &end);
    if (digits.empty() || errno == ERANGE || end != digits.c_str() + digits.size()) fail();
    return value;
  }

  std::string_view typed_;
  std::string text_;
  std::string_view rest_;
};

}  // namespace

TypedQuantity read_typed(std::string_view text) { return Reader(text).read(); }

double read_number(std::string_view text) {
  const TypedQuantity read = read_typed(text);
  if (read.has_unit || !read.has_number) throw std::invalid_argument(fmt::format("\"{}\" is not a number", text));
  return read.value;
}

bool is_unit(std::string_view unit) {
  try {
    return unit == "1" || read_typed(unit).has_unit;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

double read_quantity(std::string_view text, const std::string& unit) {
  const TypedQuantity read = read_typed(text);
  if (read.has_pi && !read.has_unit && is_unit(unit) && read_typed(unit).value == degree)
    throw std::invalid_argument(
        fmt::format("\"{}\" has π but no unit; write {} rad, or degrees without π", text, text));
  if (!read.has_unit || !read.has_number) return read_number(text);
  const TypedQuantity in = is_unit(unit) ? read_typed(unit) : TypedQuantity{.value = 1};
  if (!(read.dimension == in.dimension))
    throw std::invalid_argument(fmt::format("\"{}\" is not a number in {}", text, unit));
  // 30° is 30 degrees to the last bit.
  return read.value == read.number * in.value ? read.number : read.value / in.value;
}

}  // namespace byhand::course
