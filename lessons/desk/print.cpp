#include "lessons/desk/print.hpp"

#include <cctype>
#include <cstdio>
#include <map>

#include "lessons/desk/vocabulary.hpp"

namespace byhand::desk {
namespace {

/// How tightly an operation binds its operands.
int strength(const Expression& e) {
  switch (e->op) {
    case Op::add:
    case Op::subtract: return 1;
    case Op::negate: return 2;
    case Op::multiply:
    case Op::divide:
    case Op::dot: return 3;
    case Op::cross: return 4;
    case Op::power:
    case Op::transpose:
    case Op::rate: return 5;
    case Op::number: return e->number < 0 ? 2 : e->divisor > 1 ? 3 : 6;
    default: return 6;
  }
}

std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

/// The letters before the digits of a name, and those.
std::pair<std::string, std::string> parts_of(const std::string& name) {
  std::size_t digits = name.size();
  while (digits > 1 && std::isdigit(static_cast<unsigned char>(name[digits - 1]))) --digits;
  return {name.substr(0, digits), name.substr(digits)};
}

const std::map<std::string, std::string>& greek() {
  static const std::map<std::string, std::string> letters = {
      {"α", "alpha"}, {"β", "beta"},  {"γ", "gamma"}, {"δ", "delta"},  {"ε", "varepsilon"}, {"ζ", "zeta"},
      {"η", "eta"},   {"θ", "theta"}, {"κ", "kappa"}, {"λ", "lambda"}, {"μ", "mu"},         {"ν", "nu"},
      {"π", "pi"},    {"ρ", "rho"},   {"σ", "sigma"}, {"τ", "tau"},    {"φ", "varphi"},     {"χ", "chi"},
      {"ψ", "psi"},   {"ω", "omega"}, {"Δ", "Delta"}, {"Λ", "Lambda"}, {"Ω", "Omega"}};
  return letters;
}

struct Characters {
  static std::string name(const std::string& of) { return of; }
  static std::string number(double value) {
    if (value == 0.5) return "½";
    std::string text = decimal(value);
    return value < 0 ? "−" + text.substr(1) : text;
  }
  static std::string unary(const char* function, const std::string& of) {
    return std::string(function) + "(" + of + ")";
  }
  static constexpr const char *minus = "−", *dot = " · ", *cross = " × ", *open = "(", *close = ")", *bar = "|";
  static std::string sine(const std::string& of) { return unary("sin", of); }
  static std::string cosine(const std::string& of) { return unary("cos", of); }
  static std::string arctangent(const std::string& y, const std::string& x) {
    return "atan2(" + y + ", " + x + ")";
  }
  static std::string root(const std::string& of) { return "√(" + of + ")"; }
  static std::string fraction(const std::string& a, const std::string& b) { return a + "/" + b; }
  static constexpr bool fractions = false;
  static std::string power(const std::string& base, int n) {
    return base + (n == 2 ? "²" : n == 3 ? "³" : "^" + std::to_string(n));
  }
  static std::string transposed(const std::string& of) { return of + "ᵀ"; }
  static std::string rate(const std::string& of) { return of + "'"; }
  static std::string skew(const std::string& of) { return "skew(" + of + ")"; }
  static std::string perp(const std::string& of) { return "perp(" + of + ")"; }
};

struct Latex {
  static std::string name(const std::string& of) { return latex_name(of); }
  static std::string number(double value) { return value == 0.5 ? "\\frac{1}{2}" : decimal(value); }
  static constexpr const char *minus = "-", *dot = " \\cdot ", *cross = " \\times ", *open = "(", *close = ")",
                              *bar = "|";
  static std::string sine(const std::string& of) { return "\\sin(" + of + ")"; }
  static std::string cosine(const std::string& of) { return "\\cos(" + of + ")"; }
  static std::string arctangent(const std::string& y, const std::string& x) {
    return "\\mathrm{atan2}(" + y + ", " + x + ")";
  }
  static std::string root(const std::string& of) { return "\\sqrt{" + of + "}"; }
  static std::string fraction(const std::string& a, const std::string& b) {
    return "\\frac{" + a + "}{" + b + "}";
  }
  static constexpr bool fractions = true;
  static std::string power(const std::string& base, int n) { return base + "^{" + std::to_string(n) + "}"; }
  static std::string transposed(const std::string& of) { return of + "^{\\mathrm{T}}"; }
  static std::string rate(const std::string& of) { return "\\dot{" + of + "}"; }
  static std::string skew(const std::string& of) { return "\\mathrm{skew}(" + of + ")"; }
  static std::string perp(const std::string& of) { return "\\mathrm{perp}(" + of + ")"; }
};

template <class S>
std::string print(const Expression& e);

/// In brackets if it binds less tightly than that.
template <class S>
std::string within(const Expression& e, int least) {
  const std::string text = print<S>(e);
  return strength(e) < least ? S::open + text + S::close : text;
}

template <class S>
std::string print(const Expression& e) {
  const auto& of = e->of;
  switch (e->op) {
    case Op::number:
      if (!e->shape.scalar()) return e->number == 0 ? "0" : "E";
      return S::number(e->number);
    case Op::symbol: return S::name(e->symbol->name);
    case Op::negate: return S::minus + within<S>(of[0], 3);
    case Op::add: return within<S>(of[0], 1) + " + " + within<S>(of[1], 2);
    case Op::subtract: return within<S>(of[0], 1) + " " + S::minus + " " + within<S>(of[1], 3);
    case Op::multiply:
      return within<S>(of[0], of[0]->op == Op::dot ? 4 : 3) + " " +
             within<S>(of[1], of[1]->op == Op::number ? 6 : 4);
    case Op::divide:
      if (S::fractions) return S::fraction(print<S>(of[0]), print<S>(of[1]));
      return S::fraction(within<S>(of[0], 3), within<S>(of[1], 5));
    // After a scalar factor a dot binds the vector alone, so that a product on its left needs brackets.
    case Op::dot: return within<S>(of[0], of[0]->op == Op::dot ? 4 : 3) + S::dot + within<S>(of[1], 4);
    case Op::cross: return within<S>(of[0], 5) + S::cross + within<S>(of[1], 5);
    case Op::length: return S::bar + print<S>(of[0]) + S::bar;
    case Op::power: return S::power(within<S>(of[0], 6), static_cast<int>(e->number));
    case Op::root: return S::root(print<S>(of[0]));
    case Op::sine: return S::sine(print<S>(of[0]));
    case Op::cosine: return S::cosine(print<S>(of[0]));
    case Op::arctangent: return S::arctangent(print<S>(of[0]), print<S>(of[1]));
    case Op::transpose: return S::transposed(within<S>(of[0], 6));
    case Op::perp: return S::perp(print<S>(of[0]));
    case Op::skew: return S::skew(print<S>(of[0]));
    case Op::rate: return S::rate(within<S>(of[0], 6));
  }
  return "";
}

}  // namespace

std::string latex_name(const std::string& name) {
  auto [letters, digits] = parts_of(name);
  if (const auto it = greek().find(letters); it != greek().end())
    letters = "\\" + it->second;
  else if (letters.size() > 1)
    letters = "\\mathrm{" + letters + "}";
  return digits.empty() ? letters : letters + "_{" + digits + "}";
}

std::string characters(const Expression& e) { return print<Characters>(e); }
std::string latex(const Expression& e) { return print<Latex>(e); }

namespace {

std::string cpp_name(const std::string& name) {
  auto [letters, digits] = parts_of(name);
  if (const auto it = greek().find(letters); it != greek().end()) letters = it->second;
  return letters + digits;
}

std::string typed(const Expression& e, const std::string& text) {
  if (e->shape.scalar()) return "T(" + text + ")";
  const std::string rows = std::to_string(e->shape.rows), cols = std::to_string(e->shape.cols);
  return "Eigen::Matrix<T, " + rows + ", " + cols + ">(" + text + ")";
}

}  // namespace

std::string cpp(const Expression& e) {
  const auto& of = e->of;
  const auto a = [&] { return cpp(of[0]); };
  const auto b = [&] { return cpp(of[1]); };
  switch (e->op) {
    case Op::number: {
      if (e->shape.scalar()) {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", e->number);
        return std::string("T(") + text + ")";
      }
      const std::string type =
          "Eigen::Matrix<T, " + std::to_string(e->shape.rows) + ", " + std::to_string(e->shape.cols) + ">";
      return type + "(" + type + (e->number == 0 ? "::Zero())" : "::Identity())");
    }
    case Op::symbol: return cpp_name(e->symbol->name);
    case Op::negate: return typed(e, "-" + a());
    case Op::add: return typed(e, a() + " + " + b());
    case Op::subtract: return typed(e, a() + " - " + b());
    case Op::multiply: {
      // A scalar goes behind, as Eigen has it for scalars of any type.
      const bool first = of[0]->shape.scalar() && !of[1]->shape.scalar();
      return typed(e, first ? b() + " * " + a() : a() + " * " + b());
    }
    case Op::divide: return typed(e, a() + " / " + b());
    case Op::dot: return typed(e, a() + ".dot(" + b() + ")");
    case Op::cross:
      if (of[0]->shape.scalar()) return typed(e, "turned(" + b() + ") * " + a());
      if (of[1]->shape.scalar()) return typed(e, "turned(" + a() + ") * T(-" + b() + ")");
      return typed(e, e->shape.scalar() ? "turned(" + a() + ").dot(" + b() + ")" : a() + ".cross(" + b() + ")");
    case Op::length: return of[0]->shape.scalar() ? "abs(" + a() + ")" : "sqrt(" + a() + ".squaredNorm())";
    case Op::power: {
      const int n = static_cast<int>(e->number), times = n < 0 ? -n : n;
      std::string text = "T(1)";
      for (int i = 0; i < times; ++i) text += " * " + a();
      return n < 0 ? "T(T(1) / (" + text + "))" : "T(" + text + ")";
    }
    case Op::root: return "sqrt(" + a() + ")";
    case Op::sine: return "sin(" + a() + ")";
    case Op::cosine: return "cos(" + a() + ")";
    case Op::arctangent: return "atan2(" + a() + ", " + b() + ")";
    case Op::transpose: return typed(e, a() + ".transpose()");
    case Op::perp: return "turned(" + a() + ")";
    case Op::skew: return "skew(" + a() + ")";
    case Op::rate: return b();
  }
  return "";
}

}  // namespace byhand::desk
