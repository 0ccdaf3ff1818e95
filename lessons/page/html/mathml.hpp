#pragma once

#include <string>
#include <string_view>

namespace byhand::site {

/// The LaTeX that lessons use as MathML Core, which browsers and readers of EPUB typeset themselves. A display
/// becomes several <math> elements between which a narrow page can break its line: at \quad and \qquad, which
/// begin a statement (class="statement" from the second on), before every relation but a statement's first, and
/// before the terms of a long sum.
/// Throws course::LessonError with the formula and the place for a command that is not known and for braces or
/// delimiters without their partner.
std::string inline_mathml(std::string_view latex);
std::string display_mathml(std::string_view latex);

}  // namespace byhand::site
