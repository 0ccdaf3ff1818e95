#pragma once

#include <string>
#include <string_view>

namespace byhand::site {

/// The LaTeX that lessons use as MathML Core, which browsers and readers of EPUB typeset themselves. A display
/// whose parts are separated by \quad or \qquad becomes one <math> element for each part, so that a narrow page
/// can wrap between them. Throws tutor::LessonError with the formula and the place for a command that is not known
/// and for braces or delimiters without their partner.
std::string inline_mathml(std::string_view latex);
std::string display_mathml(std::string_view latex);

}  // namespace byhand::site
