#include "lessons/desk/lexer.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

namespace byhand::desk {
namespace {

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

const std::map<std::string, std::string, std::less<>>& greek_words() {
  static const std::map<std::string, std::string, std::less<>> words = {
      {"alpha", "α"},  {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"},    {"epsilon", "ε"}, {"varepsilon", "ε"},
      {"zeta", "ζ"},   {"eta", "η"},    {"theta", "θ"}, {"vartheta", "θ"}, {"kappa", "κ"},   {"lambda", "λ"},
      {"mu", "μ"},     {"nu", "ν"},     {"pi", "π"},    {"rho", "ρ"},      {"sigma", "σ"},   {"tau", "τ"},
      {"phi", "φ"},    {"varphi", "φ"}, {"chi", "χ"},   {"psi", "ψ"},      {"omega", "ω"},   {"Delta", "Δ"},
      {"Lambda", "Λ"}, {"Omega", "Ω"},  {"ell", "l"}};
  return words;
}

/// Signs beyond ASCII, and what they mean.
const std::map<std::string, std::string, std::less<>>& signs() {
  static const std::map<std::string, std::string, std::less<>> all = {
      {"−", "-"}, {"–", "-"},  {"·", "."},  {"⋅", "."},  {"×", "x"},   {"⨯", "x"},
      {"÷", "/"}, {"²", "^2"}, {"³", "^3"}, {"ᵀ", "^T"}, {"½", "1/2"}, {"√", "sqrt"},
      {"′", "'"}, {"’", "'"},  {"≥", ">="}, {"‖", "|"},  {"∥", "|"},   {"\u0307", "'"}};
  return all;
}

/// Commands of LaTeX that are signs, and those that only look.
const std::map<std::string, std::string, std::less<>>& commands() {
  static const std::map<std::string, std::string, std::less<>> all = {
      {"cdot", "."},    {"bullet", "."}, {"times", "x"}, {"frac", "frac"}, {"tfrac", "frac"}, {"dfrac", "frac"},
      {"sqrt", "sqrt"}, {"lVert", "|"},  {"rVert", "|"}, {"lvert", "|"},   {"rvert", "|"},    {"Vert", "|"},
      {"vert", "|"},    {"|", "|"},      {"mid", "|"},   {"top", "T"},     {"intercal", "T"}, {"ge", ">="},
      {"geq", ">="},    {"dot", "dot"},  {"hat", "hat"}, {"div", "/"},     {"prime", "'"},    {"cdots", "…"},
      {"dots", "…"},    {"ldots", "…"}};
  return all;
}
const std::set<std::string, std::less<>>& wrappers() {
  static const std::set<std::string, std::less<>> all = {
      "left",       "right", "big",    "Big",    "bigl",   "bigr",         "Bigl",  "Bigr", "mathbf",
      "boldsymbol", "bm",    "mathrm", "mathsf", "mathit", "operatorname", "text",  "vec",  "displaystyle",
      ",",          ";",     ":",      "!",      " ",      "quad",         "qquad", "\\",   "underline",
      "overline",   "mathbb"};
  return all;
}

std::string subscript_digit(std::string_view rest) {
  static const std::array<std::string_view, 10> digits = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  for (std::size_t i = 0; i < digits.size(); ++i)
    if (rest.starts_with(digits[i])) return std::to_string(i);
  return "";
}

/// A Greek letter at the beginning, in its two bytes.
bool greek_at(std::string_view rest) {
  if (rest.size() < 2) return false;
  const auto a = static_cast<unsigned char>(rest[0]), b = static_cast<unsigned char>(rest[1]);
  return (a == 0xCE && b >= 0x91) || (a == 0xCF && b <= 0x95);
}

class Lexer {
 public:
  explicit Lexer(std::string_view line) : line_(line) {}

  std::vector<Token> all() {
    while (at_ < line_.size()) next();
    push(Token::Is::end, "", at_);
    return std::move(all_);
  }

 private:
  std::string_view rest() const { return line_.substr(at_); }
  bool is(std::size_t i, char c) const { return i < line_.size() && line_[i] == c; }

  void push(Token::Is kind, std::string text, std::size_t begin) {
    all_.push_back({kind, std::move(text), {static_cast<int>(begin), static_cast<int>(at_)}, spaced_});
    spaced_ = false;
  }
  void sign(const char* text, std::size_t length) {
    const std::size_t begin = at_;
    at_ += length;
    push(Token::Is::sign, text, begin);
  }

  void next() {
    const char c = line_[at_];
    if (c == ' ' || c == '\t' || c == '$' || c == '\r') {
      ++at_;
      spaced_ = true;
    } else if (c == '\\') {
      command();
    } else if (digit(c)) {
      number();
    } else if (letter(c) || greek_at(rest())) {
      name();
    } else if (c == '>' && is(at_ + 1, '=')) {
      sign(">=", 2);
    } else if (c == '&') {
      if (depth_ > 0) return sign(",", 1);
      ++at_;
    } else if (std::string_view("+-*/.|()[]{},^'=").find(c) != std::string_view::npos) {
      const char text[2] = {c, 0};
      sign(text, 1);
    } else {
      other();
    }
  }

  void other() {
    for (const auto& [text, meaning] : signs())
      if (rest().starts_with(text)) return meant(meaning, text.size());
    const std::size_t begin = at_;
    std::size_t length = 1;
    while (begin + length < line_.size() && (static_cast<unsigned char>(line_[begin + length]) & 0xC0) == 0x80)
      ++length;
    const bool printable = length > 1 || std::isprint(static_cast<unsigned char>(line_[begin]));
    throw Complaint({static_cast<int>(begin), static_cast<int>(begin + length)},
                    printable ? "\"" + std::string(line_.substr(begin, length)) + "\" has no meaning here."
                              : "This character cannot be read.");
  }

  void meant(const std::string& meaning, std::size_t length) {
    const std::size_t begin = at_;
    at_ += length;
    if (meaning == "1/2") {
      push(Token::Is::number, "0.5", begin);
    } else if (meaning.size() == 2 && meaning[0] == '^') {
      push(Token::Is::sign, "^", begin);
      if (meaning[1] == 'T')
        push(Token::Is::sign, "T", begin);
      else
        push(Token::Is::number, meaning.substr(1), begin);
    } else {
      push(Token::Is::sign, meaning, begin);
    }
  }

  void command() {
    const std::size_t begin = at_;
    std::size_t end = at_ + 1;
    while (end < line_.size() && letter(line_[end])) ++end;
    if (end == at_ + 1 && end < line_.size()) ++end;
    const std::string word(line_.substr(at_ + 1, end - at_ - 1));
    if (word == "begin" || word == "end") {
      const std::size_t close = line_.find('}', end);
      if (close == std::string_view::npos)
        throw Complaint({static_cast<int>(begin), static_cast<int>(line_.size())},
                        "\\" + word + " has no name in braces.");
      depth_ += word == "begin" ? 1 : -1;
      at_ = close + 1;
      push(Token::Is::sign, word == "begin" ? "[" : "]", begin);
      return;
    }
    if (const auto it = commands().find(word); it != commands().end()) {
      at_ = end;
      push(Token::Is::sign, it->second, begin);
      if (word == "dot" || word == "hat") dressed_name();
      return;
    }
    if (wrappers().count(word)) {
      at_ = end;
      spaced_ = true;
      dressed_name();
      return;
    }
    if (word == "sin" || word == "cos" || word == "arctan") {
      at_ = end;
      return push(Token::Is::name, word == "arctan" ? "atan2" : word, begin);
    }
    if (const auto it = greek_words().find(word); it != greek_words().end()) {
      at_ = end;
      std::string text = it->second;
      subscripts(text);
      return push(Token::Is::name, canonical(text), begin);
    }
    throw Complaint({static_cast<int>(begin), static_cast<int>(end)}, "\\" + word + " is not known here.");
  }

  /// \mathbf{p}_2, \dot{\omega}_1, \operatorname{perp}: the braces hold a name, whose digits stand behind them.
  void dressed_name() {
    if (!is(at_, '{')) return;
    const std::size_t begin = at_, close = line_.find('}', at_);
    if (close == std::string_view::npos) return;
    std::string text(line_.substr(at_ + 1, close - at_ - 1));
    if (text.starts_with('\\')) {
      const auto it = greek_words().find(text.substr(1));
      if (it == greek_words().end()) return;
      text = it->second;
    } else if (text.empty() || !std::all_of(text.begin(), text.end(), letter)) {
      return;
    }
    at_ = close + 1;
    subscripts(text);
    if (text == "T") return push(Token::Is::sign, "T", begin);
    push(Token::Is::name, canonical(text), begin);
  }

  void number() {
    const std::size_t begin = at_;
    while (at_ < line_.size() && digit(line_[at_])) ++at_;
    if (is(at_, '.') && at_ + 1 < line_.size() && digit(line_[at_ + 1])) {
      ++at_;
      while (at_ < line_.size() && digit(line_[at_])) ++at_;
    }
    push(Token::Is::number, std::string(line_.substr(begin, at_ - begin)), begin);
  }

  /// Digits and letters behind a name: p1, p_1, p_{12}, p₁.
  void subscripts(std::string& text) {
    for (std::string one; at_ < line_.size();) {
      if (digit(line_[at_])) {
        text += line_[at_++];
      } else if (!(one = subscript_digit(rest())).empty()) {
        text += one;
        at_ += 3;
      } else if (line_[at_] == '_' && at_ + 1 < line_.size() &&
                 std::isalnum(static_cast<unsigned char>(line_[at_ + 1]))) {
        ++at_;
        while (at_ < line_.size() && std::isalnum(static_cast<unsigned char>(line_[at_]))) text += line_[at_++];
      } else if (line_[at_] == '_' && is(at_ + 1, '{')) {
        const std::size_t close = line_.find('}', at_);
        if (close == std::string_view::npos)
          throw Complaint({static_cast<int>(at_), static_cast<int>(line_.size())}, "This brace is not closed.");
        for (const char c : line_.substr(at_ + 2, close - at_ - 2))
          if (std::isalnum(static_cast<unsigned char>(c))) text += c;
        at_ = close + 1;
      } else {
        break;
      }
    }
  }

  void name() {
    const std::size_t begin = at_;
    std::string text;
    if (letter(line_[at_])) {
      while (at_ < line_.size() && letter(line_[at_])) text += line_[at_++];
    } else {
      text = line_.substr(at_, 2);
      at_ += 2;
    }
    subscripts(text);
    if (text == "x" || text == "X") return push(Token::Is::sign, "x", begin);
    push(Token::Is::name, canonical(text), begin);
  }

  std::string_view line_;
  std::size_t at_ = 0;
  int depth_ = 0;  // of environments, in which & separates
  bool spaced_ = false;
  std::vector<Token> all_;
};

}  // namespace

std::string canonical(std::string_view name) {
  std::string text;
  for (const char c : name)
    if (c != '\\' && c != '_' && c != '{' && c != '}') text += c;
  std::size_t digits = text.size();
  while (digits > 0 && digit(text[digits - 1])) --digits;
  const std::string letters = text.substr(0, digits), number = text.substr(digits);
  if (letters == "P" && (number == "1" || number == "2")) return "p" + number;  // as the article prints them
  if (letters == "w" && (number == "1" || number == "2")) return "ω" + number;
  if (const auto it = greek_words().find(letters); it != greek_words().end()) return it->second + number;
  return text;
}

std::vector<Token> tokens(std::string_view line) { return Lexer(line).all(); }

}  // namespace byhand::desk
