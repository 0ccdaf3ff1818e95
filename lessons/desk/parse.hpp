#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/desk/vocabulary.hpp"

namespace byhand::desk {

/// One side of a line: an expression, or the parts of J.
struct Side {
  std::vector<Expression> parts;  // one, or those between [ ]
  bool row = false;               // in [ ]
  Span where;
};

/// A line: what stands before the first "=", and each side behind one.
struct Line {
  std::string head;  // "C", "C2", "dC", "dC2", "J", "J2", a name, or nothing: the line goes on with the one before
  Span head_where;
  std::vector<Side> sides;
  bool inequality = false;  // ends in >= 0
};

/// Throws Complaint at the character where the line cannot be read.
Line parse(std::string_view line, const Vocabulary& words);
/// A single expression.
Expression parse_expression(std::string_view text, const Vocabulary& words);

}  // namespace byhand::desk
