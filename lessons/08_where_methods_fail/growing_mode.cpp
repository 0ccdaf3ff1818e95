#include "lessons/08_where_methods_fail/growing_mode.hpp"

#include "lessons/pictures/acts.hpp"

namespace byhand::failures {
namespace {

constexpr double omega_h = 2.1;  // a little beyond the limit of 2
constexpr int drawn_steps = 4;

/// The root of z² − (2 − s²)z + 1 = 0 with the larger size, s = ωh.
double factor() {
  const double b = 2 - omega_h * omega_h;
  return b / 2 - std::sqrt(b * b / 4 - 1);
}

/// A mass on an explicit spring at the beginning of a step: x, and the way hv that it moves in a step.
struct Instant {
  double x, way;
};

Instant after(const Instant& now) {
  const double way = now.way - omega_h * omega_h * now.x;  // hv' = hv − h²ω²x
  return {now.x + way, way};
}

struct ModeFilm {
  pictures::Acts acts;
  std::vector<Instant> run;
  Chart sizes;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.56, 30, 0.8);
    const auto [above, below] = left.split_rows(0.42, 20);
    const std::size_t step = acts.now(time);
    const Instant &now = run[step], &next = run[step + 1];
    // The pull comes first, then the mass moves.
    const double share = acts.share(step, time), pulled = std::min(1.0, share / 0.4),
                 moved = std::max(0.0, (share - 0.4) / 0.6), x = now.x + moved * (next.x - now.x);
    double reach = 0;
    for (const Instant& at : run) reach = std::max(reach, std::abs(at.x));
    canvas.look(fit({-2.2 * reach, -0.5 * reach, 3.5 * reach, reach}, above, 10));
    const double side = 0.3 * reach;
    canvas.ground({-2 * reach, -side / 2}, {1.3 * reach, -side / 2});
    canvas.ground({-2 * reach, 0.45 * reach}, {-2 * reach, -side / 2});
    canvas.line({0, -0.45 * reach}, {0, 0.45 * reach}, {palette::theory, 1.8, Dash::dashed});
    canvas.spring({-2 * reach, 0}, {x - side / 2, 0}, 9);
    canvas.box({x, 0}, {side, side}, 0);
    pictures::draw_growing(canvas, {now.x, 0.34 * reach}, {-0.25 * omega_h * omega_h * now.x, 0}, pulled,
                           {palette::force, 4});
    pictures::draw_growing(canvas, {now.x, -0.34 * reach}, {0.25 * next.way, 0}, moved, {palette::velocity, 4});
    Chart grown = sizes;
    grown.until = static_cast<double>(step) + moved;
    renderer::draw(canvas, grown, below);
    acts.draw(canvas, right, time);
  }
};

}  // namespace

void growing_mode(Page& page) {
  const double z = factor();
  std::vector<Instant> run{{1, z - 1 + omega_h * omega_h}};
  while (run.size() <= drawn_steps) run.push_back(after(run.back()));
  Curve seen{.label = "x_n/x_0", .style = CurveStyle::stems}, size{.label = "|z|^n", .style = CurveStyle::theory};
  std::vector<pictures::Acts::Act> acts;
  std::vector<Tick> counted;
  for (int n = 0; n <= drawn_steps; ++n) {
    seen.x.push_back(n);
    seen.y.push_back(run[static_cast<std::size_t>(n)].x);
    counted.push_back({static_cast<double>(n), say("@", n)});
    if (n == drawn_steps) break;
    acts.push_back({say("x_@ = z x_@ = @ x_0", n + 1, n, Value(run[static_cast<std::size_t>(n) + 1].x, 3)),
                    n == 0 ? "The spring's pull h²ω²x (orange) takes the mass past its place of rest (dashed), "
                             "farther out than it was."
                    : n == 1 ? "And again, by the same factor."
                             : "",
                    palette::error});
  }
  for (int i = 0; i <= 10 * drawn_steps; ++i) {
    size.x.push_back(0.1 * i);
    size.y.push_back(std::pow(std::abs(z), 0.1 * i));
  }
  const Chart sizes{.x = {.label = "step n", .ticks = counted}, .y = {.label = "x_n/x_0"}, .curves = {seen, size}};
  const pictures::Acts film(acts);
  page.sequence(
      "growing_mode",
      say(R"(Four steps of a mass on an undamped explicit spring, ωh = @, slowed down to @ s. Each multiplies x by z
                    = @. Orange: h²ω²x, by which the pull changes hv; green: hv after it; both
                    drawn a quarter as long.)",
          omega_h, film.seconds(), Value(z, 4)),
      Seconds{film.seconds()},
      [shown = ModeFilm{film, run, sizes}](Canvas& canvas, double time) { shown.draw(canvas, time); });
  page.claim(say("growth of an explicit spring in @ steps at ωh = @", drawn_steps, omega_h), run.back().x, "1",
             is(std::pow(z, drawn_steps), "z^n with the larger root of its polynomial", relative(1e-11)));
}

}  // namespace byhand::failures
