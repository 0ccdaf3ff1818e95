#include "renderer/mathematics.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace byhand::renderer {
namespace {

using Words = std::u32string_view;
constexpr char32_t no_break_space = 0xa0;

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_small_greek(char32_t c) { return c >= U'α' && c <= U'ϖ'; }
bool is_latin(char32_t c) { return (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z'); }
bool is_letter(char32_t c) {
  return is_latin(c) || c == U'\xb5' || (c >= 0xc0 && c < 0x250 && c != U'×') || is_small_greek(c) ||
         (c >= 0x1e00 && c < 0x1f00);
}
bool combines(char32_t c) { return (c >= 0x300 && c <= 0x36f) || (c >= 0x20d0 && c <= 0x20ff); }

template <std::size_t n>
bool is_one_of(const std::array<Words, n>& list, Words word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// Products of quantities that look like words.
constexpr std::array<Words, 24> products{U"JV", U"JM",  U"gh", U"mg", U"mgh", U"mgL", U"gL",  U"vh",
                                         U"kw", U"RIR", U"RI", U"hv", U"hV",  U"hg",  U"mL",  U"rN",
                                         U"dt", U"ml",  U"mR", U"mr", U"mv",  U"mga", U"mgl", U"Fh"};
constexpr std::array<Words, 8> functions{U"arctan", U"sin", U"cos", U"tan", U"exp", U"log", U"ln", U"max"};
constexpr std::array<Words, 20> units{U"m",  U"s",  U"N",  U"J",  U"W",   U"kg",  U"mm", U"cm", U"km", U"ms",
                                      U"μs", U"μm", U"Hz", U"kN", U"rad", U"deg", U"mJ", U"kJ", U"ns", U"\xb5s"};

class LabelReader {
 public:
  explicit LabelReader(std::span<const LabelSign> signs) : signs_(signs), is_unit_(signs.size()) {
    for (const LabelSign& sign : signs) text_ += sign.code;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (is_digit(text_[i]) && (at(i + 1) == U' ' || at(i + 1) == no_break_space)) mark_units(i + 2);
      if (text_[i] == U')' && at(i + 1) == U' ') mark_units(i + 2);
      if (text_[i] == U'(' && (i == 0 || text_[i - 1] == U' ')) mark_bracket(i + 1);
    }
    // "kg/m²": a label that is a unit, not the name of a quantity.
    if (text_.find(U'/') != text_.npos) mark_if_unit(0, text_.size());
  }

  std::vector<bool> italics() const {
    std::vector<bool> slanted(text_.size());
    for (std::size_t i = 0; i < text_.size(); ++i) {
      std::size_t begin = i;
      const std::size_t end = end_of_word(i);
      if (begin == end) continue;
      for (const Words function : functions)
        if (Words(text_).substr(i, end - i).starts_with(function) && !is_latin(at(i + function.size())))  // "cost"
          begin = i + function.size();
      if (begin < end && !is_unit_[i] && is_quantity(begin, end))
        std::fill(slanted.begin() + std::ptrdiff_t(begin), slanted.begin() + std::ptrdiff_t(end), true);
      i = end - 1;
    }
    return slanted;
  }

 private:
  char32_t at(std::size_t i) const { return i < text_.size() ? text_[i] : U'\0'; }

  // Letters at one level with their combining marks; `begin` if there is none.
  std::size_t end_of_word(std::size_t begin) const {
    std::size_t end = begin;
    while (end < text_.size() && signs_[end].level == signs_[begin].level &&
           (is_letter(text_[end]) || (end > begin && combines(text_[end]))))
      ++end;
    return end;
  }
  bool is_unit(std::size_t begin, std::size_t end) const {
    return is_one_of(units, Words(text_).substr(begin, end - begin));
  }
  bool is_exponent(std::size_t i) const {
    return i < text_.size() && (signs_[i].level > 0 || Words(U"²³⁻¹").find(text_[i]) != Words::npos);
  }

  // Units from `i` on, "N·s/m". In "2 m·g" the m is a mass.
  void mark_units(std::size_t i) {
    for (std::size_t end = end_of_word(i); end > i && is_unit(i, end); end = end_of_word(i)) {
      std::size_t next = end;
      while (is_exponent(next)) ++next;
      if (at(next) == U'·' && end_of_word(next + 1) > next + 1 && !is_unit(next + 1, end_of_word(next + 1)))
        return;
      std::fill(is_unit_.begin() + std::ptrdiff_t(i), is_unit_.begin() + std::ptrdiff_t(end), true);
      if (Words(U"·/ ").find(at(next)) == Words::npos) return;
      i = next + 1;
    }
  }

  // A bracket that begins at `i`, if there is nothing but units and numbers in it, or a unit of its own: "(μs a
  // frame)".
  void mark_bracket(std::size_t i) {
    const std::size_t end = text_.find(U')', i);
    if (end != text_.npos) mark_if_unit(i, end);
    if (end_of_word(i) > i + 1) mark_units(i);
  }

  // The signs from `begin` to `end`, if they are nothing but units and numbers.
  void mark_if_unit(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t word = end_of_word(i);
      const bool belongs =
          word > i ? is_unit(i, word)
                   : is_digit(text_[i]) || is_exponent(i) || Words(U"·/√ ,°%").find(text_[i]) != Words::npos;
      if (!belongs) return;
      if (word > i) i = word - 1;
    }
    std::fill(is_unit_.begin() + std::ptrdiff_t(begin), is_unit_.begin() + std::ptrdiff_t(end), true);
  }

  // Whether digits stand before `i`, and a letter of the same level before them.
  bool ends_a_name(std::size_t i) const {
    std::size_t digits = i;
    while (digits > 0 && is_digit(text_[digits - 1])) --digits;
    return digits > 0 && digits < i && is_letter(text_[digits - 1]) &&
           signs_[digits - 1].level == signs_[i].level && signs_[digits].level == signs_[i].level;
  }

  bool is_quantity(std::size_t begin, std::size_t end) const {
    std::u32string word;
    for (std::size_t i = begin; i < end; ++i)
      if (!combines(text_[i])) word += text_[i];
    if (std::any_of(word.begin(), word.end(), is_small_greek)) return true;
    if (word.size() > 1) return is_one_of(products, word);
    if (word == U"T" && signs_[begin].level > 0) return false;
    if (begin > 0 && (text_[begin - 1] == U'\'' || text_[begin - 1] == U'’')) return false;  // the joint's
    if (is_digit(at(end)) && signs_[end].level == signs_[begin].level) return false;         // law B1
    if (ends_a_name(begin)) return false;                                                    // Box2D
    return word != U"a" || at(end) != U' ' || !is_letter(at(end + 1));                       // an article
  }

  std::span<const LabelSign> signs_;
  std::u32string text_;
  std::vector<bool> is_unit_;
};

}  // namespace

std::vector<bool> italics(std::span<const LabelSign> label) { return LabelReader(label).italics(); }

}  // namespace byhand::renderer
