#pragma once

namespace byhand {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double standard_gravity = 9.81;  // [m/s²], as Scene has it

constexpr double radians(double degrees) { return degrees / 180 * pi; }
constexpr double degrees(double radians) { return radians / pi * 180; }

}  // namespace byhand
