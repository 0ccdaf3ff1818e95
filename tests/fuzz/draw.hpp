#pragma once

#include <cstdint>

#include "tests/fuzz/recipe.hpp"

namespace byhand::fuzz {

/// A scene of 1 to 12 moving bodies on the ground or hung from a nail, whose masses differ by up to 10⁶: a pile, a
/// column, or a chain with a body at its end. Nothing overlaps and every joint is closed. The same for the same
/// draw.
template <class M>
Recipe<M> drawn(std::uint64_t draw);

}  // namespace byhand::fuzz
