// The last core step: what all laws say beside what was found.

#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/08_where_methods_fail/steps.hpp"
#include "renderer/canvas.hpp"
#include "solver/laws/law.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using namespace renderer;
using laws::Family;
using laws::Law;

constexpr std::array<const char*, 4> families{"too few iterations", "the correction overshoots",
                                              "the step is too large", "the rows are wrong"};

/// A law's number, quantity and setting; what it says and what was found.
struct Line {
  int law;
  Family family;
  std::string quantity, unit, setting;
  double predicted, tolerance, measured;
  bool first;  // of its law
};

std::vector<Line> lines(const Page& page) {
  std::vector<Line> lines;
  std::vector<laws::Boundary> boundaries;
  for (const Law& law : laws::all())
    for (const laws::Boundary& boundary : law.boundaries) {
      lines.push_back({law.number, law.family, boundary.quantity, boundary.unit, boundary.setting,
                       boundary.predicted, boundary.tolerance, 0, &boundary == &law.boundaries.front()});
      boundaries.push_back(boundary);
    }
  const std::vector<double> measured =
      page.side_by_side(static_cast<int>(boundaries.size()), [&](int i) { return boundaries[i].measured(); });
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].measured = measured[i];
  return lines;
}

Chart diagonal(const std::vector<Line>& lines) {
  Chart chart{.x = {.label = "predicted (each in its own unit)", .scale = Scale::logarithmic},
              .y = {.label = "measured", .scale = Scale::logarithmic}};
  double low = 1e300, high = 0;
  for (std::size_t family = 0; family < families.size(); ++family) {
    Curve curve{.label = families[family], .style = CurveStyle::markers};
    for (const Line& line : lines) {
      if (static_cast<std::size_t>(line.family) != family || !(line.predicted > 0)) continue;
      curve.x.push_back(line.predicted);
      curve.y.push_back(line.measured);
      curve.point_labels.push_back(line.first ? std::to_string(line.law) : "");
      low = std::min(low, line.predicted);
      high = std::max(high, line.predicted);
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.x.range = chart.y.range = std::pair(low / 2, high * 2);
  chart.curves.push_back(
      {.label = "as predicted", .x = {low / 2, high * 2}, .y = {low / 2, high * 2}, .style = CurveStyle::theory});
  return chart;
}

std::string with_unit(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : say("@ (@)", quantity, unit);
}

/// One line for each law, its first setting.
void draw_table(Canvas& canvas, const std::vector<Line>& lines, const Rectangle& frame) {
  std::vector<Line> first;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(first), [](const Line& line) { return line.first; });
  const double row = std::min(30.0, frame.height / (static_cast<double>(first.size()) + 1)), size = 0.5 * row;
  const double dot = frame.x + 8, law = dot + 40, quantity = law + 12, setting = quantity + 0.19 * frame.width,
               predicted = frame.right() - 0.13 * frame.width, measured = frame.right();
  double y = frame.top() - row / 2;
  const auto put = [&](double x, const std::string& words, Anchor anchor, bool bold = false) {
    canvas.text({x, y}, words, {.size = size, .anchor = anchor, .bold = bold});
  };
  put(law, "law", Anchor::right, true);
  put(quantity, "what", Anchor::left, true);
  put(setting, "where", Anchor::left, true);
  put(predicted, "predicted", Anchor::right, true);
  put(measured, "measured", Anchor::right, true);
  for (const Line& line : first) {
    y -= row;
    canvas.line({frame.x, y + row / 2}, {frame.right(), y + row / 2}, {palette::grid, 1});
    const int family = static_cast<int>(line.family);
    canvas.mark({dot, y}, series_mark(family), palette::series(family), 8);
    put(law, std::to_string(line.law), Anchor::right);
    put(quantity, with_unit(line.quantity, line.unit), Anchor::left);
    put(setting, line.setting, Anchor::left);
    put(predicted, tutor::number(line.predicted, 3), Anchor::right);
    put(measured, tutor::number(line.measured, 3), Anchor::right);
  }
}

}  // namespace

void all_laws(const Setting&, Page& page) {
  const std::vector<Law> laws = laws::all();
  const std::vector<Line> all = lines(page);
  double worst = 0;
  for (const Line& line : all) worst = std::max(worst, std::abs(line.measured / line.predicted - 1));

  page.text(
      "A law is worth what it foresees. Here all @ of them stand at once, each at several settings: what it says "
      "from a "
      "derivation, and what bisection finds without it, by running scenes on both sides until they meet. The "
      "derivations "
      "stand at the heads of the files in `solver/laws`.",
      laws.size());
  page.figure(
      "all_laws",
      say("@ boundaries of @ laws. Left: predicted against measured; numbers are the laws'. Right: one setting of "
          "each law. All are in the table below.",
          all.size(), laws.size()),
      [all](Canvas& canvas) {
        const auto [left, right] = canvas.page().inset(14).split_columns(0.43, 18);
        renderer::draw(canvas, diagonal(all), left.inset(0, 30));
        draw_table(canvas, all, right.inset(0, 10));
      });
  std::string list;
  for (const Law& law : laws)
    list +=
        say("- @, *@*: @. @\n", law.number, families[static_cast<std::size_t>(law.family)], law.name, law.formula);
  page.text("What they say:\n\n@", list);
  for (const Line& line : all)
    page.claim({.quantity = say("law @: @, @", line.law, line.quantity, line.setting),
                .unit = line.unit.empty() ? "1" : line.unit,
                .expected = line.predicted,
                .source = say("law B@", line.law),
                .measured = line.measured,
                .tolerance = line.predicted == 0 ? absolute(line.tolerance) : relative(line.tolerance)});
  page.measure("largest deviation of a measured boundary from its law", 100 * worst, "%");
}

}  // namespace byhand::failures
