#include "lessons/engines/settings.hpp"

#include <algorithm>
#include <cstdio>

namespace byhand::engines {

double Knobs::value(const std::string& name, double shipped) const {
  const auto found =
      std::find_if(turned_.begin(), turned_.end(), [&](const auto& knob) { return knob.first == name; });
  return found == turned_.end() ? shipped : found->second;
}

std::string Knobs::words() const {
  std::string words;
  for (const auto& [name, value] : turned_) {
    char number[32];
    std::snprintf(number, sizeof number, "%.4g", value);
    words += (words.empty() ? "" : ", ") + name + " " + number;
  }
  return words.empty() ? "as shipped" : words;
}

}  // namespace byhand::engines
