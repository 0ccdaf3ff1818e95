#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/desk/expression.hpp"

namespace byhand::desk {

struct Token {
  enum class Is { name, number, sign, end };
  Is is = Is::end;
  std::string text;  // of a name as "ω1"; of a sign one of + - * / . x | ( ) [ ] { } , ^ ' = >= frac sqrt hat T
  Span where;
  bool spaced = false;  // a blank stands before it
};

/// The tokens of a line typed plainly or as LaTeX; wrappers that mean nothing (\left, \mathbf, $) are left out.
/// Throws Complaint at the character that it cannot read.
std::vector<Token> tokens(std::string_view line);

/// "omega_1", "w1", "\\omega_{1}" and "ω₁" as "ω1".
std::string canonical(std::string_view name);

}  // namespace byhand::desk
