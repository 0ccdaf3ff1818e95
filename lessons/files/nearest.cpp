#include "lessons/files/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace byhand::course {
namespace {

/// Levenshtein's distance: letters to insert, remove or replace.
size_t distance(std::string_view from, std::string_view to) {
  std::vector<size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (const char letter : from) {
    size_t diagonal = row[0]++;
    for (size_t i = 0; i < to.size(); ++i) {
      const size_t replaced = diagonal + (letter == to[i] ? 0 : 1);
      diagonal = row[i + 1];
      row[i + 1] = std::min({replaced, row[i] + 1, row[i + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view typed, const std::vector<std::string>& names) {
  std::string best;
  size_t fewest = typed.size() / 2 + 1;
  for (const std::string& name : names) {
    if (name.size() > typed.size() + fewest || typed.size() > name.size() + fewest) continue;
    const size_t changes = distance(typed, name);
    if (changes >= fewest) continue;
    fewest = changes;
    best = name;
  }
  return best;
}

std::string suggestion(std::string_view typed, const std::vector<std::string>& names) {
  const std::string name = nearest(typed, names);
  return name.empty() ? "" : " (do you mean " + name + "?)";
}

}  // namespace byhand::course
