#pragma once

#include <array>
#include <string_view>

namespace byhand::course {

/// Where the course displays an equation of the article for the first time.
struct EquationPlace {
  int lesson;
  std::string_view step;  // its label, "7b"
  std::string_view says;  // what the equation says
};

/// Equations (1) to (23), in this order.
extern const std::array<EquationPlace, 23> equation_places;

}  // namespace byhand::course
