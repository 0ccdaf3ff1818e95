#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "renderer/chart.hpp"
#include "renderer/labels.hpp"

namespace byhand::renderer {
namespace {

constexpr double title_size = 19, label_size = 17, tick_size = 16, small_size = 15;
constexpr double line_height = 1.3;
constexpr double curve_width = 2.6;
const Stroke axis_line{palette::muted, 1.4};
const Stroke grid_line{palette::grid, 1.2};
const Stroke faint_line{fade(palette::grid, 0.55), 1};

constexpr int shades = 129;  // of a map's colours: an odd number, so that one is in the middle

Colour shade_of(const HeatMap& map, int shade) {
  const double t = double(shade) / (shades - 1);
  return map.diverging ? palette::diverging(2 * t - 1) : palette::sequential(t);
}

// Maps the values of an axis to 0 … 1, from its left or lower end.
class Position {
 public:
  Position(const Axis& axis, std::pair<double, double> range)
      : scale_(axis.scale), reversed_(axis.reversed), low_(on(range.first)), high_(on(range.second)) {}

  double operator()(double value) const {
    const double share = (on(value) - low_) / (high_ - low_);
    return reversed_ ? 1 - share : share;
  }

 private:
  double on(double value) const {
    if (scale_ == Scale::linear) return value;
    return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
  }

  Scale scale_;
  bool reversed_;
  double low_, high_;
};

// An entry of the legend, or the label at the end of a curve.
struct Entry {
  std::string label;
  Colour colour;
  CurveStyle style;
  Mark mark;
  const Curve* curve;  // none: bars, classes of cells
};

bool has_line(CurveStyle s) {
  return s == CurveStyle::line || s == CurveStyle::line_and_markers || s == CurveStyle::theory ||
         s == CurveStyle::front;
}
Stroke stroke(const Entry& e) {
  if (e.style == CurveStyle::theory) return {e.colour, 2.0, Dash::dashed};
  return {e.colour, e.style == CurveStyle::front ? 9 : curve_width};
}
bool has_marks(CurveStyle s) { return s != CurveStyle::line && s != CurveStyle::theory && s != CurveStyle::front; }
// Styles that do not use the colours and markers of the series.
bool is_outside_series(CurveStyle s) { return s == CurveStyle::theory || s == CurveStyle::front; }
Colour own_colour(CurveStyle s, int place) {
  if (s == CurveStyle::theory) return palette::theory;
  return s == CurveStyle::front ? fade(palette::highlight, 0.4) : palette::series(place);
}

// The colour of a front is too pale for text.
Colour label_colour(const Entry& e) { return e.style == CurveStyle::front ? palette::ink : e.colour; }

class ChartDrawing {
 public:
  ChartDrawing(Canvas& canvas, const Chart& chart, const Rectangle& frame)
      : canvas_(canvas),
        chart_(chart),
        frame_(frame),
        ranges_(ranges(chart)),
        x_(chart.x, ranges_.x),
        y_(chart.y, ranges_.y) {}

  Rectangle layout() {
    list_entries();
    lay_out();
    return plot_;
  }
  Rectangle draw() {
    layout();
    draw_heat_map();
    draw_axes();
    draw_bars();
    draw_curves();
    draw_references();
    draw_texts();
    return plot_;
  }

 private:
  void list_entries();
  void lay_out();
  void choose_ticks();
  bool labels_fit_at_ends();
  void label_curves_directly();
  std::optional<Rectangle> place_beside(std::size_t entry) const;
  void sample_curves();
  Point legend_size() const;
  bool legend_fits_inside();
  double legend_rows(bool drawing);

  void draw_axes();
  void draw_heat_map();
  void draw_colour_bar();
  void draw_bars();
  void draw_curves();
  void draw_stems(const Curve& curve, Colour colour);
  void draw_end(const Entry& entry);
  void draw_marks(const Entry& entry);
  Point failure_place(double x, double y) const;
  Point draw_failure(double x, double y, Colour colour);
  void draw_references();
  void draw_texts();
  void draw_sample(const Point& at, const Entry& entry);
  void draw_end_labels();

