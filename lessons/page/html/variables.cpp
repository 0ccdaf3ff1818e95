#include "lessons/page/html/variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "renderer/code_points.hpp"
#include "renderer/mathematics.hpp"

namespace byhand::site {
namespace {

struct Sign {
  char32_t code;
  std::size_t begin, end;  // bytes
};

std::vector<Sign> signs_of(std::string_view utf8) {
  std::vector<Sign> all;
  for (std::string_view rest = utf8; !rest.empty();) {
    const std::size_t begin = utf8.size() - rest.size();
    const char32_t code = renderer::next_code_point(rest);
    all.push_back({code, begin, utf8.size() - rest.size()});
  }
  return all;
}

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_small(char32_t c) { return c >= U'a' && c <= U'z'; }
bool is_capital(char32_t c) { return c >= U'A' && c <= U'Z'; }

bool relates(char32_t c) { return std::u32string_view(U"=≠≤≥<>≈+−·×/|").find(c) != std::u32string_view::npos; }
bool is_letter_or_digit(char32_t c) { return is_small(c) || is_capital(c) || is_digit(c); }
bool goes_on(char32_t c) { return is_letter_or_digit(c) || c == U'_'; }  // as a name in a program does
bool is_raised(char32_t c) { return c == U'⁻' || c == U'²' || c == U'³' || c == U'¹' || (c >= U'⁰' && c <= U'⁹'); }
bool is_unit(std::u32string_view word) {
  constexpr std::array<std::u32string_view, 7> units{U"m", U"s", U"N", U"J", U"W", U"kg", U"rad"};
  return std::find(units.begin(), units.end(), word) != units.end();
}

/// Of one letter that a label would take for a quantity: whether a sentence has it for something else.
class InEnglish {
 public:
  explicit InEnglish(const std::vector<Sign>& signs) {
    for (const Sign& sign : signs) text_ += sign.code;
  }

  bool says_other(std::size_t i) const {
    const char32_t letter = text_[i], before = at(i, -1), after = at(i, 1), next = at(i, 2);
    const bool article = (letter == U'A' || letter == U'a') && after == U' ' && !relates(next);
    const bool step = letter >= U'a' && letter <= U'f' && is_digit(before);
    const bool dimension = letter == U'D' && is_digit(before);
    const bool language = letter == U'C' && after == U'+' && next == U'+';
    const bool abbreviation =
        (after == U'.' && is_small(next)) || (before == U'.' && is_small(at(i, -2)) && is_small(letter));
    const bool initial = is_capital(letter) && after == U'.' && next == U' ' && is_capital(at(i, 3));
    const bool name = before == U'_' || (after == U'_' && !(is_letter_or_digit(next) && !goes_on(at(i, 3))));
    return name || article || step || dimension || language || abbreviation || initial || in_product_of_units(i);
  }

 private:
  char32_t at(std::size_t i, int by) const {
    const auto place = static_cast<std::ptrdiff_t>(i) + by;
    return place >= 0 && place < static_cast<std::ptrdiff_t>(text_.size()) ? text_[static_cast<std::size_t>(place)]
                                                                           : U' ';
  }

  /// N·s/m, m²/s
  bool in_product_of_units(std::size_t i) const {
    if (!is_unit({&text_[i], 1})) return false;
    if (text_[i] == U's' && at(i, -1) == U'/' && at(i, -2) == U'1') return true;
    std::size_t after = i + 1;
    while (after < text_.size() && is_raised(text_[after])) ++after;
    if (after < text_.size() && (text_[after] == U'·' || text_[after] == U'/')) {
      std::size_t end = after + 1;
      while (end < text_.size() && is_small(text_[end])) ++end;
      if (is_unit(std::u32string_view(text_).substr(after + 1, end - after - 1))) return true;
    }
    if (i == 0 || (text_[i - 1] != U'·' && text_[i - 1] != U'/' && text_[i - 1] != U' ')) return false;
    std::size_t end = i - 1;
    while (end > 0 && is_raised(text_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && (is_small(text_[begin - 1]) || is_capital(text_[begin - 1]))) --begin;
    const std::u32string_view word = std::u32string_view(text_).substr(begin, end - begin);
    return is_unit(word) && (text_[i - 1] != U' ' || word.size() > 1);
  }

  std::u32string text_;
};

struct Accented {
  char32_t whole, letter;
  const char* accent;
};
constexpr const char *dot = "˙", *two_dots = "¨";
constexpr std::array accented{Accented{U'Ċ', U'C', dot},      Accented{U'ẋ', U'x', dot},
                              Accented{U'ẏ', U'y', dot},      Accented{U'ṅ', U'n', dot},
                              Accented{U'ẍ', U'x', two_dots}, Accented{U'ÿ', U'y', two_dots}};

}  // namespace

std::vector<Variables> variables_in(std::string_view prose) {
  const std::vector<Sign> signs = signs_of(prose);
  std::vector<renderer::LabelSign> label;
  bool power = false;  // of ten, behind which a unit stands as behind any number
  for (std::size_t i = 0; i < signs.size(); ++i) {
    power =
        is_raised(signs[i].code) && (power || (i > 1 && signs[i - 1].code == U'0' && signs[i - 2].code == U'1'));
    label.push_back({power ? U'0' : signs[i].code, 0});
  }
  const std::vector<bool> slanted = renderer::italics(label);
  const InEnglish english(signs);
  std::vector<Variables> all;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    std::size_t end = i;
    while (end < signs.size() && slanted[end]) ++end;
    if (end == i || (end == i + 1 && english.says_other(i))) continue;
    all.push_back({signs[i].begin, signs[end - 1].end});
    i = end - 1;
  }
  return all;
}

std::string variables_html(std::string_view letters) {
  const std::vector<Sign> signs = signs_of(letters);
  std::string all = "<math>";
  for (std::size_t i = 0; i < signs.size(); ++i) {
    std::string letter(letters.substr(signs[i].begin, signs[i].end - signs[i].begin));
    const char* accent = nullptr;
    for (const Accented& known : accented)
      if (known.whole == signs[i].code) {
        letter = std::string(1, static_cast<char>(known.letter));
        accent = known.accent;
      }
    if (i + 1 < signs.size() && (signs[i + 1].code == 0x307 || signs[i + 1].code == 0x308))
      accent = signs[++i].code == 0x307 ? dot : two_dots;
    const std::string base = fmt::format("<mi>{}</mi>", letter);
    all += accent ? fmt::format("<mover accent=\"true\">{}<mo stretchy=\"false\">{}</mo></mover>", base, accent)
                  : base;
  }
  return all + "</math>";
}

}  // namespace byhand::site
