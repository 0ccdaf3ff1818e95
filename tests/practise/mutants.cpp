#include "tests/practise/mutants.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace byhand::tests {
namespace {

struct Token {
  std::size_t at = 0, size = 0;
  std::string text;
  bool name() const { return std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_'; }
  bool number() const { return std::isdigit(static_cast<unsigned char>(text[0])); }
};

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::vector<Token> tokens_of(const std::string& code) {
  std::vector<Token> all;
  for (std::size_t at = 0; at < code.size();) {
    std::size_t end = at + 1;
    if (std::isspace(static_cast<unsigned char>(code[at]))) {
      at = end;
      continue;
    }
    if (in_word(code[at])) {
      const bool number = std::isdigit(static_cast<unsigned char>(code[at]));
      while (end < code.size() && (in_word(code[end]) || (number && code[end] == '.'))) ++end;
    } else if (end < code.size() && std::string("+-*/<>=!:&|").find(code[at]) != std::string::npos &&
               (code[end] == '=' ||
                (code[end] == code[at] && std::string(":&|+-").find(code[at]) != std::string::npos))) {
      ++end;
    }
    all.push_back({at, end - at, code.substr(at, end - at)});
    at = end;
  }
  return all;
}

/// Without #include lines, which an exercise has, and without comments, which no change touches.
std::string bare(const std::string& code) {
  std::istringstream lines(code);
  std::string all;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#")) all += line.substr(0, line.find("//")) + "\n";
  return all;
}

std::string one_line(const std::string& text) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// The lines from the one that holds `begin` to the one that holds `end`.
std::string lines_around(const std::string& text, std::size_t begin, std::size_t end) {
  const auto first = text.rfind('\n', begin);
  const std::size_t from = first == std::string::npos ? 0 : first + 1;
  return one_line(text.substr(from, std::min(text.find('\n', end), text.size()) - from));
}

class Mutating {
 public:
  explicit Mutating(const std::string& code) : code_(bare(code)), tokens_(tokens_of(code_)) {}

  std::vector<Mutant> all() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (token.name()) {
        name(i);
      } else if (token.number()) {
        replace(token, "(1 + " + token.text + ")");
        if (std::stod(token.text) == 0) continue;
        for (const char* change : {"(2 * ", "(-"}) replace(token, change + token.text + ")");
      } else {
        sign(i);
      }
    }
    statements();
    return std::move(mutants_);
  }

 private:
  const std::string& text(std::size_t i) const {
    static const std::string none;
    return i < tokens_.size() ? tokens_[i].text : none;
  }

  void add(std::size_t at, std::size_t size, const std::string& instead) {
    std::string changed = code_;
    changed.replace(at, size, instead);
    if (seen_.insert(changed).second)
      mutants_.push_back(
          {lines_around(code_, at, at + size), lines_around(changed, at, at + instead.size()), changed});
  }
  void replace(const Token& token, const std::string& instead) { add(token.at, token.size, instead); }

  void name(std::size_t i) {
    static const std::set<std::string> words = {"const",  "double", "int", "size_t",
                                                "return", "for",    "std", "void"};
    const Token& token = tokens_[i];
    const bool called = text(i + 1) == "(";
    if (token.text == "return") return returned(i);
    if (words.contains(token.text)) return;
    if (token.text == "max" || token.text == "min") return replace(token, token.text == "max" ? "min" : "max");
    if (token.text == "length" && called) return replace(token, "2 * length");
    if (token.text == "cross" && called) return arguments(i);
    if (called) return;
    // The loop `for (Row& row : rows)`: rows are left out, or copied.
    if (text(i - 1) == ":" && text(i + 1) == ")") {
      replace(token, token.text + ".first(" + token.text + ".size() - 1)");
      replace(token, token.text + ".subspan(1)");
      replace(token, token.text + ".first(" + token.text + ".size() < 3 ? " + token.text + ".size() : 3)");
    }
    if (text(i + 1) == "&" && text(i - 1) != "const") add(tokens_[i + 1].at, 1, " ");
    for (const std::string& other : others(i)) replace(token, other);
    if (text(i - 1) == "." || counts(token.text)) return;
    const std::string whole = text(i + 1) == "." ? token.text + "." + text(i + 2) : token.text;
    for (const char* change : {"(-", "(2 * ", "(1.01 * ", "double(float("})
      add(token.at, whole.size(), change + whole + (change[0] == 'd' ? "))" : ")"));
  }

  /// Whether the code declares this name as a whole number: no factor changes an index that is compared with 0.
  bool counts(const std::string& name) const {
    for (std::size_t k = 1; k < tokens_.size(); ++k)
      if (text(k) == name && (text(k - 1) == "int" || text(k - 1) == "size_t")) return true;
    return false;
  }

