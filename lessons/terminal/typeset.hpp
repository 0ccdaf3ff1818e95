#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace byhand::course {

/// Properties of a terminal.
struct Style {
  int width = 80;        // columns
  bool colours = false;  // whether to write escape sequences for colour and weight
  int rows = 24;
  bool cursor = false;  // whether escape sequences move the cursor: animations
  bool plain = false;   // for screen readers: no pictures, no box characters
};

enum class Tone { title, quiet, formula, code, good, bad, question };

/// Adds the escape sequences of a tone; none without colours.
std::string toned(std::string_view words, Tone tone, const Style& style);

/// Width in terminal columns: wide characters count two, combining marks and escape sequences none.
int display_width(std::string_view words);

/// Pads the words with blanks to `width` columns.
std::string padded(std::string_view words, int width);

/// Converts *emphasis*, **strong** and `code` to escape sequences.
std::string with_emphasis(std::string_view words, const Style& style);

/// Wraps Markdown paragraphs and lists ("- ") at `style.width` columns, indented by `indent` blanks. Ends with a
/// newline.
std::string wrapped(std::string_view words, const Style& style, int indent = 0);

/// Keeps the lines, indented by `indent` blanks. A line longer than `style.width` continues on the next, four
/// blanks further in.
std::string folded(std::string_view lines, const Style& style, int indent);

/// Rows in columns, each as wide as its widest cell, two blanks apart.
std::string table(const std::vector<std::vector<std::string>>& rows, int indent = 0);

/// The same within `style.width` columns: cells of the widest columns continue on further lines. Cells may use
/// *emphasis*.
std::string table(const std::vector<std::vector<std::string>>& rows, const Style& style, int indent = 0);

}  // namespace byhand::course
