#pragma once

#include <string>

#include "lessons/catalogue/methods.hpp"

namespace byhand {

/// C++ that steps a `scene` by one frame so, to be pasted into a program: the same numbers as here.
std::string code_of(const Setting& setting);

}  // namespace byhand
