// Step 2: the rows of a joint together, or one after the other.

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/scenes/box_on_an_arm.hpp"

namespace byhand::joints {
namespace {

using Held = Simulation<PlaneBody>;

constexpr double swing_seconds = 1.7, drift_seconds = 5;  // of the film, of the drift [s]

Held held_box(const Setting& setting, double side, double angle, int sweeps, BlockSolve solve, DriftCure drift,
              bool warm = false) {
  return {box_on_an_arm(side, setting.length, angle),
          {GaussSeidel{.sweeps = sweeps, .warm_start = warm, .block_solve = solve}, drift}};
}

/// From the pin to the end of the arm [m].
double off(const Held& box) {
  const Pose<PlaneBody>& pose = box.scene.bodies().pose[1];
  return (pose.position + in_world<PlaneBody, double>(pose, box.scene.all<Pin>()[0].at.arms.second)).norm();
}

/// λ of the pin after so many sweeps of one step from rest at 45° [N s].
Point impulse_after(const Setting& setting, double side, int sweeps, BlockSolve solve) {
  Held box = held_box(setting, side, pi / 4, sweeps, solve, NoDriftCure{});
  box.step(setting.h);
  const auto lambda = box.impulse(0);
  return {lambda[0], lambda[1]};
}

/// r²m/I of the arm: how much more easily a push across its end turns the box than moves it.
double leverage(const Setting& setting, double side) { return 6 * std::pow(setting.length / side, 2); }

/// What one sweep row by row leaves at 45°: A₁₂²/(A₁₁A₂₂).
double rate(const Setting& setting, double side) {
  const double half = leverage(setting, side) / 2;
  return std::pow(half / (1 + half), 2);
}

double measured_rate(const Setting& setting, double side) {
  const Point whole = impulse_after(setting, side, 1, BlockSolve::whole);
  const auto error = [&](int sweeps) {
    return (impulse_after(setting, side, sweeps, BlockSolve::row_by_row) - whole).norm();
  };
  return error(2) / error(1);
}

/// Where each row has JV = 0, and how the sweeps move λ, in units of mgh.
Chart way_of_sweeps(const Setting& setting, double side) {
  const double unit = gravity * setting.h, half = leverage(setting, side) / 2;  // the box has 1 kg
  const double left = -0.7, right = 0.15, low = -0.1, high = std::max(0.75, 1.2 * (1 + half) / (1 + 2 * half));
  Chart chart{.title = say("box of @ m on an arm of @ m", side, setting.length),
              .x = {.label = "λ of the x row (mgh)", .range = {{left, right}}},
              .y = {.label = "λ of the y row (mgh)", .range = {{low, high}}}};
  Curve x_row{.label = "x row: JV = 0", .style = CurveStyle::theory},
      y_row{.label = "y row: JV = 0", .style = CurveStyle::theory, .colour = palette::series(2)};
  const double steep = (1 + half) / half;  // the x row's line leaves the chart above and below
  for (const double t : {std::max(left, -high / steep), std::min(right, -low / steep)}) {
    x_row.x.push_back(t);
    x_row.y.push_back(-t * steep);
  }
  for (const double t : {std::max(left, (1 - high * (1 + half)) / half), right}) {
    y_row.x.push_back(t);
    y_row.y.push_back((1 - half * t) / (1 + half));
  }
  Curve way{.label = say("row by row, @", several(setting.sweeps(), "sweep")),
            .x = {0},
            .y = {0},
            .colour = palette::constraint};
  for (int sweeps = 1; sweeps <= setting.sweeps(); ++sweeps) {
    const Point lambda = impulse_after(setting, side, sweeps, BlockSolve::row_by_row) / unit;
    way.x.push_back(lambda.x());
    way.y.push_back(way.y.back());
    way.x.push_back(lambda.x());
    way.y.push_back(lambda.y());
  }
  const Point whole = impulse_after(setting, side, 1, BlockSolve::whole) / unit;
  Curve block{.label = "as a block, once",
              .x = {0, whole.x()},
              .y = {0, whole.y()},
              .style = CurveStyle::line_and_markers,
              .colour = palette::force};
  chart.curves = {x_row, y_row, block, way};
  chart.annotations.push_back({way.x.back(), way.y.back(), ""});
  return chart;
}

/// The part of such a chart where the sweeps go, by itself and without names.
Chart seen_close(Chart chart) {
  const Curve& way = chart.curves.back();
  const auto [left, right] = std::minmax_element(way.x.begin(), way.x.end());
  const auto [low, high] = std::minmax_element(way.y.begin(), way.y.end());
  // A single sweep may go along one axis only.
  const double seen = std::max({*right - *left, *high - *low, 1e-9}), margin = 0.2 * seen;
  chart.title = "";
  chart.x = {.label = "close-up", .range = {{*right - seen - margin, *right + margin}}};
  chart.y = {.range = {{*low - margin, *low + seen + margin}}};
  for (Curve& curve : chart.curves) curve.label = "";
  chart.annotations.clear();
  return chart;
}

struct Rival {
  std::string name;
  Held box;
};

struct RivalsFilm {
  std::vector<Rival> rivals;
  double length, side, h;
  Chart beside;