  Point at(double x, double y) const { return {plot_.x + x_(x) * plot_.width, plot_.y + y_(y) * plot_.height}; }
  std::vector<Point> points(const Curve& curve, double until = std::numeric_limits<double>::infinity()) const {
    std::vector<Point> places;
    for (std::size_t i = 0; i < curve.x.size() && !(curve.x[i] > until); ++i) {
      if (curve.style == CurveStyle::front && i > 0) places.push_back(at(curve.x[i], curve.y[i - 1]));
      places.push_back(at(curve.x[i], curve.y[i]));
    }
    return places;
  }
  // The points that are drawn by now.
  std::vector<Point> shown(const Curve& curve) const {
    if (curve.style == CurveStyle::theory) return points(curve);
    std::vector<Point> places = points(curve, chart_.until);
    const std::size_t n = places.size();
    if (n == 0 || n >= curve.x.size() || !has_line(curve.style) || curve.style == CurveStyle::front) return places;
    const double share = (chart_.until - curve.x[n - 1]) / (curve.x[n] - curve.x[n - 1]);
    places.push_back(places.back() + share * (at(curve.x[n], curve.y[n]) - places.back()));
    return places;
  }
  bool is_growing() const { return chart_.until < std::numeric_limits<double>::infinity(); }
  // The rectangle of bar `i` of series `series`.
  Rectangle bar(std::size_t series, std::size_t i) const {
    const double n = double(chart_.bars.size()), width = 0.76 / n;
    const double left = double(i) - 0.38 + double(series) * width;
    const Point a = at(left, 0), b = at(left + 0.94 * width, chart_.bars[series].values[i]);
    return {a.x(), std::min(a.y(), b.y()), b.x() - a.x(), std::abs(b.y() - a.y())};
  }
  double width(std::string_view text, double size, bool bold = false) const {
    return canvas_.measure({0, 0}, text, {.size = size, .bold = bold}).width;
  }
  std::string wrapped(const std::string& text, double size, bool bold) const;
  double widest(const std::vector<Tick>& ticks) const {
    double most = 0;
    for (const Tick& tick : ticks) most = std::max(most, width(tick.label, tick_size));
    return most;
  }
  // The label of an axis with the power of ten factored out of its ticks.
  std::string axis_label(const Axis& axis, const Ticks& ticks) const {
    if (ticks.exponent == 0) return axis.label;
    const std::string power = "×" + number(std::pow(10.0, ticks.exponent), 1);
    return axis.label.empty() ? power : axis.label + "  " + power;
  }
  bool is_in_legend(const Entry& e) const {
    return !e.label.empty() && !direct_[std::size_t(&e - entries_.data())];
  }
  // Number of points of curves and bars inside a rectangle.
  double covered(const Rectangle& box) const;

