#include "lessons/page/html/mathml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "lessons/page/error.hpp"
#include "lessons/page/html/markup.hpp"

namespace byhand::site {
namespace {

enum class Kind {
  variable,  // italic
  upright,
  sign,  // an operator: the browser's dictionary spaces it
  relation,
  space,
  function,  // cos, ln
  limits,    // max, sum: scripts stand below and above in a display
};

struct Symbol {
  const char* text;
  Kind kind;
};

const std::map<std::string_view, Symbol> symbols = {
    {"alpha", {"α", Kind::variable}},
    {"beta", {"β", Kind::variable}},
    {"gamma", {"γ", Kind::variable}},
    {"delta", {"δ", Kind::variable}},
    {"varepsilon", {"ε", Kind::variable}},
    {"zeta", {"ζ", Kind::variable}},
    {"eta", {"η", Kind::variable}},
    {"theta", {"θ", Kind::variable}},
    {"kappa", {"κ", Kind::variable}},
    {"lambda", {"λ", Kind::variable}},
    {"mu", {"μ", Kind::variable}},
    {"nu", {"ν", Kind::variable}},
    {"pi", {"π", Kind::variable}},
    {"rho", {"ρ", Kind::variable}},
    {"sigma", {"σ", Kind::variable}},
    {"tau", {"τ", Kind::variable}},
    {"phi", {"ϕ", Kind::variable}},
    {"varphi", {"φ", Kind::variable}},
    {"psi", {"ψ", Kind::variable}},
    {"omega", {"ω", Kind::variable}},
    {"ell", {"ℓ", Kind::variable}},
    {"Delta", {"Δ", Kind::upright}},
    {"Lambda", {"Λ", Kind::upright}},
    {"Omega", {"Ω", Kind::upright}},
    {"infty", {"∞", Kind::upright}},
    {"partial", {"∂", Kind::upright}},
    {"nabla", {"∇", Kind::upright}},
    {"circ", {"°", Kind::upright}},
    {"dots", {"…", Kind::upright}},
    {"cdot", {"⋅", Kind::sign}},
    {"times", {"×", Kind::sign}},
    {"pm", {"±", Kind::sign}},
    {"mp", {"∓", Kind::sign}},
    {"Rightarrow", {"⇒", Kind::relation}},
    {"leftarrow", {"←", Kind::relation}},
    {"to", {"→", Kind::relation}},
    {"iff", {"⟺", Kind::relation}},
    {"le", {"≤", Kind::relation}},
    {"ge", {"≥", Kind::relation}},
    {"ne", {"≠", Kind::relation}},
    {"approx", {"≈", Kind::relation}},
    {"sim", {"∼", Kind::relation}},
    {"ll", {"≪", Kind::relation}},
    {"gg", {"≫", Kind::relation}},
    {"gtrsim", {"≳", Kind::relation}},
    {"lesssim", {"≲", Kind::relation}},
    {"in", {"∈", Kind::relation}},
    {"int", {"∫", Kind::sign}},
    {"oint", {"∮", Kind::sign}},
    {"%", {"%", Kind::upright}},
    {"{", {"{", Kind::sign}},
    {"}", {"}", Kind::sign}},
    {"|", {"‖", Kind::sign}},
    {"cos", {"cos", Kind::function}},
    {"sin", {"sin", Kind::function}},
    {"tan", {"tan", Kind::function}},
    {"ln", {"ln", Kind::function}},
    {"log", {"log", Kind::function}},
    {"exp", {"exp", Kind::function}},
    {"max", {"max", Kind::limits}},
    {"min", {"min", Kind::limits}},
    {"sum", {"∑", Kind::limits}},
};

const std::map<std::string_view, const char*> spaces = {{",", "0.167em"}, {":", "0.222em"}, {";", "0.278em"},
                                                        {" ", "0.25em"},  {"quad", "1em"},  {"qquad", "2em"}};

const std::map<std::string_view, const char*> accents = {{"dot", "˙"}, {"ddot", "¨"}, {"vec", "→"}, {"hat", "^"}};

/// Heights of delimiters that do not stretch by themselves.
const std::map<std::string_view, const char*> sizes = {{"big", "1.2em"}, {"Big", "1.8em"}, {"bigg", "2.4em"}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string element(const char* name, std::string_view inside) {
  return fmt::format("<{0}>{1}</{0}>", name, inside);
}
std::string upright(std::string_view letters) {
  // More than one letter is upright by itself.
  return fmt::format("<mi{}>{}</mi>", letters.size() == 1 ? " mathvariant=\"normal\"" : "", escaped(letters));
}
std::string fence(std::string_view mark, const std::string& attributes) {
  return fmt::format("<mo fence=\"true\"{}>{}</mo>", attributes, escaped(mark));
}

/// Reads a formula from left to right; each function takes what it converts.
class Reader {
 public:
  explicit Reader(std::string_view latex) : whole_(latex), rest_(latex) {}

  /// A formula in one piece.
  std::string whole() {
    const std::string all = row();
    if (!rest_.empty()) fail("does not balance");
    if (all.empty()) fail("is empty");
    return all;
  }

  /// The statements of a display, which \quad separates, and their parts from one relation to the next, long ones
  /// from one term of their sum to the next: lines may break between them.
  struct Part {
    std::string markup = {};
    bool begins_statement = true;
  };
  std::vector<Part> parts() {
    constexpr int long_sum = 7;  // elements
    std::vector<Part> parts = {{}};
    bool related = false;
    int elements = 0;
    operand_ = false;
    while (!ends()) {
      if (take_command("quad") || take_command("qquad")) {
        if (!parts.back().markup.empty()) parts.emplace_back();
        related = operand_ = false;
        elements = 0;
      } else {
        const bool relation = at_relation(),
                   term = elements >= long_sum && operand_ && (rest_.starts_with('+') || rest_.starts_with('-'));
        if (term || (relation && related)) {
          parts.push_back({"", false});
          elements = 0;
        }
        related = related || relation;
        std::string next = scripted();
        // At the beginning of its element it would be a sign of what follows.
        if (term) next.insert(next.find("<mo") + 3, " form=\"infix\"");
        parts.back().markup += next;
        ++elements;
      }
    }
    if (!rest_.empty()) fail("does not balance");
    if (parts.back().markup.empty()) parts.pop_back();
    if (parts.empty()) fail("is empty");
    return parts;
  }

 private:
  /// An element without its scripts.
  struct Base {
    std::string markup;
    Kind kind = Kind::variable;
  };

  [[noreturn]] void fail(std::string_view what) const {
    throw course::LessonError(fmt::format("the formula \"{}\" {} before \"{}\"", whole_, what, rest_));
  }

  // Words of the input.
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size())); }
  std::string_view take(size_t n) {
    const std::string_view taken = rest_.substr(0, n);
    rest_.remove_prefix(taken.size());
    return taken;
  }
  template <class Is>
  std::string_view take_while(Is is) {
    return take(static_cast<size_t>(std::find_if_not(rest_.begin(), rest_.end(), is) - rest_.begin()));
  }
  bool take(std::string_view what) {
    if (!rest_.starts_with(what)) return false;
    rest_.remove_prefix(what.size());
    return true;
  }
  /// The name of the command that comes next; empty if none does.
  std::string_view next_command() const {
    if (!rest_.starts_with('\\')) return {};
    const auto end = std::find_if_not(rest_.begin() + 1, rest_.end(), is_letter);
    const auto letters = static_cast<size_t>(end - rest_.begin()) - 1;
    return rest_.substr(1, std::max<size_t>(letters, 1));
  }
  bool take_command(std::string_view name) {
    skip_blanks();
    if (next_command() != name) return false;
    take(1 + name.size());
    return true;
  }
  std::string_view take_character() {  // of UTF-8
    size_t bytes = 1;
    while (bytes < rest_.size() && (static_cast<unsigned char>(rest_[bytes]) & 0xc0) == 0x80) ++bytes;
    return take(bytes);
  }
  /// What stands between braces, or one character, as it is written.
  std::string_view words() {
    skip_blanks();
    if (rest_.empty()) fail("ends too early");
    if (!take("{")) return take_character();
    const std::string_view inside = take(rest_.find('}'));
    if (!take("}")) fail("lacks a }");
    return inside;
  }