  void draw(Canvas& canvas, double time) {
    const auto [left, right] = canvas.page().inset(16).panels(0.48, 20);
    const auto cells = left.cells(static_cast<int>(rivals.size()), 1, 10);
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      Held& box = rivals[i].box;
      // A box whose pin is off by ten arms is drawn where it was then: beyond, its numbers mean nothing.
      while (box.time < time - h / 2 && off(box) < 10 * length) box.step(h);
      const Rectangle& below = cells[i];
      canvas.text(
          {below.x + 8, below.top() - 16}, rivals[i].name,
          {.size = 22, .colour = palette::series(static_cast<int>(i)), .anchor = Anchor::left, .bold = true});
      const double drawn = std::max(side, 0.15 * length), reach = length + 0.75 * drawn;  // a corner is at 0.71
      canvas.look(fit({-1.3 * reach, -1.3 * reach, 2.6 * reach, 2.1 * reach}, below, 0));
      canvas.clip(below);
      const Pose<PlaneBody>& pose = box.scene.bodies().pose[1];
      const Point arm = in_world<PlaneBody, double>(pose, box.scene.all<Pin>()[0].at.arms.second);
      canvas.anchor({0, 0});
      canvas.rod(pose.position, pose.position + arm, {palette::body, {palette::ink, 1.4}}, 8);
      canvas.box(pose.position, {drawn, drawn}, std::atan2(pose.rotation.sin, pose.rotation.cos));
      canvas.hinge(pose.position + arm);
      if (arm.norm() > 0 && (pose.position + arm).norm() > 0.02 * length)
        canvas.line({0, 0}, pose.position + arm, {palette::error, 4});
      canvas.clip({});
      canvas.look_at_page();
    }
    renderer::draw(canvas, pictures::grown_to(beside, time), right.lowered(60));
  }
};

/// How far the pin is off over time [mm], and at most over `drift_seconds` [m], or until it is off by ten arms.
struct Drift {
  Curve curve;
  double worst = 0;
  double broke = INFINITY;  // [s]
};

Drift drift_of(const Rival& rival, double length, double h) {
  Drift drift{{.label = rival.name}};
  Held box = rival.box;
  while (box.time < drift_seconds - h / 2 && std::isinf(drift.broke)) {
    box.step(h);
    const double error = off(box);
    if (!(error < 10 * length)) drift.broke = box.time;
    drift.worst = std::max(drift.worst, error);
    if (box.time > swing_seconds + h) continue;
    drift.curve.x.push_back(box.time);
    drift.curve.y.push_back(1000 * error);
  }
  return drift;
}

/// "was at most 12 mm off", or when it broke apart.
std::string fate(const Drift& drift) {
  return std::isinf(drift.broke) ? say("was at most @ mm off", Value(1000 * drift.worst, 3))
                                 : say("was ten arms off after @ s", Value(drift.broke, 3));
}

}  // namespace