  Canvas& canvas_;
  const Chart& chart_;
  Rectangle frame_, plot_;
  ChartRanges ranges_;
  Position x_, y_;
  Ticks x_ticks_, y_ticks_;
  std::vector<Entry> entries_;
  std::vector<std::vector<Point>> samples_;       // of the line or the marks of each entry, on the page
  std::vector<std::optional<Rectangle>> direct_;  // where entries are labelled beside their curves
  enum class Labelling { none, at_ends, inside, beside, above } labelling_ = Labelling::none;
  std::vector<double> end_heights_;
  Rectangle legend_;
  std::string title_, y_label_;
  std::vector<Point> failures_;
  struct Reason {
    Point at;
    std::string text;
    Colour colour;
  };
  std::vector<Reason> reasons_;  // why runs failed
};

void ChartDrawing::list_entries() {
  int next = 0;
  for (const Bars& bars : chart_.bars) {
    entries_.push_back(
        {bars.label, bars.colour.value_or(palette::series(next)), CurveStyle::line, Mark::square, nullptr});
    ++next;
  }
  if (chart_.heat_map)
    for (const CellClass& cell : chart_.heat_map->classes)
      entries_.push_back({cell.name, cell.colour, CurveStyle::line, Mark::square, nullptr});
  for (const Curve& curve : chart_.curves) {
    const int place = curve.place.value_or(next);
    entries_.push_back({curve.label, curve.colour.value_or(own_colour(curve.style, place)), curve.style,
                        series_mark(place), &curve});
    if (!is_outside_series(curve.style)) ++next;
  }
  direct_.resize(entries_.size());
}

// Wraps a text at the width of the frame.
std::string ChartDrawing::wrapped(const std::string& text, double size, bool bold) const {
  std::string lines, line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string longer =
        fmt::format("{}{}{}", line, line.empty() ? "" : " ", text.substr(begin, end - begin));
    if (!line.empty() && width(longer, size, bold) > frame_.width) {
      lines += line + "\n";
      line = text.substr(begin, end - begin);
    } else {
      line = longer;
    }
    begin = end + 1;
  }
  return lines + line;
}

void ChartDrawing::choose_ticks() {
  const auto given = [](const Axis& axis, std::pair<double, double> range) {
    Ticks result;
    for (const Tick& tick : axis.ticks)
      if (tick.value >= range.first && tick.value <= range.second) result.major.push_back(tick);
    return result;
  };
  if (!chart_.y.ticks.empty()) {
    y_ticks_ = given(chart_.y, ranges_.y);
  } else {
    y_ticks_ = ticks(chart_.y.scale, ranges_.y.first, ranges_.y.second, std::max(3, int(plot_.height / 44)));
  }
  if (!chart_.bar_names.empty() && chart_.x.ticks.empty()) {
    x_ticks_ = {};
    double room = 0;
    for (const std::string& name : chart_.bar_names) room = std::max(room, width(name, tick_size) + 10);
    const double step = plot_.width / (ranges_.x.second - ranges_.x.first);
    const int stride = std::max(1, int(std::ceil(room / step)));
    for (std::size_t i = 0; i < chart_.bar_names.size(); i += std::size_t(stride))
      x_ticks_.major.push_back({double(i), chart_.bar_names[i]});
  } else if (!chart_.x.ticks.empty()) {
    x_ticks_ = given(chart_.x, ranges_.x);
  } else {
    // As many ticks as fit without their labels touching.
    for (int most = std::max(4, int(plot_.width / 70)); most >= 2; --most) {
      x_ticks_ = ticks(chart_.x.scale, ranges_.x.first, ranges_.x.second, most);
      double nearest = plot_.width;
      for (std::size_t i = 0; i + 1 < x_ticks_.major.size(); ++i)
        nearest = std::min(nearest,
                           std::abs(x_(x_ticks_.major[i + 1].value) - x_(x_ticks_.major[i].value)) * plot_.width);
      if (nearest >= widest(x_ticks_.major) + 18) break;
    }
  }
}

void ChartDrawing::lay_out() {
  const auto lines = [](const std::string& text) {
    return text.empty() ? 0.0 : 1.0 + double(std::count(text.begin(), text.end(), '\n'));
  };
  title_ = wrapped(chart_.title, title_size, true);
  // The ticks depend on the height of the plot, which depends on the axis label with the ticks' power of ten:
  // starts from an estimate.
  plot_ = frame_.inset(40);
  choose_ticks();
  const auto& map = chart_.heat_map;
  double right = 10;
  const bool colour_bar = map && map->classes.empty();
  if (colour_bar)
    right = 36 + 10 + widest(ticks(map->scale, value_range(*map).first, value_range(*map).second, 6).major);
  y_label_ = wrapped(axis_label(chart_.y, y_ticks_), label_size, false);

  const double title_room = lines(title_) * line_height * title_size + (title_.empty() ? 0 : 6);
  const double y_label_room = lines(y_label_) * line_height * label_size;
  const bool map_label = colour_bar && !map->label.empty();
  const double top = title_room + std::max(y_label_room, map_label ? line_height * label_size : 0) + 8;
  const double bottom =
      1.55 * tick_size + (chart_.x.label.empty() && x_ticks_.exponent == 0 ? 0 : 1.35 * label_size) + 2;
  const auto place = [&](double extra_top) {
    const double left = widest(y_ticks_.major) + 10;
    plot_ = {frame_.x + left, frame_.y + bottom, frame_.width - left - right,
             frame_.height - top - bottom - extra_top};
    if (map && map->square) {
      const double cell = std::min(plot_.width / double(map->x.size()), plot_.height / double(map->y.size()));
      const double w = cell * double(map->x.size()), h = cell * double(map->y.size());
      plot_ = {plot_.x, plot_.top() - h, w, h};
    }
    if (!(plot_.width > 0 && plot_.height > 0))
      throw std::invalid_argument(fmt::format("A chart needs room for its labels; {} × {} points are too few.",
                                              frame_.width, frame_.height));
    choose_ticks();
  };
  place(0);
  if (!colour_bar) right = std::max(right, widest(x_ticks_.major) / 2 + 2);
  place(0);
  if (std::all_of(entries_.begin(), entries_.end(), [](const Entry& e) { return e.label.empty(); })) return;

  if (!map && labels_fit_at_ends()) {
    const double without_labels = right;
    for (const Entry& e : entries_) right = std::max(right, width(e.label, small_size + 1) + 22);
    place(0);
    labelling_ = Labelling::at_ends;
    if (labels_fit_at_ends()) return;  // on the narrower plot too
    right = without_labels;
    place(0);
  }
  if (!map) label_curves_directly();
  const auto many =
      std::count_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return is_in_legend(e); });
  if (many == 0) return;
  const Point legend = legend_size();
  if (!map && many > 8 && legend.x() < 0.4 * frame_.width && legend.y() < plot_.height) {
    labelling_ = Labelling::beside;
    right = std::max(right, legend.x() + 14);
    place(0);
    legend_ = {frame_.right() - legend.x(), plot_.top() - legend.y(), legend.x(), legend.y()};
    return;
  }
  labelling_ = !map && legend_fits_inside() ? Labelling::inside : Labelling::above;
  if (labelling_ == Labelling::above) place(legend_rows(false));
}

bool ChartDrawing::labels_fit_at_ends() {
  const double spacing = 1.22 * (small_size + 1);
  std::vector<std::pair<double, std::size_t>> ends;
  end_heights_.assign(entries_.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    if (e.label.empty()) continue;
    if (!e.curve || !has_line(e.style) || width(e.label, small_size + 1) > 0.3 * frame_.width) return false;
    std::size_t last = e.curve->x.size();
    while (last > 0 && !at(e.curve->x[last - 1], e.curve->y[last - 1]).allFinite()) --last;
    if (last == 0) return false;
    const Point end = at(e.curve->x[last - 1], e.curve->y[last - 1]);
    if (end.x() < plot_.x + 0.93 * plot_.width || end.x() > plot_.right() + 1 || end.y() < plot_.y - 1 ||
        end.y() > plot_.top() + 1)
      return false;
    ends.push_back({end.y(), i});
  }
  std::sort(ends.begin(), ends.end());
  // Moves overlapping labels up, then those above the top down; the mean of both shares the displacement.
  std::vector<double> up, down(ends.size());
  for (const auto& [y, i] : ends) up.push_back(std::max(y, up.empty() ? -1e9 : up.back() + spacing));
  for (std::size_t k = ends.size(); k-- > 0;)
    down[k] = std::min(ends[k].first, k + 1 == ends.size() ? plot_.top() : down[k + 1] - spacing);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const double y = 0.5 * (up[k] + down[k]);
    if (std::abs(y - ends[k].first) > 1.3 * spacing || y < plot_.y || y > plot_.top() + 4) return false;
    if (k > 0 && y - 0.5 * (up[k - 1] + down[k - 1]) < 0.98 * spacing) return false;
    end_heights_[ends[k].second] = y;
  }
  return true;
}

