#pragma once

#include <string>

#include "lessons/desk/expression.hpp"

namespace byhand::desk {

/// "(p2 − p1) · (v2 + ω2 × r2)".
std::string characters(const Expression& e);
std::string latex(const Expression& e);
/// "p_{2}", "\omega_{1}".
std::string latex_name(const std::string& name);
/// An expression of C++ over the solver's types: scalars are T, vectors Linear<M, T>.
std::string cpp(const Expression& e);

}  // namespace byhand::desk
