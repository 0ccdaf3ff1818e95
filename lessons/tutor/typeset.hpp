#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace byhand::tutor {

/// How a terminal shows words.
struct Style {
  int width = 80;        // columns
  bool colours = false;  // escape sequences for colour and weight are understood
  int picture_rows = 22;
};

enum class Tone { title, quiet, formula, code, good, bad, question };

/// The words in a tone; unchanged where there are no colours.
std::string toned(std::string_view words, Tone tone, const Style& style);

/// Columns that the words take on a terminal: wide characters two, combining marks and escape sequences none.
int display_width(std::string_view words);

/// The words and blanks after them up to `width` columns.
std::string padded(std::string_view words, int width);

/// Light Markdown (*emphasis*, **strong**, `code`) as a terminal shows it.
std::string with_emphasis(std::string_view words, const Style& style);

/// Breaks light Markdown into lines of at most `style.width` columns, each behind `indent` blanks. Blank
/// lines part paragraphs; lines that begin with "- " are items of a list. Ends with a newline.
std::string wrapped(std::string_view words, const Style& style, int indent = 0);

/// Lines as they are, each behind `indent` blanks; what is longer than `style.width` goes on below, four blanks
/// further in.
std::string folded(std::string_view lines, const Style& style, int indent);

/// Rows in columns, each as wide as its widest cell, two blanks apart.
std::string table(const std::vector<std::vector<std::string>>& rows, int indent = 0);

}  // namespace byhand::tutor
