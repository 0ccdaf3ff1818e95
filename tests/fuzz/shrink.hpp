#pragma once

#include <cstdint>
#include <optional>

#include "tests/fuzz/laws.hpp"

namespace byhand::fuzz {

/// A smaller scene that breaks the same law: fewer bodies and joints, at rest, of rounder numbers, as long as the
/// law stays broken.
template <class M>
Recipe<M> shrunk(Recipe<M> recipe, const Law<M>& law, const VelocityStepping& method);

/// A law that is broken, and the least scene that breaks it.
template <class M>
struct Failure {
  const char* law;
  std::string what;
  Recipe<M> scene;
};

/// Draws a scene, steps it up to a second and tries the laws that a name contains, all by default.
template <class M>
std::optional<Failure<M>> failure(std::uint64_t draw, const VelocityStepping& method, std::string_view name = "");

}  // namespace byhand::fuzz
