#pragma once

#include <compare>
#include <string>
#include <string_view>

namespace byhand::course {

/// Exponents of metre, kilogram and second. Angles and shares have none.
struct Dimension {
  int metre = 0, kilogram = 0, second = 0;
  bool operator==(const Dimension&) const = default;
};

/// A number with or without a unit, as a person types it.
struct TypedQuantity {
  double value = 0;  // in SI units, radians and parts of one
  Dimension dimension = {};
  double number = 0;  // the same if every unit counted as 1
  bool has_number = false, has_pi = false, has_unit = false;
};

/// Reads "0.205", "0,205" (but not "1,205", which has two meanings), "1/5", "2.05e-1", "1.2·10⁻⁵", "pi/4", "√2",
/// "30°", "5 %", "0.205 m2", "20.5 cm²", "−0.5 N s", "kg·m/s", "200us". Throws std::invalid_argument with one
/// sentence, "… is not a number", unless the whole text is one finite quantity.
TypedQuantity read_typed(std::string_view text);

/// Reads a number without a unit.
double read_number(std::string_view text);

/// Whether `unit` is one of physics, such as "m²" or "N·s", and not one of the lesson, such as "boxes".
bool is_unit(std::string_view unit);

/// Reads a quantity in `unit`; a number without a unit counts in it, but not one with π in degrees.
double read_quantity(std::string_view text, const std::string& unit);

}  // namespace byhand::course
