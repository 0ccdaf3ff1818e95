#include "lessons/site/course/law_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/laws/law.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/page/words.hpp"
#include "lessons/site/lesson_page.hpp"

namespace byhand::site {
namespace {

using laws::Law;

constexpr auto measured_in = "08_where_methods_fail";

/// A link to the step of lesson 8 that tells of the law's family; its number alone where the site lacks the
/// lesson.
std::string step_of(const Law& law, const std::vector<Digest>& lessons) {
  const int family = static_cast<int>(law.family) + 1;
  const bool there =
      std::any_of(lessons.begin(), lessons.end(), [](const Digest& one) { return one.slug == measured_in; });
  const std::string words = fmt::format("8, {}", family);
  return there ? fmt::format("<a href=\"{}#step-{}\">{}</a>", page_of(measured_in), family, words) : words;
}

/// "h (s): 0.01 to 0.3, 12 settings within 3 %"
std::string domain(const Law& law) {
  std::string all;
  std::vector<std::string> told;
  for (const laws::Boundary& first : law.boundaries) {
    if (std::count(told.begin(), told.end(), first.quantity)) continue;
    told.push_back(first.quantity);
    double low = first.predicted, high = low, worst = 0;
    int settings = 0;
    for (const laws::Boundary& boundary : law.boundaries) {
      if (boundary.quantity != first.quantity) continue;
      low = std::min(low, boundary.predicted), high = std::max(high, boundary.predicted);
      worst = std::max(worst, boundary.tolerance);
      ++settings;
    }
    const std::string unit = first.unit.empty() ? "" : fmt::format(" ({})", first.unit);
    const std::string range = low == high
                                  ? course::number(low, 2)
                                  : fmt::format("{} to {}", course::number(low, 2), course::number(high, 2));
    all += fmt::format("{}{}{}: {}, {} within {} %", all.empty() ? "" : "; ", first.quantity, unit, range,
                       course::several(settings, "setting"), course::number(100 * worst, 2));
  }
  return all;
}

}  // namespace

std::string law_table(const std::vector<Digest>& lessons) {
  std::string rows;
  for (const Law& law : laws::all())
    rows += fmt::format(
        "<tr id=\"law-{0}\"><th scope=\"row\">{0}</th><td><strong>{1}</strong><br />{2}</td><td "
        "class=\"formula\">{3}</td>"
        "<td>{4}</td><td>{5}</td></tr>\n",
        law.number, escaped(law.name), inline_html(law.sentence), inline_html(law.formula),
        inline_html(domain(law), Links::none), step_of(law, lessons));
  return fmt::format(
      "<div class=\"scroll\"><table class=\"all-laws\"><thead><tr><th scope=\"col\">law</th><th "
      "scope=\"col\">says</th>"
      "<th scope=\"col\">limit</th><th scope=\"col\">measured for</th><th scope=\"col\">lesson, "
      "step</th></tr></thead>"
      "<tbody>\n{}</tbody></table></div>\n",
      rows);
}

}  // namespace byhand::site
