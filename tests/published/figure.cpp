#include "tests/published/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace byhand::published {
namespace {

void print_row(const std::string& who, const std::string& value, const std::string& error,
               const std::string& seconds, const std::string& how) {
  const std::string row = fmt::format("    {:<26}{:>14}{:>9}{:>10}  {}", who, value, error, seconds, how);
  fmt::print("{}\n", row.substr(0, row.find_last_not_of(' ') + 1));
}

/// A number; nothing for `none`.
std::string text(double number, fmt::string_view format) {
  return std::isnan(number) ? "" : fmt::vformat(format, fmt::make_format_args(number));
}

double error(const Quantity& quantity, const Entry& entry) { return entry.value - quantity.exact; }
bool is_ours(const Entry& entry) { return !std::isnan(entry.bound); }
bool passes(const Quantity& quantity, const Entry& entry) {
  return !is_ours(entry) || std::abs(error(quantity, entry)) <= entry.bound;
}

void print(const Quantity& quantity) {
  fmt::print("\n");
  print_row(quantity.name, "value", "error", "time [s]", "");
  print_row("  exact", text(quantity.exact, "{:.7g}"), "", "", quantity.why);
  for (const Entry& entry : quantity.entries) {
    std::string how = entry.how;
    if (is_ours(entry))
      how += fmt::format(" ({} {:.2g})", passes(quantity, entry) ? "within" : "FAILS: not within", entry.bound);
    print_row("  " + entry.who, text(entry.value, "{:.7g}"), text(error(quantity, entry), "{:.1e}"),
              text(entry.seconds, "{:.2g}"), how);
  }
}

/// Who is nearest to the exact values, of the quantities for which others have published a value.
void print_nearest(const std::vector<Quantity>& quantities) {
  std::map<std::string, int> nearest;
  int count = 0;
  for (const Quantity& quantity : quantities) {
    std::vector<Entry> entries = quantity.entries;
    std::erase_if(entries, [](const Entry& entry) { return std::isnan(entry.value); });
    if (std::ranges::all_of(entries, is_ours)) continue;
    const auto distance = [&](const Entry& entry) { return std::abs(error(quantity, entry)); };
    const Entry& first = *std::ranges::min_element(entries, {}, distance);
    ++nearest[is_ours(first) ? "ours" : first.who];
    ++count;
  }
  if (count == 0) return;
  std::string names;
  for (const auto& [who, times] : nearest)
    names += fmt::format("{}{} {} of {}", names.empty() ? "" : ", ", who, times, count);
  fmt::print("\n  Nearest to the exact value: {}.\n", names);
}

}  // namespace

bool print(const Figure& figure) {
  fmt::print("{}\n  {}\n  Source: {}\n", figure.title, figure.definition, figure.source);
  bool kept = true;
  for (const Quantity& quantity : figure.quantities) {
    print(quantity);
    kept &= std::ranges::all_of(quantity.entries, [&](const Entry& entry) { return passes(quantity, entry); });
  }
  print_nearest(figure.quantities);
  fmt::print("\n");
  return kept;
}

}  // namespace byhand::published
