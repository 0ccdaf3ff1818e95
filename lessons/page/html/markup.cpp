#include "lessons/page/html/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/html/code_html.hpp"
#include "lessons/page/html/variables.hpp"

namespace byhand::site {
namespace {

/// The N of "(N)" at the beginning of `words`, if N is an equation of the article; else 0.
int equation_at(std::string_view words) {
  const size_t end = words.find_first_not_of("0123456789", 1);
  if (end == std::string_view::npos || end == 1 || end > 3 || words[end] != ')' || words[1] == '0') return 0;
  const int number = std::stoi(std::string(words.substr(1, end - 1)));
  return number <= course::article_equations ? number : 0;
}

/// Converts marks from left to right. A mark without a partner is a character like any other.
class Inline {
 public:
  Inline(std::string_view words, Links links) : words_(words), links_(links), variables_(variables_in(words)) {}

  std::string html() {
    while (at_ < words_.size())
      if (!code() && !span("**", "strong") && !span("*", "em") && !equation() && !below() && !raised() &&
          !variable()) {
        if (words_[at_] == ' ') end_word();
        all_ += escaped(words_.substr(at_, 1));
        if (words_[at_++] == ' ') word_ = {all_.size(), at_};
      }
    end_word();
    return all_;
  }

 private:
  /// "−λ|d|/h" stays in one line, where its letters alone would let it break; what is longer than a phone may.
  void end_word() {
    const std::string_view word = words_.substr(word_.from, at_ - word_.from);
    const bool short_enough = word.size() <= 36 && word.find(' ') == std::string_view::npos;
    if (word_.variables == 0 || word_.variables == word.find_last_not_of(".,:;)") + 1 || !short_enough) return;
    all_.insert(word_.begin, "<span class=\"whole\">");
    all_ += "</span>";
  }

  std::string_view rest() const { return words_.substr(at_); }
  char before() const { return at_ == 0 ? ' ' : words_[at_ - 1]; }

  bool code() {
    if (!rest().starts_with('`')) return false;
    const auto end = words_.find('`', at_ + 1);
    if (end == std::string_view::npos) return false;
    all_ += command_html(words_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return true;
  }

  /// Opens where no blank follows and closes where none stands before, as in Markdown.
  bool span(std::string_view mark, const char* element) {
    if (!rest().starts_with(mark)) return false;
    const size_t from = at_ + mark.size();
    if (from >= words_.size() || words_[from] == ' ') return false;
    auto end = words_.find(mark, from);
    while (end != std::string_view::npos && words_[end - 1] == ' ') end = words_.find(mark, end + 1);
    if (end == std::string_view::npos || end == from) return false;
    all_ += fmt::format("<{0}>{1}</{0}>", element, Inline(words_.substr(from, end - from), links_).html());
    at_ = end + mark.size();
    return true;
  }

  bool equation() {
    // f(2) is a function of two, not equation (2).
    if (links_ == Links::none || !rest().starts_with('(') || std::isalnum(static_cast<unsigned char>(before())))
      return false;
    const int number = equation_at(rest());
    if (number == 0) return false;
    all_ += fmt::format("<a class=\"recall\" href=\"equations.html#equation-{0}\">({0})</a>", number);
    at_ = words_.find(')', at_) + 1;
    return true;
  }

  /// r_x: one letter below another; at_once is a name.
  bool below() {
    const auto letter = [&](size_t i) {
      const char c = i < words_.size() ? words_[i] : ' ';
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    if (!rest().starts_with('_') || at_ == 0 || !std::isalpha(static_cast<unsigned char>(before())) ||
        (at_ > 1 && letter(at_ - 2)) || !letter(at_ + 1) || words_[at_ + 1] == '_' || letter(at_ + 2))
      return false;
    all_ += fmt::format("<sub>{}</sub>", words_[at_ + 1]);
    at_ += 2;
    return true;
  }

  /// e^(−βt)
  bool raised() {
    const auto end = words_.find(')', at_);
    if (!rest().starts_with("^(") || before() == ' ' || end == std::string_view::npos) return false;
    all_ += "<sup>" + Inline(words_.substr(at_ + 2, end - at_ - 2), Links::none).html() + "</sup>";
    at_ = end + 1;
    return true;
  }

  /// JV: quantities are set as in a display.
  bool variable() {
    const auto found =
        std::find_if(variables_.begin(), variables_.end(), [&](const Variables& one) { return one.begin == at_; });
    if (found == variables_.end()) return false;
    all_ += variables_html(words_.substr(at_, found->end - at_));
    word_.variables += found->end - at_;
    at_ = found->end;
    return true;
  }

  std::string_view words_;
  Links links_;
  std::vector<Variables> variables_;
  size_t at_ = 0;
  std::string all_;
  struct Word {
    size_t begin = 0, from = 0;  // in the HTML and in the words
    size_t variables = 0;        // bytes of it
  } word_;
};

/// Calls `line` with each line, and with an empty one at the end.
template <class F>
void each_line(std::string_view words, const F& line) {
  for (size_t begin = 0; begin <= words.size();) {
    const size_t end = std::min(words.find('\n', begin), words.size());
    line(words.substr(begin, end - begin));
    begin = end + 1;
  }
  line("");
}

}  // namespace

std::string inline_html(std::string_view words, Links links) { return Inline(words, links).html(); }

std::string prose_html(std::string_view words) {
  std::string all, block;
  bool in_list = false;
  const auto close_block = [&] {
    if (!block.empty()) all += fmt::format("<{0}>{1}</{0}>", in_list ? "li" : "p", inline_html(block));
    block.clear();
  };
  const auto close_list = [&] {
    close_block();
    if (in_list) all += "</ul>";
    in_list = false;
  };
  each_line(words, [&](std::string_view line) {
    if (line.empty()) {
      close_list();
    } else if (line.starts_with("- ")) {
      close_block();
      if (!in_list) all += "<ul>";
      in_list = true;
      block = line.substr(2);
    } else {
      block += (block.empty() ? "" : " ") +
               std::string(line.substr(std::min(line.find_first_not_of(' '), line.size())));
    }
  });
  return all;
}

std::string plain_text(std::string_view words) {
  std::string all;
  each_line(words, [&](std::string_view line) {
    if (line.starts_with("- ")) line.remove_prefix(2);
    if (!line.empty() && !all.empty()) all += ' ';
    for (const char c : line)
      if (c != '*' && c != '`') all += c;
  });
  return all;
}

}  // namespace byhand::site
