// The last core step: what all laws say beside what was found.

#include <fmt/format.h>

#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/law.hpp"

namespace byhand::failures {
namespace {

using laws::Family;
using laws::Law;

constexpr std::array<const char*, 5> families{"too few iterations", "the correction overshoots",
                                              "the step is too large", "the model is too soft",
                                              "the rows are wrong"};

/// A limit: of which law, of what and where; what the law says and what was found.
struct Line {
  int law;
  Family family;
  std::string name, quantity, unit, setting;
  double predicted, tolerance, measured;
  bool first;  // of its law
};

std::vector<Line> lines(const Page& page) {
  std::vector<Line> lines;
  std::vector<laws::Boundary> boundaries;
  for (const Law& law : laws::all())
    for (const laws::Boundary& boundary : law.boundaries) {
      lines.push_back({law.number, law.family, law.name, boundary.quantity, boundary.unit, boundary.setting,
                       boundary.predicted, boundary.tolerance, 0, &boundary == &law.boundaries.front()});
      boundaries.push_back(boundary);
    }
  const std::vector<double> measured =
      page.side_by_side(static_cast<int>(boundaries.size()), [&](int i) { return boundaries[i].measured(); });
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].measured = measured[i];
  return lines;
}

bool is_within(const Line& line) {
  const double scale = line.predicted == 0 ? 1 : std::abs(line.predicted);
  return std::abs(line.measured - line.predicted) <= line.tolerance * scale;
}

/// All limits as CSV.
std::string data_of(const std::vector<Line>& lines) {
  std::string data = "law,quantity,unit,setting,predicted,measured,tolerance\n";
  for (const Line& line : lines)
    data += fmt::format("{},\"{}\",{},\"{}\",{:.6g},{:.6g},{:.3g}\n", line.law, line.quantity, line.unit,
                        line.setting, line.predicted, line.measured, line.tolerance);
  return data;
}

/// How far what was measured lies from what the law predicts, by law. Limits that a law predicts as 0 are left
/// out.
Chart deviations(const std::vector<Line>& lines) {
  std::vector<Tick> numbers;
  for (const Line& line : lines)
    if (line.first)  // two digits each: every second is named, or they would touch
      numbers.push_back({static_cast<double>(line.law), line.law % 2 == 1 ? std::to_string(line.law) : ""});
  Chart chart{.x = {.label = "law", .ticks = numbers}, .y = {.label = "measured / predicted − 1 (%)"}};
  for (std::size_t family = 0; family < families.size(); ++family) {
    Curve curve{.label = families[family], .style = CurveStyle::markers};
    for (const Line& line : lines) {
      if (static_cast<std::size_t>(line.family) != family || !(line.predicted > 0)) continue;
      curve.x.push_back(line.law);
      curve.y.push_back(100 * (line.measured / line.predicted - 1));
      curve.point_names.push_back(line.setting);
    }
    chart.curves.push_back(std::move(curve));
  }
  // Over the settings of each law: from quartile to quartile, and a ring at the median.
  Curve quartiles{.colour = palette::ink},
      medians{.label = "median and quartiles", .style = CurveStyle::markers, .colour = palette::ink};
  for (auto begin = lines.begin(); begin != lines.end();) {
    const auto end = std::find_if(begin, lines.end(), [&](const Line& line) { return line.law != begin->law; });
    std::vector<double> all;
    for (auto line = begin; line != end; ++line)
      if (line->predicted > 0) all.push_back(100 * (line->measured / line->predicted - 1));
    std::sort(all.begin(), all.end());
    const auto at = [&](double share) {
      return all[static_cast<std::size_t>(std::lround(share * static_cast<double>(all.size() - 1)))];
    };
    if (!all.empty()) {
      const double law = begin->law;
      quartiles.x.insert(quartiles.x.end(), {law, law, law});
      quartiles.y.insert(quartiles.y.end(), {at(0.25), at(0.75), NAN});
      medians.x.push_back(law);
      medians.y.push_back(at(0.5));
    }
    begin = end;
  }
  chart.curves.push_back(std::move(quartiles));
  chart.curves.push_back(std::move(medians));
  chart.references.push_back({.value = 0, .label = "as predicted"});
  return chart;
}

std::string with_unit(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : say("@ (@)", quantity, unit);
}

/// One line for each law, its first setting.
void draw_table(Canvas& canvas, const std::vector<Line>& lines, const Rectangle& frame) {
  struct Row {
    std::string law, what, predicted, measured;
    int family;
  };
  std::vector<Row> rows;
  for (const Line& line : lines)
    if (line.first)
      rows.push_back({std::to_string(line.law), say("@: @", with_unit(line.quantity, line.unit), line.setting),
                      course::number(line.predicted, 3), course::number(line.measured, 3),
                      static_cast<int>(line.family)});
  const double height = std::min(32.0, frame.height / (static_cast<double>(rows.size()) + 1));
  const double dot = frame.x + 6, law = dot + 34, what = law + 10, measured = frame.right(),
               predicted = measured - 100;
  double size = 15;
  for (const Row& row : rows) {
    const double width = canvas.measure({0, 0}, row.what, {.size = size}).width;
    size = std::min(size, size * (predicted - 86 - what) / width);
  }
  double y = frame.top() - height / 2;
  const auto put = [&](double x, const std::string& words, Anchor anchor, bool bold = false) {
    canvas.text({x, y}, words, {.size = size, .anchor = anchor, .bold = bold});
  };
  put(law, "law", Anchor::right, true);
  put(what, "what and where", Anchor::left, true);
  put(predicted, "predicted", Anchor::right, true);
  put(measured, "measured", Anchor::right, true);
  for (const Row& row : rows) {
    y -= height;
    canvas.line({frame.x, y + height / 2}, {frame.right(), y + height / 2}, {palette::grid, 1});
    canvas.mark({dot, y}, series_mark(row.family), palette::series(row.family), 8);
    put(law, row.law, Anchor::right);
    put(what, row.what, Anchor::left);
    put(predicted, row.predicted, Anchor::right);
    put(measured, row.measured, Anchor::right);
  }
}

}  // namespace