  /// Whether a row ends here: at a closing brace or delimiter, or at the end of a cell.
  bool ends() {
    skip_blanks();
    if (rest_.empty() || rest_.front() == '}' || rest_.front() == '&') return true;
    const std::string_view command = next_command();
    return command == "\\" || command == "end" || command == "right" ||
           (command.ends_with('r') && sizes.contains(command.substr(0, command.size() - 1)));
  }

  bool at_relation() {
    skip_blanks();
    const std::string_view command = next_command();
    const auto found = symbols.find(command);
    return rest_.starts_with('=') || command == "mathrel" ||
           (found != symbols.end() && found->second.kind == Kind::relation);
  }

  /// A row is an operand of what follows it, and begins without one.
  std::string row() {
    std::string row;
    operand_ = false;
    while (!ends()) row += scripted();
    operand_ = true;
    return row;
  }

  /// A group in braces, or one digit (\tfrac12) or element, as one element.
  std::string argument() {
    skip_blanks();
    if (take("{")) {
      // V_{final}: a name, no product of letters.
      const std::string_view name = rest_.substr(0, rest_.find('}'));
      if (name.size() > 2 && std::all_of(name.begin(), name.end(), is_letter)) {
        take(name.size() + 1);
        return upright(name);
      }
      const std::string inside = row();
      if (!take("}")) fail("lacks a }");
      return element("mrow", inside);
    }
    if (!rest_.empty() && is_digit(rest_.front())) return element("mn", take(1));
    return base().markup;
  }