  /// Names that may stand in this one's place: members for a member, else what the same function speaks of.
  std::set<std::string> others(std::size_t i) const {
    const bool member = text(i - 1) == ".";
    std::set<std::string> all;
    const auto [begin, end] = function_around(i);
    for (std::size_t k = begin; k < end; ++k)
      if (tokens_[k].name() && (text(k - 1) == ".") == member && text(k + 1) != "(" && text(k) != text(i))
        all.insert(text(k));
    std::string partner = text(i);
    for (char& c : partner) c = c == '1' ? '2' : c == '2' ? '1' : c;
    if (partner != text(i)) all.insert(partner);
    if (member)
      for (const char* name : {"x", "y", "m1", "m2", "I1", "I2", "l1", "l2", "a1", "a2"})
        if (text(i) != name) all.insert(name);
    return all;
  }

  std::pair<std::size_t, std::size_t> function_around(std::size_t i) const {
    std::size_t begin = 0, depth = 0;
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      if (text(k) == "{") ++depth;
      if (text(k) != "}") continue;
      if (--depth > 0) continue;
      if (k >= i) return {begin, k};
      begin = k + 1;
    }
    return {begin, tokens_.size()};
  }

  void sign(std::size_t i) {
    const Token& token = tokens_[i];
    const std::string& before = text(i - 1);
    const bool binary = in_word(before.back()) || before == ")" || before == "]";
    if (token.text == "+") replace(token, "-");
    if (token.text == "-") replace(token, binary ? "+" : "");
    if (token.text == "*") replace(token, "/");
    if (token.text == "/") replace(token, "*");
    if (token.text == "+=") replace(token, "-="), replace(token, "=");
    if (token.text == "-=") replace(token, "+="), replace(token, "=");
  }

  /// The arguments of a call of two.
  void arguments(std::size_t i) {
    std::size_t comma = 0, depth = 0, k = i + 1;
    for (; k < tokens_.size(); ++k) {
      if (text(k) == "(") ++depth;
      if (text(k) == ")" && --depth == 0) break;
      if (text(k) == "," && depth == 1) comma = k;
    }
    if (comma == 0 || k == tokens_.size()) return;
    const std::size_t first = tokens_[i + 1].at + 1, between = tokens_[comma].at, end = tokens_[k].at;
    add(first, end - first,
        code_.substr(between + 1, end - between - 1) + ", " + code_.substr(first, between - first));
  }

  void returned(std::size_t i) {
    std::size_t k = i;
    while (text(k) != ";") ++k;
    const std::size_t from = tokens_[i].at + 7;
    const std::string value = code_.substr(from, tokens_[k].at - from);
    for (const std::string& change :
         {"-(" + value + ")", "2 * (" + value + ")", "std::fabs(" + value + ")", "double(float(" + value + "))",
          "(std::fabs(" + value + ") < 0.01 ? 0.0 : " + value + ")", "std::fmax(0.0, " + value + ")",
          "std::fmin(0.0, " + value + ")", std::string("0.0")})
      add(from, tokens_[k].at - from, change);
  }

  void statements() {
    struct Statement {
      std::size_t at, end;
    };
    std::vector<Statement> all;
    std::size_t begin = 0, inside = 0;  // of how many (…) and of how many lists {…} of values
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      const bool list = token.text == "{" && (text(i - 1) == "return" || text(i - 1) == "=");
      if (token.text == "(" || list || (token.text == "{" && inside > 0)) {
        ++inside;
      } else if (token.text == ")" || (token.text == "}" && inside > 0)) {
        --inside;
      } else if (token.text == "{" || token.text == "}") {
        begin = token.at + 1;
      } else if (token.text == ";" && inside == 0) {
        while (std::isspace(static_cast<unsigned char>(code_[begin]))) ++begin;
        all.push_back({begin, token.at + 1});
        begin = token.at + 1;
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [at, end] = all[i];
      const std::string here = code_.substr(at, end - at);
      if (here == ";" || here.starts_with("return")) continue;
      add(at, end - at, ";");
      add(at, end - at, here + " " + here);
      if (i + 1 == all.size()) continue;
      const auto next = all[i + 1];
      if (code_.find('}', end) < next.at) continue;
      add(at, next.end - at, code_.substr(next.at, next.end - next.at) + " " + here);
    }
  }

  std::string code_;
  std::vector<Token> tokens_;
  std::set<std::string> seen_;
  std::vector<Mutant> mutants_;
};

}  // namespace

std::vector<Mutant> mutants_of(const std::string& code) { return Mutating(code).all(); }

}  // namespace byhand::tests
