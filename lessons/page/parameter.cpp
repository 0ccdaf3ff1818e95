#include "lessons/page/parameter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lessons/page/typed_quantity.hpp"

namespace byhand::course {
std::string typed(double value) {
  std::string shortest = fmt::format("{}", value);
  const double reciprocal = std::round(1 / value);
  // 1/60 reads better than 0.016666666666666666; 0.2 better than 1/5.
  if (shortest.size() > 8 && std::abs(reciprocal) < 1e6 && 1 / reciprocal == value)
    return fmt::format("1/{:.0f}", reciprocal);
  return shortest;
}

std::string ParameterRecord::typed(double any) const {
  return choices.empty() ? course::typed(any) : choices[static_cast<size_t>(any)];
}

std::string ParameterRecord::allowed() const {
  if (!choices.empty()) return fmt::format("{}", fmt::join(choices, ", "));
  return fmt::format("{} … {}{}", course::typed(range.low), course::typed(range.high), integer ? ", whole" : "");
}

std::string ParameterRecord::described(double any) const {
  if (!choices.empty()) return fmt::format("{} = {}, one of {}: {}", name, typed(any), allowed(), meaning);
  return fmt::format("{} = {} [{}], from {} to {}: {}", name, typed(any), unit, course::typed(range.low),
                     course::typed(range.high), meaning);
}

void ParameterRecord::set(std::string_view text) {
  if (!choices.empty()) {
    const auto chosen = std::find(choices.begin(), choices.end(), text);
    if (chosen == choices.end())
      throw std::invalid_argument(fmt::format("{} = {} is none of its choices: {}", name, text, allowed()));
    value = static_cast<double>(chosen - choices.begin());
    return;
  }
  double read = 0;
  try {
    read = read_quantity(text, unit);
  } catch (const std::invalid_argument& bad) {
    throw std::invalid_argument(fmt::format("{}: {} wants a number from {} to {} [{}]", bad.what(), name,
                                            course::typed(range.low), course::typed(range.high), unit));
  }
  if (!(read >= range.low && read <= range.high))
    throw std::invalid_argument(fmt::format("{} = {} is out of range: {} goes from {} to {} [{}]", name, text,
                                            name, course::typed(range.low), course::typed(range.high), unit));
  if (integer && read != std::round(read))
    throw std::invalid_argument(fmt::format("{} = {} is not a whole number, and {} counts", name, text, name));
  value = read;
}

}  // namespace byhand::course
