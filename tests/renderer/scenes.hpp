#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "renderer/chart.hpp"
#include "renderer/labels.hpp"
#include "renderer/space.hpp"

// Pages that together use every shape and every kind of chart: for golden frames, for comparing backends and for
// the benchmark.
namespace byhand::renderer::scenes {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline Chart damped_oscillation() {
  Chart chart{.title = "Drift and its law"};
  chart.x.label = "t (s)";
  chart.y.label = "C (mm)";
  Curve measured{.label = "C(t)"}, law{.label = "h·v^2·t/(2L)", .style = CurveStyle::theory};
  for (int i = 0; i <= 200; ++i) {
    const double t = i / 20.0;
    measured.x.push_back(t), measured.y.push_back(i % 70 > 64 ? nan : 50 * t + 18 * std::sin(3 * t));
    law.x.push_back(t), law.y.push_back(52 * t);
  }
  chart.curves = {measured, law};
  return chart;
}

inline Chart two_orders() {
  Chart chart{.title = "Order is the slope"};
  chart.x = {.label = "h (s)", .scale = Scale::logarithmic};
  chart.y = {.label = "error (m²)", .scale = Scale::logarithmic};
  for (const int order : {1, 2}) {
    Curve measured{.label = order == 1 ? "one sign wrong" : "J of (14)", .style = CurveStyle::line_and_markers};
    for (int i = 0; i < 6; ++i) {
      const double h = 0.1 * std::pow(0.5, i);
      measured.x.push_back(h), measured.y.push_back(i == 5 && order == 1 ? infinity : 3 * std::pow(h, order));
      measured.point_labels.push_back(order == 2 ? "1/" + std::to_string(10 << i) : "");
    }
    chart.curves.push_back(measured);
  }
  chart.annotations = {{.x = 0.02, .y = 0.3, .text = "a pixel"}};
  chart.references = {{.axis = Reference::Across::y, .value = 1e-2, .label = "visible"}};
  return chart;
}

inline Chart joint_forces() {
  Chart chart{.title = "What each joint carries"};
  chart.y.label = "λ/h (N)";
  chart.bar_names = {"1", "2", "3", "4", "5"};
  chart.bars = {{.label = "one sweep", .values = {6, 12, 18, 24, -9}},
                {.label = "direct", .values = {150, 120, 90, 60, 30}}};
  return chart;
}

inline Chart stable_region() {
  Chart chart{.title = "Where it settles"};
  chart.x.label = "β";
  chart.y = {.label = "sweeps", .scale = Scale::logarithmic};
  HeatMap map{.label = "growth", .diverging = true};
  for (int i = 1; i <= 12; ++i) map.x.push_back(0.15 * i);
  for (int i = 0; i < 7; ++i) map.y.push_back(1 << i);
  for (const double k : map.y)
    for (const double beta : map.x) {
      const double v = std::log10(beta * k / 8);
      map.values.push_back(v > 0.95 ? infinity : v < -1.2 ? nan : v);
    }
  Curve law{.label = "law", .style = CurveStyle::theory};
  for (double k = 1; k <= 64; k *= 1.1) law.x.push_back(8 / k), law.y.push_back(k);
  chart.heat_map = map;
  chart.curves = {law};
  return chart;
}

inline Chart sparse_matrix() {
  Chart chart{.title = "A = J·M^{−1}·J^T"};
  chart.x.label = "column";
  chart.y = {.label = "row", .reversed = true};
  HeatMap map{.label = "1/kg", .diverging = true, .square = true};
  for (int i = 1; i <= 8; ++i) map.x.push_back(i), map.y.push_back(i);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) map.values.push_back(i == j ? 2.0 / 3 : std::abs(i - j) == 1 ? -1.0 / 3 : 0);
  chart.heat_map = map;
  return chart;
}

inline Chart stems() {
  Chart chart{.title = "β = 1.5 overshoots"};
  chart.x.label = "step";
  chart.y.label = "C (cm)";
  Curve error{.style = CurveStyle::stems}, size{.label = "|1 − β|^k", .style = CurveStyle::theory};
  for (int k = 0; k < 10; ++k) {
    error.x.push_back(k), error.y.push_back(10 * std::pow(-0.5, k));
    size.x.push_back(k), size.y.push_back(10 * std::pow(0.5, k));
  }
  chart.curves = {error, size};
  return chart;
}

