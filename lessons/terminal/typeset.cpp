#include "lessons/terminal/typeset.hpp"

#include <fmt/format.h>
#include <glib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <sstream>

#include "lessons/page/typed_quantity.hpp"
#include "lessons/page/words.hpp"

namespace byhand::course {
namespace {

constexpr char escape = '\033';
constexpr int narrowest_column = 8;

std::string_view code_of(Tone tone) {
  switch (tone) {
    case Tone::title: return "1;36";
    case Tone::quiet: return "2";
    case Tone::formula: return "1";
    case Tone::code: return "36";
    case Tone::good: return "32";
    case Tone::bad: return "31";
    case Tone::question: return "1;33";
  }
  return "0";
}

std::string indentation(int columns) { return std::string(static_cast<size_t>(std::max(0, columns)), ' '); }

/// Whether a word is a unit of physics, behind a number: "m²", "N·s,".
bool is_unit_word(std::string_view word) {
  while (!word.empty() && std::string_view(".,;:)]!?").find(word.back()) != std::string_view::npos)
    word.remove_suffix(1);
  return word == "%" || word == "°" || is_unit(word);
}

bool ends_in_number(std::string_view word) {
  if (word.ends_with('m') && word.find(escape) != std::string_view::npos)
    word = word.substr(0, word.rfind(escape));
  static constexpr std::array<std::string_view, 10> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return !word.empty() &&
         (std::isdigit(static_cast<unsigned char>(word.back())) ||
          std::any_of(raised.begin(), raised.end(), [&](auto sign) { return word.ends_with(sign); }));
}

/// The words of a paragraph; a number and its units are one word.
std::vector<std::string> unbreakable_words(const std::string& paragraph) {
  std::vector<std::string> all;
  std::istringstream words(paragraph);
  bool measured = false;
  for (std::string word; words >> word;) {
    measured = measured && is_unit_word(word);
    if (measured)
      all.back() += " " + word;
    else
      all.push_back(word);
    measured = measured || ends_in_number(word);
  }
  return all;
}

/// One paragraph, its lines behind `indent` blanks, the first one behind `first`.
std::string wrapped_paragraph(const std::string& paragraph, const Style& style, const std::string& first,
                              int indent) {
  std::string lines, line = first;
  int column = display_width(first);
  bool empty = true;
  for (const std::string& word : unbreakable_words(with_emphasis(paragraph, style))) {
    const int width = display_width(word);
    if (!empty && column + 1 + width > style.width) {
      lines += line + "\n";
      line = indentation(indent);
      column = indent;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
    column += width + (empty ? 0 : 1);
    empty = false;
  }
  return lines + line + "\n";
}

}  // namespace

std::string toned(std::string_view words, Tone tone, const Style& style) {
  if (!style.colours) return std::string(words);
  return fmt::format("{}[{}m{}{}[0m", escape, code_of(tone), words, escape);
}

int display_width(std::string_view words) {
  int columns = 0;
  for (const char* at = words.data(); at < words.data() + words.size();) {
    if (*at == escape) {
      while (at < words.data() + words.size() && *at != 'm') ++at;
      ++at;
      continue;
    }
    const gunichar character = g_utf8_get_char_validated(at, words.data() + words.size() - at);
    if (character == static_cast<gunichar>(-1) || character == static_cast<gunichar>(-2)) {
      ++columns;
      ++at;
      continue;
    }
    if (!g_unichar_iszerowidth(character)) columns += g_unichar_iswide(character) ? 2 : 1;
    at = g_utf8_next_char(at);
  }
  return columns;
}

std::string padded(std::string_view words, int width) {
  return std::string(words) + indentation(width - display_width(words));
}

std::string with_emphasis(std::string_view words, const Style& style) {
  struct Markup {
    std::string_view mark, on, off;
    bool keeps_mark_without_colours;
  };
  static const Markup markups[] = {{"`", "\033[36m", "\033[39m", true},
                                   {"**", "\033[1m", "\033[22m", false},
                                   {"*", "\033[3m", "\033[23m", false}};
  std::string shown;
  const Markup* open = nullptr;
  while (!words.empty()) {
    const Markup* found = nullptr;
    for (const Markup& markup : markups) {
      const bool could_open = !open && words.starts_with(markup.mark) && words.size() > markup.mark.size() &&
                              words[markup.mark.size()] != ' ' &&
                              words.find(markup.mark, markup.mark.size()) != std::string_view::npos;
      if (could_open || (open == &markup && words.starts_with(markup.mark))) {
        found = &markup;
        break;
      }
    }
    if (!found) {
      shown += words.front();
      words.remove_prefix(1);
      continue;
    }
    if (style.colours)
      shown += open ? found->off : found->on;
    else if (found->keeps_mark_without_colours)
      shown += found->mark;
    open = open ? nullptr : found;
    words.remove_prefix(found->mark.size());
  }
  return shown;
}

std::string wrapped(std::string_view words, const Style& style, int indent) {
  std::string all, paragraph, first = indentation(indent);
  int hanging = indent;
  const auto flush = [&] {
    if (!paragraph.empty()) all += wrapped_paragraph(paragraph, style, first, hanging);
    paragraph.clear();
    first = indentation(indent);
    hanging = indent;
  };
  std::istringstream lines{std::string(words)};
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(' ') == std::string::npos) {
      flush();
      if (!all.empty()) all += "\n";
    } else if (line.starts_with("- ")) {
      flush();
      first = indentation(indent) + "• ";
      hanging = indent + 2;
      paragraph = line.substr(2);
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line;
    }
  }
  flush();
  return all;
}