void ChartDrawing::sample_curves() {
  constexpr double apart = 4;  // points
  samples_.assign(entries_.size(), {});
  const double foot =
      std::clamp(at(0, chart_.y.scale == Scale::linear ? 0 : ranges_.y.first).y(), plot_.y, plot_.top());
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const Entry& e = entries_[k];
    if (!e.curve) continue;
    const auto sample = [&](const Point& from, const Point& to) {
      const Point step = to - from;
      const double length = std::min(step.norm(), 4000.0);
      for (double s = apart; s < length; s += apart) samples_[k].push_back(from + s / length * step);
    };
    const std::vector<Point> places = points(*e.curve);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i].allFinite()) continue;
      samples_[k].push_back(places[i]);
      if (e.style == CurveStyle::stems) sample(places[i], {places[i].x(), foot});
      if (i + 1 < places.size() && has_line(e.style) && places[i + 1].allFinite())
        sample(places[i], places[i + 1]);
    }
  }
}

// A place for the label beside its curve: free, and nearer to this curve than to any other. The clearest one.
std::optional<Rectangle> ChartDrawing::place_beside(std::size_t entry) const {
  constexpr double gap = 7, clear = 30;  // points from the curve; beyond `clear` others do not matter
  const Entry& e = entries_[entry];
  const std::vector<Point>& mine = samples_[entry];
  const double w = width(e.label, small_size), h = small_size;
  std::optional<Rectangle> best;
  double best_score = 0;
  const std::size_t stride = std::max<std::size_t>(1, mine.size() / 60);
  for (std::size_t i = stride; i + stride < mine.size(); i += stride) {
    const Point ahead = (mine[i + stride] - mine[i - stride]).normalized(), aside(-ahead.y(), ahead.x());
    for (const double side : {1.0, -1.0}) {
      const double away = gap + 0.5 * (std::abs(aside.x()) * w + std::abs(aside.y()) * h);
      const Point centre = mine[i] + side * away * aside;
      const Rectangle box{centre.x() - w / 2, centre.y() - h / 2, w, h};
      const Rectangle inside = plot_.inset(4);
      if (box.x < inside.x || box.right() > inside.right() || box.y < inside.y || box.top() > inside.top())
        continue;
      const auto distance = [&](const std::vector<Point>& others) {
        double least = 2 * clear;
        for (const Point& p : others)
          least = std::min(least, std::hypot(std::max({box.x - p.x(), p.x() - box.right(), 0.0}),
                                             std::max({box.y - p.y(), p.y() - box.top(), 0.0})));
        return least;
      };
      const double own = distance(mine);
      if (own < 3 || covered(box.inset(-3)) > 0) continue;
      double others = clear;
      for (std::size_t k = 0; k < entries_.size(); ++k)
        if (k != entry && entries_[k].curve) others = std::min(others, distance(samples_[k]));
      bool taken = false;
      for (const auto& other : direct_) taken = taken || (other && other->inset(-6).overlap(box) > 0);
      if (taken || others < 2 * own) continue;
      // Far from other curves, and towards the end, where the eye looks for it.
      const double score = others + 10 * double(i) / double(mine.size());
      if (score > best_score) best_score = score, best = box;
    }
  }
  return best;
}

// All curves of a kind, theory or data, are labelled beside themselves, or none of them is.
void ChartDrawing::label_curves_directly() {
  sample_curves();
  for (const bool theory : {false, true}) {
    std::vector<std::size_t> placed;
    bool all = true;
    for (std::size_t i = 0; i < entries_.size() && all; ++i) {
      const Entry& e = entries_[i];
      if (e.label.empty() || (e.style == CurveStyle::theory) != theory) continue;
      if (e.curve && has_line(e.style)) direct_[i] = place_beside(i);
      all = direct_[i].has_value();
      placed.push_back(i);
    }
    if (!all)
      for (const std::size_t i : placed) direct_[i].reset();
  }
}

double ChartDrawing::covered(const Rectangle& box) const {
  constexpr double margin = 8;  // points about a cross
  double hits = 0;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    for (const Point& p : samples_[k]) hits += box.contains(p);
    if (!entries_[k].curve) continue;
    const Curve& curve = *entries_[k].curve;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      hits += box.inset(-margin).contains(failure_place(curve.x[i], curve.y[i]));
  }
  for (const auto& label : direct_) hits += label && label->overlap(box) > 0;
  for (std::size_t series = 0; series < chart_.bars.size(); ++series)
    for (std::size_t i = 0; i < chart_.bar_names.size(); ++i) hits += bar(series, i).overlap(box) > 0;
  for (const Annotation& a : chart_.annotations) hits += box.contains(at(a.x, a.y));
  for (const Reference& r : chart_.references) {
    const Point p = at(r.axis == Reference::Across::x ? r.value : ranges_.x.first,
                       r.axis == Reference::Across::y ? r.value : ranges_.y.first);
    hits +=
        r.axis == Reference::Across::x ? p.x() > box.x && p.x() < box.right() : p.y() > box.y && p.y() < box.top();
  }
  return hits;
}