void block_or_row(const Setting& setting, Page& page) {
  const double side = setting.side(), length = setting.length, h = setting.h(), beta = setting.beta;
  const int sweeps = setting.sweeps();
  const double c = leverage(setting, side), rho = rate(setting, side), left = std::pow(rho, sweeps);

  const bool slender = c > 50;
  const Quantity arm("r²m/I", c);
  page.text(
      R"(A pin's two rows could also be solved one by one: x by (17), then y by (17), and again. Often that makes no
      difference. It does for a body of small inertia on a long arm. @)",
      page.verdict(
          {{.when = arm > 50,
            .say = say(
                R"(A box of @ m on an arm of @ m is so much easier to turn than to move (r²m/I = @) that a push along x
                or y alone mostly turns it.)",
                setting.side, setting.length, Value(c, 4))},
           {.when = arm <= 50,
            .say = say("With a box of @ m on an arm of @ m, r²m/I is only @: compare.", setting.side,
                       setting.length, Value(c, 4))}}));
  const double halving = std::log(0.5) / std::log(rho);  // sweeps
  page.formula("at 45°:  A = (1/m) [1 + c, c; c, 1 + c],  c = r²m/2I = @",
               R"(\text{at } 45°{:}\quad A = \frac1m\begin{bmatrix}1+c & c\\ c & 1+c\end{bmatrix},\quad
                  c = \frac{r^2m}{2I} = @)",
               Value(c / 2, 4));
  const std::string ask = R"(Solving x by (17) and then y by (17) is one sweep. )";
  const std::vector<std::string> hints{
      R"(An impulse λ along x changes the rate along y by A₂₁λ. When the y row cancels that, how much does it put back
      into x?)",
      "A sweep leaves (c/(1 + c))².",
      slender
          ? say("To which power is (@/@)² = @ equal to ½?", Value(c / 2, 5), Value(1 + c / 2, 5), Value(rho, 5))
          : say("(@/@)² = …", Value(c / 2, 4), Value(1 + c / 2, 4))};
  std::vector<WrongAnswer> wrong;
  if (std::sqrt(rho) - rho > 0.08)
    wrong.push_back(
        {std::sqrt(rho), "That is what one row leaves for the other, c/(1 + c); a sweep solves both."});
  if (slender)
    page.predict({.ask = ask + "How many sweeps remove half of the error?",
                  .answer = std::ceil(halving),
                  .unit = "sweeps",
                  .tolerance = std::max(1.0, 0.1 * halving),
                  .wrong = {{2, "A row leaves nearly all of the error for the other, c/(1 + c), not half of it."}},
                  .hints = hints,
                  .hinted = std::log(0.5) / (2 * std::log(c / (2 + c))),
                  .right = say("A sweep leaves @ of the error.", Value(rho, 5))});
  else
    page.predict({.ask = ask + "What share of the error does it leave?",
                  .answer = rho,
                  .unit = "1",
                  .tolerance = std::min(0.04, 0.4 * rho),
                  .wrong = wrong,
                  .hints = hints,
                  .hinted = std::pow(c / (2 + c), 2),
                  .right = say("A sweep leaves A₁₂²/(A₁₁A₂₂) = @.", Value(rho, 4))});
  page.figure(
      "two_rows",
      R"(One step from rest at 45°, in the plane of the pin's two impulses. On each dashed line one row has JV = 0;
      where they cross, both do. Row by row λ moves from line to line; where these are close the moves are short.)",
      [slender, same = side == length, plump = way_of_sweeps(setting, length),
       small = way_of_sweeps(setting, side)](Canvas& canvas) {
        const Rectangle paper = canvas.page();
        if (same) {
          draw(canvas, small, paper.inset(14, 30));
          return;
        }
        const auto cells = paper.inset(14, paper.is_high() ? 14 : 30).grid(1, 2, 24);
        draw(canvas, plump, cells[0]);
        const Rectangle plot = draw(canvas, small, cells[1]);
        if (slender)
          draw(canvas, seen_close(small), {plot.x + 12, plot.y + 34, 0.5 * plot.width, 0.42 * plot.height});
      });
  page.formula("one sweep leaves (c/(1 + c))² = @",
               R"(\Bigl(\frac{c}{1+c}\Bigr)^2 = @ \text{ is left by one sweep})", Value(rho, 5));
  page.text(
      R"(For the box as large as its arm the rows ask for different things, and a few sweeps are enough. @ @ Solved
      as a block, one solve is enough for any box: the 2 × 2 matrix contains the entry off the diagonal.)",
      slender
          ? R"(For the small box both rows say nearly the same ("do not turn"), and the rest ("do not fall along
                the arm") is in their small difference, which the sweeps approach slowly.)"
      : side == length ? "This lesson's box is one."
                       : "The lines of this lesson's box cross less clearly.",
      left < 1e-15   ? say("@ leave nothing that a double can hold.", several(sweeps, "sweep"))
      : left > 0.995 ? say("@ @ only @ of the error.", several(sweeps, "sweep"),
                           sweeps == 1 ? "removes" : "remove", Value(1 - left, 2))

                     : say("@ @ @ of the error.", several(sweeps, "sweep"), sweeps == 1 ? "leaves" : "leave",
                           small_error(left, 3)));
  RivalsFilm film{
      {{"as a block", held_box(setting, side, pi / 2, sweeps, BlockSolve::whole, Baumgarte{beta})},
       {"row by row", held_box(setting, side, pi / 2, sweeps, BlockSolve::row_by_row, Baumgarte{beta})}},
      length,
      side,
      h,
      {.x = {.label = "time (s)"},
       .y = {
           .label = "how far the pin is off (mm)",
           .scale = Scale::logarithmic,
       }}};
  std::vector<Drift> drifts;
  for (const Rival& rival : film.rivals) {
    drifts.push_back(drift_of(rival, length, h));
    film.beside.curves.push_back(drifts.back().curve);
  }
  double largest = 1;  // [mm]
  for (const Curve& curve : film.beside.curves)
    for (const double off : curve.y) largest = std::max(largest, off);
  film.beside.y.range = {{0.1, std::pow(10, std::ceil(std::log10(largest)))}};
  const Drift &block = drifts[0], &rows = drifts[1];
  page.sequence(
      "block_and_row",
      say(R"(Released level, @ a step, started cold, β = @. Purple: from the pin to the arm's end, which should
                    be at the pin.@)",
          several(sweeps, "sweep"), setting.beta,
          side < 0.15 * length ? " (The box is drawn larger than it is.)" : ""),
      Seconds{swing_seconds}, [film](Canvas& canvas, double time) mutable { film.draw(canvas, time); });
  const double tangent = gravity * h * h / beta;
  const Condition tame =
      both(within(0.1, Quantity("β", beta), 1), Quantity("gh²/L", gravity * h * h / length) < 0.02);
  const Condition on_tangent = where(tame, Quantity("side/L", side / length) <= 0.25,
                                     Quantity("h/β·√(g/L)", h / beta * std::sqrt(gravity / length)) <= 0.45);
  const Drift warm = drift_of(
      {"", held_box(setting, side, pi / 2, sweeps, BlockSolve::row_by_row, Baumgarte{beta}, true)}, length, h);
  page.text(R"(Within @ s the pin @ as a block, and row by row it @.@)", drift_seconds, fate(block), fate(rows),
            on_tangent
                ? R"( The block's error comes from stepping along the tangent (lesson 4: r(ωh)²/2β, with ω² =
                              2g/r at the bottom: gh²/β for any arm); the sweeps left the rest.)"
                : "");
  // A pin that came off was ten arms off.
  const auto worst = [&](const Drift& drift) { return std::isfinite(drift.broke) ? 10 * length : drift.worst; };
  const bool both_broke = std::isfinite(warm.broke) && std::isfinite(rows.broke);
  const Quantity beside = both_broke ? Quantity("time to ten arms, cold/warm", rows.broke / warm.broke)
                                     : Quantity("pin off, warm/cold", worst(warm) / worst(rows));
  page.text(
      R"(Row by row with a warm start the pin @. @ @)", fate(warm),
      page.verdict({{.when = beside < 0.9, .say = "That is better than with a cold start."},
                    {.when = beside > 1.1,
                     .say = "That is worse than with a cold start: λ also remembers the corrections (lesson 4)."},
                    {.when = within(0.9, beside, 1.1), .say = "That is about the same as with a cold start."}}),
      rows.worst > 1.5 * block.worst
          ? "A block needs no warm start: **rows that act through the same arm belong in one block.**"
          : "Here a block makes little difference; for small bodies on long arms it does. It costs hardly "
            "more, so **rows that act through the same arm belong in one block.**");

  if (std::isinf(rows.broke)) page.measure("pin off at most, row by row", 1000 * rows.worst, "mm");
  page.claim("what a sweep row by row leaves at 45°, small box", measured_rate(setting, side), "1",
             is(rho, "A₁₂²/(A₁₁A₂₂)", absolute(1e-9)));
  page.claim("the same, large box", measured_rate(setting, length), "1",
             is(rate(setting, length), "A₁₂²/(A₁₁A₂₂)", absolute(1e-9)));
  page.claim("pin off at most, as a block", block.worst, "m",
             is(tangent, "gh²/β at the bottom of the swing", relative(0.25)), on_tangent);
  page.claim("row by row over as a block", rows.worst / block.worst, "1",
             is_at_least(10, "what the sweeps leave is many times the tangent"),
             both(tame, Quantity("share missing after the sweeps", left) > 0.8));
}

}  // namespace byhand::joints