  std::string scripted() {
    const Base it = base();
    std::optional<std::string> below, above;
    std::string primes;
    for (;;) {
      skip_blanks();
      if (take("_"))
        below = argument();
      else if (take("^"))
        above = argument();
      else if (take("'"))
        primes += "<mo lspace=\"0\" rspace=\"0\">′</mo>";
      else
        break;
    }
    if (!primes.empty()) above = element("mrow", primes + above.value_or(""));
    if (it.kind != Kind::space) operand_ = it.kind != Kind::sign && it.kind != Kind::relation;
    const bool limits = it.kind == Kind::limits;
    std::string all = it.markup;
    if (below && above)
      all = element(limits ? "munderover" : "msubsup", all + *below + *above);
    else if (below)
      all = element(limits ? "munder" : "msub", all + *below);
    else if (above)
      all = element(limits ? "mover" : "msup", all + *above);
    return it.kind == Kind::function ? all + space_after_function() : all;
  }

  /// "cos θ" is spaced, "cos(θ)" is not.
  std::string space_after_function() {
    if (ends() || rest_.front() == '(') return "";
    const std::string_view command = next_command();
    const bool opens =
        command == "left" || (command.ends_with('l') && sizes.contains(command.substr(0, command.size() - 1)));
    return opens ? "" : "<mspace width=\"0.167em\"></mspace>";
  }

  Base base() {
    skip_blanks();
    if (rest_.empty()) fail("ends too early");
    const char c = rest_.front();
    if (c == '{') return {argument()};
    if (c == '\\') return command();
    if (is_digit(c)) return {element("mn", number())};
    if (is_letter(c)) return {element("mi", take(1))};
    const std::string_view sign = take_character();
    if (sign == "-") return operation("−");
    if (sign == "+") return operation("+");
    // It closes what follows an operand, and opens what does not.
    if (sign == "|")
      return {"<mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo>", operand_ ? Kind::upright : Kind::sign};
    if (sign == "/") return {"<mo lspace=\"0.06em\" rspace=\"0.06em\">/</mo>", Kind::sign};
    if (sign == "(" || sign == "[") return {fmt::format("<mo stretchy=\"false\">{}</mo>", sign), Kind::sign};
    if (sign == ")" || sign == "]") return {fmt::format("<mo stretchy=\"false\">{}</mo>", sign)};
    if (sign.size() > 1) return {element("mi", sign)};
    return {element("mo", escaped(sign)), sign == "=" ? Kind::relation : Kind::sign};
  }

  /// A sign without an operand before it belongs to what follows, and is not spaced from it.
  Base operation(const char* sign) const {
    return {fmt::format("<mo{}>{}</mo>", operand_ ? "" : " form=\"prefix\"", sign), Kind::sign};
  }

  std::string_view number() {
    const std::string_view from = rest_;
    take_while(is_digit);
    if (rest_.size() > 1 && rest_.front() == '.' && is_digit(rest_[1])) {
      take(1);
      take_while(is_digit);
    }
    return from.substr(0, from.size() - rest_.size());
  }