// Width and height of the legend as a column.
Point ChartDrawing::legend_size() const {
  double w = 0, h = 0;
  for (const Entry& e : entries_) {
    if (!is_in_legend(e)) continue;
    w = std::max(w, width(e.label, small_size) + 42);
    h += line_height * small_size;
  }
  return {w + 8, h + 8};
}

bool ChartDrawing::legend_fits_inside() {
  sample_curves();
  const double w = legend_size().x(), h = legend_size().y();
  if (w > 0.6 * plot_.width || h > 0.7 * plot_.height) return false;
  const double gap = 8;
  const double left = plot_.x + gap, right = plot_.right() - w - gap, middle = plot_.centre().x() - w / 2;
  const double top = plot_.top() - h - gap, bottom = plot_.y + gap, half = plot_.centre().y() - h / 2;
  const std::array<Point, 8> corners{Point(right, top),   Point(left, top),     Point(right, bottom),
                                     Point(left, bottom), Point(middle, top),   Point(right, half),
                                     Point(left, half),   Point(middle, bottom)};
  for (const Point& corner : corners) {
    legend_ = {corner.x(), corner.y(), w, h};
    if (covered(legend_.inset(-4)) == 0) return true;
  }
  return false;
}

// Height of the legend as rows above the plot; draws it if `drawing`.
double ChartDrawing::legend_rows(bool drawing) {
  const double row = line_height * small_size;
  double x = frame_.x, y = plot_.top() + legend_.height;
  double rows = 1;
  for (const Entry& e : entries_) {
    if (!is_in_legend(e)) continue;
    const double w = width(e.label, small_size) + 36;
    if (x > frame_.x && x + w > frame_.right()) x = frame_.x, y -= row, ++rows;
    if (drawing) {
      draw_sample({x, y - row / 2}, e);
      canvas_.text({x + 34, y - row / 2}, e.label, {.size = small_size, .anchor = Anchor::left});
    }
    x += w + 18;
  }
  legend_.height = rows * row + 8;
  return legend_.height;
}

void ChartDrawing::draw_axes() {
  if (!chart_.heat_map) {
    const auto upright = [&](double value, const Stroke& s) {
      const double x = plot_.x + x_(value) * plot_.width;
      canvas_.line({x, plot_.y}, {x, plot_.top()}, s);
    };
    const auto level = [&](double value, const Stroke& s) {
      const double y = plot_.y + y_(value) * plot_.height;
      canvas_.line({plot_.x, y}, {plot_.right(), y}, s);
    };
    // Only a logarithmic axis gets minor grid lines.
    if (chart_.x.scale == Scale::logarithmic)
      for (const double v : x_ticks_.minor) upright(v, faint_line);
    if (chart_.y.scale == Scale::logarithmic)
      for (const double v : y_ticks_.minor) level(v, faint_line);
    if (chart_.bars.empty())
      for (const Tick& t : x_ticks_.major) upright(t.value, grid_line);
    for (const Tick& t : y_ticks_.major) level(t.value, grid_line);
    if (chart_.y.scale == Scale::linear && ranges_.y.first < 0 && ranges_.y.second > 0) level(0, axis_line);
    canvas_.line({plot_.x, plot_.y}, {plot_.right(), plot_.y}, axis_line);
    canvas_.line({plot_.x, plot_.y}, {plot_.x, plot_.top()}, axis_line);
  }
  const TextStyle ticks_style{.size = tick_size, .colour = palette::ink};
  TextStyle below = ticks_style, beside = ticks_style;
  below.anchor = Anchor::top, below.offset = {0, -7};
  beside.anchor = Anchor::right, beside.offset = {-8, 0};
  for (const Tick& t : x_ticks_.major)
    canvas_.text({plot_.x + x_(t.value) * plot_.width, plot_.y}, t.label, below);
  for (const Tick& t : y_ticks_.major)
    canvas_.text({plot_.x, plot_.y + y_(t.value) * plot_.height}, t.label, beside);
  canvas_.text({plot_.centre().x(), plot_.y - 1.55 * tick_size}, axis_label(chart_.x, x_ticks_),
               {.size = label_size, .anchor = Anchor::top, .offset = {0, -3}});

  const double above = labelling_ == Labelling::above ? legend_.height : 0;
  canvas_.text({frame_.x, plot_.top() + above + 10}, y_label_,
               {.size = label_size, .anchor = Anchor::bottom_left});
  // Leaves room for a superscript above the capitals.
  canvas_.text({frame_.x, frame_.top() - 3}, title_,
               {.size = title_size, .anchor = Anchor::top_left, .bold = true});
}

