#pragma once

#include <string>
#include <string_view>

namespace byhand::site {

/// A step's HTML in which the symbols of its formulas have a class for the colour that they have in its pictures:
/// λ becomes <mi class="force"> where a picture in the step writes λ in the colour of forces.
std::string with_colours(std::string_view html);

}  // namespace byhand::site