  Base command() {
    const std::string_view name = next_command();
    take(1 + name.size());
    if (const auto found = symbols.find(name); found != symbols.end()) return symbol(found->second);
    if (const auto space = spaces.find(name); space != spaces.end())
      return {fmt::format("<mspace width=\"{}\"></mspace>", space->second), Kind::space};
    if (const auto accent = accents.find(name); accent != accents.end())
      return {fmt::format("<mover accent=\"true\">{}<mo stretchy=\"false\">{}</mo></mover>", argument(),
                          accent->second)};
    if (name == "frac" || name == "tfrac") return {fraction(name == "tfrac")};
    if (name == "sqrt") return {element("msqrt", argument())};
    if (name == "text") return {element("mtext", unbroken(words()))};
    if (name == "mathrm") return {units()};
    if (name == "mathsf")
      return {fmt::format("<mi mathvariant=\"normal\" class=\"sans\">{}</mi>", escaped(words()))};
    if (name == "mathrel") return {relation(), Kind::relation};
    if (name == "left") return {fenced("right", "")};
    if (name.ends_with('l') && sizes.contains(name.substr(0, name.size() - 1))) {
      const std::string size(name.substr(0, name.size() - 1));
      const char* const height = sizes.at(size);
      return {fenced(size + "r", fmt::format(" minsize=\"{0}\" maxsize=\"{0}\"", height))};
    }
    if (name == "begin") return {matrix()};
    fail(fmt::format("has the unknown command \\{}", name));
  }

  Base symbol(const Symbol& symbol) const {
    switch (symbol.kind) {
      case Kind::variable: return {element("mi", symbol.text)};
      case Kind::upright: return {fmt::format("<mi mathvariant=\"normal\">{}</mi>", symbol.text)};
      case Kind::function: return {element("mi", symbol.text), Kind::function};
      case Kind::limits: return {fmt::format("<mo movablelimits=\"true\">{}</mo>", symbol.text), Kind::limits};
      default: break;
    }
    const std::string_view text = symbol.text;
    return text == "±" || text == "∓" ? operation(symbol.text) : Base{element("mo", text), symbol.kind};
  }

  std::string fraction(bool small) {
    const std::string above = argument(), below = argument(), all = element("mfrac", above + below);
    return small ? "<mstyle displaystyle=\"false\" scriptlevel=\"0\">" + all + "</mstyle>" : all;
  }

  static std::string unbroken(std::string_view words) {
    std::string all;
    for (const char c : escaped(words)) all += c == ' ' ? "\u00a0" : std::string(1, c);
    return all;
  }

  /// \mathrm: names and units such as N\,m and kg, whose letters belong together.
  std::string units() {
    Reader inside(words());
    std::string all;
    while (!inside.rest_.empty()) {
      if (!is_letter(inside.rest_.front())) {
        all += inside.scripted();
        continue;
      }
      const std::string letters = upright(inside.take_while(is_letter));
      all += inside.take("^") ? element("msup", letters + inside.argument()) : letters;
    }
    return element("mrow", all);
  }

  /// \mathrel{+}= is one sign.
  std::string relation() {
    std::string sign(words());
    skip_blanks();
    if (take("=")) sign += "=";
    return element("mo", escaped(sign));
  }

  std::string delimiter(const std::string& attributes) {
    skip_blanks();
    if (take("\\|")) return fence("‖", attributes);
    if (rest_.empty()) fail("lacks a delimiter");
    const std::string_view mark = take_character();
    return mark == "." ? "" : fence(mark, attributes);
  }

  std::string fenced(const std::string& closing, const std::string& attributes) {
    std::string all = delimiter(attributes);
    all += row();
    if (!take_command(closing)) fail(fmt::format("lacks \\{}", closing));
    return element("mrow", all + delimiter(attributes));
  }

  std::string matrix() {
    if (const std::string_view name = words(); name != "bmatrix")
      fail(fmt::format("has a {}, and only bmatrix is known,", name));
    std::string rows, cells;
    do {
      do cells += element("mtd", row());
      while (take("&"));
      rows += element("mtr", cells);
      cells.clear();
    } while (take("\\\\"));
    if (!take_command("end")) fail("lacks \\end");
    words();
    return element("mrow", fence("[", "") + element("mtable", rows) + fence("]", ""));
  }

  std::string_view whole_, rest_;
  bool operand_ = false;  // whether a sign that comes next has an operand before it
};

constexpr auto math_namespace = "http://www.w3.org/1998/Math/MathML";

std::string math(const std::string& inside, const char* attributes) {
  return fmt::format("<math xmlns=\"{}\"{}>{}</math>", math_namespace, attributes, inside);
}

}  // namespace

std::string inline_mathml(std::string_view latex) { return math(Reader(latex).whole(), ""); }

std::string display_mathml(std::string_view latex) {
  std::string all;
  for (const Reader::Part& part : Reader(latex).parts())
    all += math(part.markup, part.begins_statement && !all.empty() ? " displaystyle=\"true\" class=\"statement\""
                                                                   : " displaystyle=\"true\"");
  return all;
}

}  // namespace byhand::site