void ChartDrawing::draw_heat_map() {
  if (!chart_.heat_map) return;
  const HeatMap& map = *chart_.heat_map;
  const Position shade({.scale = map.scale}, value_range(map));
  const auto colour = [&](double value) {
    if (!map.classes.empty()) return map.classes[std::size_t(value)].colour;
    return shade_of(map, int(std::lround(std::clamp(shade(value), 0.0, 1.0) * (shades - 1))));
  };
  const std::vector<double> xs = cell_edges(map.x, chart_.x.scale), ys = cell_edges(map.y, chart_.y.scale);
  for (std::size_t row = 0; row < map.y.size(); ++row) {
    for (std::size_t column = 0; column < map.x.size(); ++column) {
      const double value = map.values[row * map.x.size() + column];
      const Point a = at(xs[column], ys[row]), b = at(xs[column + 1], ys[row + 1]);
      const Rectangle cell = bounds(std::array<Point, 2>{a, b});
      if (std::isinf(value)) {
        canvas_.rectangle(cell, {palette::fixed, {{}, 0}});
        const Stroke cross{palette::ink, 1.3};
        const Rectangle inner = cell.inset(0.3 * cell.width, 0.3 * cell.height);
        canvas_.line({inner.x, inner.y}, {inner.right(), inner.top()}, cross);
        canvas_.line({inner.x, inner.top()}, {inner.right(), inner.y}, cross);
      } else if (std::isfinite(shade(value))) {
        canvas_.rectangle(cell, {colour(value), {{}, 0}});
      }
    }
  }
  if (!map.classes.empty()) {
    // Separates neighbours of equal value.
    const Stroke seam{fade(palette::paper, 0.6), 1};
    for (const double x : xs) canvas_.line(at(x, ys.front()), at(x, ys.back()), seam);
    for (const double y : ys) canvas_.line(at(xs.front(), y), at(xs.back(), y), seam);
  }
  const Stroke outline{palette::muted, 1.2};
  canvas_.rectangle(plot_, {fade(palette::paper, 0), outline});
  if (map.classes.empty()) draw_colour_bar();
}

void ChartDrawing::draw_colour_bar() {
  const HeatMap& map = *chart_.heat_map;
  const auto range = value_range(map);
  const Rectangle bar{plot_.right() + 14, plot_.y, 16, plot_.height};
  for (int i = 0; i < shades; ++i)
    canvas_.rectangle({bar.x, bar.y + bar.height * i / shades, bar.width, bar.height / shades},
                      {shade_of(map, i), {{}, 0}});
  canvas_.rectangle(bar, {fade(palette::paper, 0), {palette::muted, 1.2}});
  const Position place({.scale = map.scale}, range);
  const Ticks marks = ticks(map.scale, range.first, range.second, std::max(2, int(bar.height / 48)));
  for (const Tick& t : marks.major)
    canvas_.text({bar.right(), bar.y + place(t.value) * bar.height}, t.label,
                 {.size = tick_size, .anchor = Anchor::left, .offset = {6, 0}});
  Axis axis;
  axis.label = map.label;
  const std::string label = axis_label(axis, marks);
  canvas_.text({std::min(bar.x, frame_.right() - width(label, label_size)),
                plot_.top() + (labelling_ == Labelling::above ? legend_.height : 0) + 10},
               label, {.size = label_size, .anchor = Anchor::bottom_left});
}

void ChartDrawing::draw_bars() {
  // A bar of zero is a thin line.
  const auto visible = [](Rectangle bar) {
    constexpr double least = 3;
    if (bar.height < least) bar.y -= (least - bar.height) / 2, bar.height = least;
    return bar;
  };
  canvas_.clip(plot_);
  for (std::size_t series = 0; series < chart_.bars.size(); ++series)
    for (std::size_t i = 0; i < chart_.bar_names.size(); ++i)
      if (std::isfinite(chart_.bars[series].values[i]))
        canvas_.rectangle(visible(bar(series, i)), {entries_[series].colour, {{}, 0}});
  canvas_.clip(std::nullopt);
  for (std::size_t series = 0; series < chart_.bars.size(); ++series)
    for (std::size_t i = 0; i < chart_.bar_names.size(); ++i)
      if (const double v = chart_.bars[series].values[i]; std::isinf(v))
        draw_failure(double(i), v, entries_[series].colour);
  if (!chart_.bars.empty() && ranges_.y.first <= 0 && ranges_.y.second >= 0) {
    const double y = at(0, 0).y();
    canvas_.line({plot_.x, y}, {plot_.right(), y}, axis_line);
  }
}

void ChartDrawing::draw_curves() {
  canvas_.clip(plot_.inset(-0.5 * curve_width));
  // Fronts are drawn below the other curves, theory above them.
  const auto layer = [](CurveStyle s) { return s == CurveStyle::front ? 0 : s == CurveStyle::theory ? 2 : 1; };
  for (const int now : {0, 1, 2}) {
    for (const Entry& e : entries_) {
      if (!e.curve || layer(e.style) != now) continue;
      if (e.style == CurveStyle::stems) draw_stems(*e.curve, e.colour);
      if (has_line(e.style)) canvas_.path(shown(*e.curve), stroke(e));
    }
  }
  canvas_.clip(std::nullopt);
  for (const Entry& e : entries_) {
    if (!e.curve) continue;
    if (has_marks(e.style)) draw_marks(e);
    if (is_growing() && e.style != CurveStyle::theory) draw_end(e);
    for (std::size_t i = 0; i < e.curve->x.size() && !(e.curve->x[i] > chart_.until); ++i) {
      const Point p = draw_failure(e.curve->x[i], e.curve->y[i], e.colour);
      if (p.allFinite() && !e.curve->point_labels.empty())
        reasons_.push_back({p, e.curve->point_labels[i], e.colour});
    }
  }
}