void all_laws(const Setting&, Page& page) {
  const std::vector<Law> laws = laws::all();
  const std::vector<Line> all = lines(page);
  double worst = 0;
  for (const Line& line : all) worst = std::max(worst, std::abs(line.measured / line.predicted - 1));

  page.text(
      R"(The @ laws of the course and their limits. Other lessons cite them by number or name; their derivations are at
      the heads of the files in `lessons/laws`.)",
      laws.size());
  std::vector<std::vector<std::string>> rows;
  for (const Law& law : laws)
    rows.push_back({std::to_string(law.number), law.name, law.sentence, law.formula,
                    families[static_cast<std::size_t>(law.family)]});
  page.table({"", "law", "what it says", "limit", "nearest family"}, rows);
  page.text(
      R"(A law is worth what it predicts. So each is tested at several settings: the number from its derivation
      stands beside the number from runs; a limit is found by bisection, between runs on either side of it.)");
  page.figure(
      "all_laws",
      say(R"(@ limits of @ laws. Left: how far each measured limit lies from the predicted one, with the median
                  and quartiles of each law. Right: one setting of each law. All limits are in the figure's data.)",
          all.size(), laws.size()),
      [all](Canvas& canvas) {
        const auto [left, right] = canvas.page().inset(14).panels(0.4, 16);
        renderer::draw(canvas, deviations(all), left.inset(0, 24));
        draw_table(canvas, all, right.lowered(14));
      },
      data_of(all));
  std::string outside;
  for (const Line& line : all)
    if (!is_within(line)) outside += say("@@: @", outside.empty() ? "" : "; ", line.law, line.setting);
  page.claim("limits that lie within their tolerance" + (outside.empty() ? outside : say(" (not: @)", outside)),
             static_cast<double>(std::count_if(all.begin(), all.end(), is_within)), "1",
             is(static_cast<double>(all.size()), "the laws", absolute(0)));
  page.measure("largest deviation of a measured limit from its law", 100 * worst, "%");
}

}  // namespace byhand::failures
