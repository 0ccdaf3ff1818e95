#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "renderer/palette.hpp"

namespace byhand::pictures {

/// By their places among the curves of all lessons. The colours of the first eight are the easiest to tell apart.
inline constexpr std::array<std::string_view, 17> methods{"Gauss–Seidel, cold",
                                                          "Gauss–Seidel",
                                                          "RATTLE",
                                                          "conjugate sweeps",
                                                          "direct",
                                                          "XPBD",
                                                          "AVBD",
                                                          "generalised RK4",
                                                          "Jacobi",
                                                          "RK4",
                                                          "implicit midpoint",
                                                          "explicit Euler",
                                                          "conjugate gradients",
                                                          "accelerated gradient",
                                                          "symmetric Gauss–Seidel",
                                                          "conjugate sweeps to a tolerance",
                                                          "generalised Euler"};

/// The place of a method's curve, and so its colour and marker. One that is not listed comes after all others.
constexpr int place_of(std::string_view method) {
  return static_cast<int>(std::ranges::find(methods, method) - methods.begin());
}

inline renderer::Colour colour_of(std::string_view method) { return renderer::palette::series(place_of(method)); }

}  // namespace byhand::pictures
