#include "lessons/page/items.hpp"

#include <cmath>

namespace byhand::course {

const renderer::Chart* chart_of(const Figure& figure) {
  if (const auto* clocked = std::get_if<TimedChart>(&figure.picture)) return &clocked->chart();
  return std::get_if<renderer::Chart>(&figure.picture);
}

bool Tolerance::met(double expected, double measured) const {
  if (!std::isfinite(expected) || !std::isfinite(measured)) return false;
  switch (kind) {
    case Kind::absolute: return std::abs(measured - expected) <= size;
    case Kind::relative: return std::abs(measured - expected) <= size * std::abs(expected);
    case Kind::at_most: return measured <= expected;
    case Kind::at_least: return measured >= expected;
  }
  return false;
}

}  // namespace byhand::course