// Where a growing curve has arrived.
void ChartDrawing::draw_end(const Entry& e) {
  const std::vector<Point> places = shown(*e.curve);
  if (!places.empty() && places.back().allFinite() && plot_.inset(-3).contains(places.back()))
    canvas_.mark(places.back(), Mark::disc, e.colour, 10);
}

void ChartDrawing::draw_stems(const Curve& curve, Colour colour) {
  const double foot =
      chart_.y.scale == Scale::linear ? std::clamp(0.0, ranges_.y.first, ranges_.y.second) : ranges_.y.first;
  for (std::size_t i = 0; i < curve.x.size() && !(curve.x[i] > chart_.until); ++i)
    canvas_.line(at(curve.x[i], foot), at(curve.x[i], curve.y[i]), {fade(colour, 0.75), 1.8});
}

void ChartDrawing::draw_marks(const Entry& e) {
  const std::vector<Point> places = points(*e.curve, chart_.until);
  const double size = e.curve->x.size() > 80 && e.style == CurveStyle::markers ? 6 : 9;
  // A line with many points has a marker at every n-th only.
  const double apart = e.style == CurveStyle::line_and_markers && e.curve->x.size() > 40 ? 26 : 0;
  Point last(-1e9, -1e9);
  for (const Point& p : places) {
    if (!p.allFinite() || !plot_.inset(-3).contains(p) || (p - last).norm() < apart) continue;
    canvas_.mark(p, e.mark, e.colour, size);
    last = p;
  }
}

// Position of the cross of a failed run, at the edge on the infinite side. Not finite for any other point.
Point ChartDrawing::failure_place(double x, double y) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), margin = 7;
  if (!std::isinf(x) && !std::isinf(y)) return {nan, nan};
  const auto along = [&](double value, const Axis& axis, const Position& position, double begin, double extent) {
    if (!std::isinf(value)) return begin + position(value) * extent;
    return (value > 0) != axis.reversed ? begin + extent - margin : begin + margin;
  };
  return {along(x, chart_.x, x_, plot_.x, plot_.width), along(y, chart_.y, y_, plot_.y, plot_.height)};
}

// Draws the cross of a failed run and returns its position. Crosses at the same position step inwards.
Point ChartDrawing::draw_failure(double x, double y, Colour colour) {
  Point p = failure_place(x, y);
  if (!p.allFinite()) return p;
  const Point inwards = std::isinf(y) ? Point(0, y > 0 ? -13 : 13) : Point(x > 0 ? -13 : 13, 0);
  while (std::any_of(failures_.begin(), failures_.end(), [&](const Point& f) { return (f - p).norm() < 10; }))
    p += inwards;
  failures_.push_back(p);
  canvas_.mark(p, Mark::cross, colour, 12);
  return p;
}

void ChartDrawing::draw_references() {
  for (const Reference& r : chart_.references) {
    const bool level = r.axis == Reference::Across::y;
    const double share = level ? y_(r.value) : x_(r.value);
    if (!(share >= 0 && share <= 1)) continue;
    const Point a =
        level ? Point(plot_.x, plot_.y + share * plot_.height) : Point(plot_.x + share * plot_.width, plot_.y);
    const Point b = level ? Point(plot_.right(), a.y()) : Point(a.x(), plot_.top());
    canvas_.line(a, b, {palette::theory, 1.6, Dash::dotted});
  }
}

void ChartDrawing::draw_sample(const Point& p, const Entry& e) {
  const Point end = p + Point(26, 0), middle = p + Point(13, 0);
  if (!e.curve) return canvas_.rectangle({p.x() + 5, p.y() - 6, 16, 12}, {e.colour, {{}, 0}});
  if (has_line(e.style)) canvas_.line(p, end, stroke(e));
  if (has_marks(e.style)) canvas_.mark(middle, e.mark, e.colour);
}

void ChartDrawing::draw_end_labels() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    if (e.label.empty()) continue;
    const Point place(plot_.right() + 18, end_heights_[i]);
    std::size_t last = e.curve->x.size();
    while (!at(e.curve->x[last - 1], e.curve->y[last - 1]).allFinite()) --last;
    const Point end = at(e.curve->x[last - 1], e.curve->y[last - 1]);
    const bool arrived = e.style == CurveStyle::theory || !(e.curve->x[last - 1] > chart_.until);
    if (arrived && (std::abs(end.y() - place.y()) > 3 || end.x() < plot_.right() - 4))
      canvas_.line(end + Point(3, 0), place - Point(3, 0), {fade(e.colour, 0.6), 1.2});
    canvas_.text(place, e.label, {.size = small_size + 1, .colour = e.colour, .anchor = Anchor::left});
  }
}