// A pendulum at `angle` from straight down (rad), with its path so far, arrows and labels, beside two charts.
inline void lesson_frame(Canvas& canvas, double angle) {
  const auto [left, right] = canvas.page().inset(30).split_columns(0.52, 40);
  const auto [upper, lower] = right.split_rows(0.5, 28);
  draw(canvas, damped_oscillation(), upper);
  draw(canvas, stems(), lower);

  canvas.look(fit({-2.3, -2.5, 4.6, 3.3}, left));
  const auto place = [](double a) { return Point(2 * std::sin(a), -2 * std::cos(a)); };
  const Point anchor(0, 0), bob = place(angle);
  std::vector<Point> path;
  for (int i = 0; i <= 60; ++i) path.push_back(place(angle - 0.02 * (60 - i)));
  canvas.ground({-2.3, -2.5}, {2.3, -2.5});
  canvas.trail(path, {palette::muted, 2.5});
  canvas.rod(anchor, bob);
  canvas.anchor(anchor);
  canvas.disc(bob, 0.16);
  const ArrowKind velocity{palette::velocity, 0.3, "m/s"}, force{palette::force, 0.03, "N"};
  const Point v = 3 * Point(std::cos(angle), std::sin(angle));
  canvas.vector(bob, v, velocity);
  canvas.vector(bob, {0, -29.43}, force);
  const Point key(left.x, left.top() - 12);
  canvas.arrow_key(key, velocity, "velocity");
  canvas.arrow_key(key - Point(0, 26), force, "weight");
  Labels labels(canvas, left);
  labels.avoid_disc(bob, 0.16);
  labels.avoid_path(std::array{anchor, bob});
  labels.avoid_path(std::array{bob, Point(bob + velocity.scale * v)});
  labels.avoid_path(path);
  labels.place(bob, "m_2 = 3 kg");
  labels.place(bob + velocity.scale * v, "v", {.colour = palette::velocity, .halo = 3});
  labels.place(bob / 2, "L = 2 m");
}

inline void pendulum(Canvas& canvas) { lesson_frame(canvas, 0.7); }

inline void shapes(Canvas& canvas) {
  canvas.look(fit({-4, -2.2, 8, 4.4}, canvas.page(), 20));
  canvas.ground({-4, -2}, {4, -2});
  canvas.ground({4, -2}, {4, 2});
  canvas.box({-2.6, -1.4}, {1.4, 0.8}, 0.5);
  canvas.disc({-1, -1.5}, 0.5, fixed_look);
  canvas.spring({0, -2}, {0.3, -0.3});
  canvas.rod({0.3, -0.3}, {1.8, -1.4});
  canvas.hinge({0.3, -0.3});
  canvas.anchor({1.8, -1.4}, {0, 1});
  canvas.polygon(std::array<Point, 3>{Point(2.4, -1.8), Point(3.6, -1.8), Point(3, -0.6)},
                 {fade(palette::highlight, 0.6), {palette::ink, 1.8}});
  canvas.dimension({-3.6, 0.2}, {-1.6, 0.8}, "L = 2 m");
  std::vector<Point> wave;
  for (int i = 0; i <= 100; ++i) wave.push_back({-1.2 + 0.024 * i, 0.6 + 0.3 * std::sin(0.3 * i)});
  canvas.trail(wave, {palette::constraint, 4});
  for (Point& p : wave) p.y() += 0.5;
  canvas.path(wave, {palette::theory, 2, Dash::dashed});
  for (Point& p : wave) p.y() += 0.4;
  canvas.path(wave, {palette::error, 2, Dash::dotted});
  for (int i = 0; i < 9; ++i) canvas.mark({1.6 + 0.25 * i, 1.8}, Mark(i), palette::series(i), 12);
  canvas.arrow({2, 0.2}, {3.4, 0.9});
  canvas.arrow({2, 0.2}, {2.1, 0.22}, {palette::velocity, 3});
  canvas.text({3.6, 0.4}, "up", {.upright = false});
  canvas.text({-3.8, 1.8}, "Ċ = JV = ∇C·ẋ, λ̇_1^2, ω × r, M^{−1}", {.size = 24, .anchor = Anchor::left});
  canvas.text({-3.8, 1.2}, "two lines\nin bold", {.size = 20, .anchor = Anchor::left, .bold = true});
}

inline void charts(Canvas& canvas) {
  const std::vector<Rectangle> cells = canvas.page().inset(24).cells(2, 2, 36);
  draw(canvas, two_orders(), cells[0]);
  draw(canvas, joint_forces(), cells[1]);
  draw(canvas, stable_region(), cells[2]);
  draw(canvas, sparse_matrix(), cells[3]);
}

inline void space(Canvas& canvas) {
  Space scene(fit({0, 0, 0.4}, 1.9, {-1, 2, -0.8}, canvas.page()));
  scene.ground({0, 0, -1}, 4, 0.5);
  scene.sphere({0, 0, 1.8}, 0.08, palette::fixed);
  scene.rod({0, 0, 1.8}, {0.9, 0.4, 0.1}, 0.04, palette::constraint);
  scene.sphere({0.9, 0.4, 0.1}, 0.25, palette::body);
  scene.arrow({0.9, 0.4, 0.1}, {1.5, -0.4, 0.3}, 0.03, palette::velocity);
  scene.box({-0.8, 0, -0.6}, {0.8, 0.5, 0.8}, {std::cos(0.2), 0, 0, std::sin(0.2)}, palette::highlight);
  canvas.draw(scene);
  const Point3 bob(0.9, 0.4, 0.1);
  canvas.text(scene.project(bob), "bob",
              {.size = 24, .anchor = Anchor::right, .halo = 3, .offset = {-8 - 0.25 * scene.scale_at(bob), 0}});
}

struct Scene {
  const char* name;
  void (*draw)(Canvas&);
};

inline constexpr std::array<Scene, 4> all{
    {{"pendulum", pendulum}, {"shapes", shapes}, {"charts", charts}, {"space", space}}};

}  // namespace byhand::renderer::scenes
