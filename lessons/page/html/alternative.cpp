#include "lessons/page/html/alternative.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <vector>

#include "lessons/page/chart_words.hpp"
#include "lessons/page/words.hpp"

namespace byhand::site {
namespace {

using course::number;
using renderer::Chart;

constexpr int digits = 3;
constexpr size_t most_parts = 4;
constexpr size_t most_letters = 260;

std::string short_list(const std::vector<std::string>& parts) {
  std::string all;
  for (size_t i = 0; i < std::min(parts.size(), most_parts); ++i) all += (i ? "; " : "") + parts[i];
  return parts.size() > most_parts ? fmt::format("{}; and {} more", all, parts.size() - most_parts) : all;
}

/// "h = 1/60 s: from 0 to 0.436", with the extremes where they lie between the ends.
std::string course(const renderer::Curve& curve) {
  std::vector<double> finite;
  for (const double y : curve.y)
    if (std::isfinite(y)) finite.push_back(y);
  const std::string name = curve.label.empty() ? "a curve: " : curve.label + ": ";
  if (finite.empty()) return name + "no finite value";
  const auto [least, most] = std::minmax_element(finite.begin(), finite.end());
  const double low = *least, high = *most, rounding = 1e-12 * std::max(std::abs(low), std::abs(high));
  const auto said = [&](double y) { return number(std::abs(y) < rounding ? 0 : y, digits); };
  const double first = finite.front(), last = finite.back();
  std::string words =
      name + (finite.size() == 1 ? said(first) : fmt::format("from {} to {}", said(first), said(last)));
  if (low < std::min(first, last) - rounding) words += fmt::format(", at least {}", said(low));
  if (high > std::max(first, last) + rounding) words += fmt::format(", at most {}", said(high));
  return words;
}

std::string label(const Chart& chart) {
  std::string words = chart.title.empty() ? "" : chart.title + ". ";
  words += fmt::format("Chart of {}{}",
                       chart.heat_map          ? chart.heat_map->label
                       : chart.y.label.empty() ? "values"
                                               : chart.y.label,
                       chart.x.label.empty() ? "" : " over " + chart.x.label);
  if (chart.heat_map && !chart.y.label.empty()) words += " and " + chart.y.label;
  std::vector<std::string> parts;
  if (chart.heat_map && chart.heat_map->classes.empty()) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : chart.heat_map->values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    if (low <= high) parts.push_back(fmt::format("from {} to {}", number(low, digits), number(high, digits)));
  }
  if (chart.heat_map)
    for (const auto& [name, cells] : course::cells_of_classes(*chart.heat_map))
      parts.push_back(fmt::format("{}: {}", name, course::several(cells, "cell")));
  std::vector<const renderer::Curve*> unnamed;
  for (const renderer::Curve& curve : chart.curves) {
    if (curve.y.empty()) continue;
    if (curve.label.empty())
      unnamed.push_back(&curve);
    else
      parts.push_back(course(curve));
  }
  if (unnamed.size() == 1) parts.push_back(course(*unnamed.front()));
  if (unnamed.size() > 1)
    parts.push_back(course::several(static_cast<long>(unnamed.size()), "line") + " without a name");
  for (const renderer::Bars& bars : chart.bars)
    for (size_t i = 0; i < std::min(bars.values.size(), chart.bar_names.size()); ++i)
      parts.push_back(fmt::format("{}{}{}: {}", chart.bar_names[i], bars.label.empty() ? "" : ", ", bars.label,
                                  number(bars.values[i], digits)));
  return parts.empty() ? words : words + ". " + short_list(parts);
}

/// The letters of an element without its tags.
std::string letters(std::string_view inside) {
  std::string all;
  for (size_t i = 0; i < inside.size(); ++i) {
    if (inside[i] == '<')
      i = std::min(inside.find('>', i), inside.size());
    else
      all += inside[i];
  }
  for (const auto& [entity, letter] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    for (auto at = all.find(entity); at != std::string::npos; at = all.find(entity, at + 1))
      all.replace(at, std::string_view(entity).size(), letter);
  return all;
}

/// Whether a text is the next line of the one before: it begins with a word in small letters.
bool goes_on(const std::string& text) {
  return text.size() > 2 && std::islower(static_cast<unsigned char>(text[0])) != 0 &&
         std::islower(static_cast<unsigned char>(text[1])) != 0;
}

/// What is written in a picture, without the numbers of its axes.
std::string written(std::string_view svg) {
  constexpr std::string_view numbers = "0123456789.,−-·+ ⁰¹²³⁴⁵⁶⁷⁸⁹⁻½¼¾/π°";
  std::vector<std::string> texts;
  std::string all;
  for (auto at = svg.find("<text"); at != std::string_view::npos; at = svg.find("<text", at + 1)) {
    const auto begin = svg.find('>', at) + 1;
    const std::string text = letters(svg.substr(begin, svg.find("</text>", begin) - begin));
    if (text.find_first_not_of(numbers) == std::string::npos || std::count(texts.begin(), texts.end(), text))
      continue;
    texts.push_back(text);
    if (all.size() + text.size() > most_letters) return all + " …";
    all += (all.empty() ? "" : goes_on(text) ? " " : "; ") + text;
  }
  return all;
}

Alternative of_drawing(const char* where, std::string_view svg) {
  const std::string texts = written(svg);
  return {texts.empty() ? "" : fmt::format("{}: {}", where, texts)};
}

}  // namespace

Alternative alternative(const course::Figure& figure, std::string_view svg) {
  if (const auto* chart = std::get_if<Chart>(&figure.picture))
    return {label(*chart), course::chart_in_words(*chart)};
  if (std::holds_alternative<course::Drawing>(figure.picture)) return of_drawing("Written in it", svg);
  return {"Chart of measured running times, different in every run; the numbers are in the CSV file."};
}

Alternative alternative(const course::Sequence&, std::string_view svg) {
  return of_drawing("Written in the film's first picture", svg);
}

}  // namespace byhand::site