void ChartDrawing::draw_texts() {
  Labels labels(canvas_, plot_);
  const bool any_inside = !chart_.references.empty() || !chart_.annotations.empty() ||
                          std::any_of(chart_.curves.begin(), chart_.curves.end(),
                                      [](const Curve& c) { return !c.point_labels.empty(); });
  for (const Entry& e : entries_)
    if (e.curve && any_inside) labels.avoid_path(points(*e.curve));
  for (const Point& p : failures_) labels.avoid({p.x() - 7, p.y() - 7, 14, 14});
  for (std::size_t series = 0; series < chart_.bars.size(); ++series)
    for (std::size_t i = 0; i < chart_.bar_names.size(); ++i) labels.avoid(bar(series, i));
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!direct_[i]) continue;
    canvas_.text(direct_[i]->centre(), entries_[i].label,
                 {.size = small_size, .colour = label_colour(entries_[i]), .halo = 3});
    labels.avoid(*direct_[i]);
  }
  if (labelling_ == Labelling::at_ends) draw_end_labels();
  if (labelling_ == Labelling::above) legend_rows(true);
  if (labelling_ == Labelling::inside) {
    labels.avoid(legend_);
    canvas_.rectangle(legend_, {fade(palette::paper, 0.85), {{}, 0}});  // over the grid
  }
  if (labelling_ == Labelling::inside || labelling_ == Labelling::beside) {
    double y = legend_.top() - 4 - 0.5 * line_height * small_size;
    for (const Entry& e : entries_) {
      if (!is_in_legend(e)) continue;
      draw_sample({legend_.x + 4, y}, e);
      canvas_.text({legend_.x + 38, y}, e.label, {.size = small_size, .anchor = Anchor::left});
      y -= line_height * small_size;
    }
  }
  for (const Reference& r : chart_.references) {
    if (r.label.empty()) continue;
    const bool level = r.axis == Reference::Across::y;
    const double share = level ? y_(r.value) : x_(r.value);
    if (!(share >= 0 && share <= 1)) continue;
    const TextStyle style{.size = small_size, .colour = palette::theory, .halo = 3};
    // The first free place along the line: from the right on a horizontal line, from the top on a vertical one.
    const double length = level ? plot_.width : plot_.height;
    const Rectangle box = canvas_.measure({0, 0}, r.label, style);
    const double need = level ? box.width : box.height;
    Point best;
    double least = std::numeric_limits<double>::infinity();
    for (double s = length - need / 2 - 4; s > need / 2; s -= 12) {
      for (const double side : {1.0, -1.0}) {
        const Point p = level ? Point(plot_.x + s, plot_.y + share * plot_.height + side * 12)
                              : Point(plot_.x + share * plot_.width + side * (box.width / 2 + 7), plot_.y + s);
        const Rectangle here = canvas_.measure(p, r.label, style);
        const double outside = 4 * (here.width * here.height - here.overlap(plot_));
        const double under = labels.covered(here) + (outside > 1e-6 ? outside : 0);
        if (under < least) least = under, best = p;
      }
      if (least == 0) break;
    }
    canvas_.text(best, r.label, style);
    labels.avoid(canvas_.measure(best, r.label, style));
  }
  for (const Entry& e : entries_)
    if (e.curve)
      for (std::size_t i = 0; i < e.curve->point_labels.size(); ++i)
        if (const Point p = at(e.curve->x[i], e.curve->y[i]); plot_.contains(p) && !(e.curve->x[i] > chart_.until))
          labels.place(p, e.curve->point_labels[i], {.size = 14, .colour = label_colour(e), .halo = 2.5});
  for (const Reason& reason : reasons_)
    labels.place(reason.at, reason.text, {.size = 14, .colour = reason.colour, .halo = 2.5});
  if (chart_.y.scale == Scale::linear)  // the line y = 0
    labels.avoid_path(std::array<Point, 2>{at(ranges_.x.first, 0), at(ranges_.x.second, 0)});
  for (const Annotation& a : chart_.annotations) {
    const Point p = at(a.x, a.y);
    if (!plot_.inset(-1).contains(p)) continue;
    canvas_.mark(p, Mark::disc, palette::ink, 7);
    labels.place(p, a.text, {.size = small_size, .halo = 3});
  }
}

/// What `drawn` makes of the chart in points of the page; the camera stays as it was.
Rectangle on_the_page(Canvas& canvas, const Chart& chart, const Rectangle& frame,
                      Rectangle (ChartDrawing::*drawn)()) {
  const Camera before = canvas.camera();
  canvas.look_at_page();
  const Rectangle plot = (ChartDrawing(canvas, chart, frame).*drawn)();
  canvas.look(before);
  return plot;
}

}  // namespace

Rectangle draw(Canvas& canvas, const Chart& chart, const Rectangle& frame) {
  return on_the_page(canvas, chart, frame, &ChartDrawing::draw);
}

Rectangle layout(Canvas& canvas, const Chart& chart, const Rectangle& frame) {
  return on_the_page(canvas, chart, frame, &ChartDrawing::layout);
}

}  // namespace byhand::renderer