std::string folded(std::string_view lines, const Style& style, int indent) {
  std::string all;
  std::istringstream stream{std::string(lines)};
  for (std::string line; std::getline(stream, line);) {
    const auto text = line.find_first_not_of(' ');
    if (text == std::string::npos) {
      all += "\n";
      continue;
    }
    std::string shown = indentation(indent) + line.substr(0, text);
    const int further = display_width(shown) + 4;
    bool empty = true;
    for (size_t at = text; at < line.size();) {
      // A word with the blanks before it, so that columns stay aligned.
      const size_t end =
          std::min(line.find(' ', std::min(line.find_first_not_of(' ', at), line.size())), line.size());
      std::string word = line.substr(at, end - at);
      if (!empty && display_width(shown) + display_width(word) > style.width) {
        all += shown + "\n";
        shown = indentation(further);
        word.erase(0, word.find_first_not_of(' '));
      }
      shown += word;
      empty = false;
      at = end;
    }
    all += shown + "\n";
  }
  return all;
}

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::vector<int> column_widths(const Rows& rows) {
  std::vector<int> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  return widths;
}

}  // namespace

std::string table(const Rows& rows, const Style& style, int indent) {
  Rows shown = rows;
  for (auto& row : shown)
    for (std::string& cell : row) cell = with_emphasis(cell, style);
  std::vector<int> widths = column_widths(shown);
  const int gaps = 2 * static_cast<int>(widths.size()) - 2;
  while (std::accumulate(widths.begin(), widths.end(), indent + gaps) > style.width) {
    const auto widest = std::max_element(widths.begin(), widths.end());
    if (*widest <= narrowest_column) break;
    --*widest;
  }
  std::string all;
  for (const auto& row : rows) {
    Rows cells;  // the lines of each cell
    size_t height = 1;
    for (size_t i = 0; i < row.size(); ++i) {
      Style column = style;
      column.width = widths[i];
      const std::string cell = wrapped(row[i], column);
      const auto lines = lines_of(cell);
      cells.emplace_back(lines.begin(), lines.end());
      height = std::max(height, cells.back().size());
    }
    for (size_t line = 0; line < height; ++line) {
      std::string words = indentation(indent);
      for (size_t i = 0; i < cells.size(); ++i)
        words += padded(line < cells[i].size() ? cells[i][line] : "", widths[i] + 2);
      all += words.erase(words.find_last_not_of(' ') + 1) + "\n";
    }
  }
  return all;
}

std::string table(const std::vector<std::vector<std::string>>& rows, int indent) {
  const std::vector<int> widths = column_widths(rows);
  std::string all;
  for (const auto& row : rows) {
    std::string line = indentation(indent);
    for (size_t i = 0; i < row.size(); ++i) line += i + 1 < row.size() ? padded(row[i], widths[i] + 2) : row[i];
    all += line + "\n";
  }
  return all;
}

}  // namespace byhand::course
