#include "lessons/04_baumgarte/within_two_steps.hpp"

#include "lessons/pictures/acts.hpp"

namespace byhand::baumgarte {
namespace {

constexpr double drawn_step = 0.6;  // hv as it is drawn, in lengths of the rod

struct CorrectionFilm {
  pictures::Acts acts;
  double beta;

  // In lengths of the rod, the anchor at the origin.
  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.54, 30, 0.8);
    const Point start(std::sin(-0.35), -std::cos(-0.35)), along(-start.y(), start.x());
    const Point way = drawn_step * along, moved = start + way, d = moved.normalized();
    const double C = moved.norm() - 1, corrected = std::min(beta, 3.0) * C;
    canvas.look(fit({-0.75, -1.35, 1.75, 1.5}, left, 12));
    std::vector<Point> circle;
    for (int i = 0; i <= 80; ++i) {
      const double angle = -0.85 + 1.9 * i / 80;
      circle.push_back({std::sin(angle), -std::cos(angle)});
    }
    canvas.path(circle, {palette::theory, 1.8, Dash::dashed});

    const double step = acts.share(1, time), back = acts.share(4, time);
    const Point bob = start + step * way - back * corrected * d;
    pictures::draw(canvas, {.bobs = {{bob, 1}}, .rods = {{{0, 0}, bob}}, .anchors = {{0, 0}}});
    if (step > 0) canvas.disc(start, 15 / canvas.camera().scale, {fade(palette::paper, 0), {palette::muted, 1.6}});
    pictures::draw_growing(canvas, start, way, acts.share(0, time),
                           {palette::velocity, step > 0 ? 2.5 : 4.5, step > 0 ? Dash::dashed : Dash::solid});
    if (acts.share(0, time) == 1) pictures::draw_right_angle(canvas, start, along, -start);

    // C along the rod, beside it.
    const Point aside = 30 / canvas.camera().scale * Point(-d.y(), d.x());
    if (const double seen = acts.share(2, time); seen > 0) {
      canvas.line(d + aside, d + aside + seen * C * d, {palette::error, 6});
      for (const double end : {1.0, 1 + C})
        canvas.line(end * d + 0.4 * aside, end * d + 1.5 * aside, {palette::muted, 1.3});
      if (seen == 1)
        canvas.text((1 + 0.5 * C) * d + aside, "C",
                    {.size = 22, .colour = palette::error, .anchor = Anchor::left, .halo = 3, .offset = {32, 0}});
    }
    pictures::draw_growing(canvas, moved + 1.5 * aside, -corrected * d, acts.share(3, time),
                           {palette::force, 4.5});
    acts.draw(canvas, right, time);
  }
};

}  // namespace

void within_two_steps(const Setting& setting, Page& page) {
  const double length = setting.length, h = setting.h(), beta = setting.beta(), way = h * setting.speed();
  const double C = std::hypot(length, way) - length, left = without_rounding(1 - beta, 1);
  const std::string fate = beta < 1    ? "Each step leaves the same share, 1 − β."
                           : beta == 1 ? "Nothing of it is left."
                           : beta < 2  ? "The bob goes past the circle, but less far off than before."
                           : beta == 2 ? "The bob goes past the circle and is as far off as before."
                                       : "The bob goes past the circle and is farther off than before.";
  const pictures::Acts acts(
      {{"JV = 0", "The impulse of lesson 2 leaves V on the tangent, at a right angle to the rod.",
        palette::velocity},
       {say("x + hV, |hV| = @ mm", Value(1000 * way, 3)),
        "The step follows the tangent, and the tangent leaves the circle.", palette::ink},
       {say("C = |d| − L = @ mm", Value(1000 * C, 3)), "Now the rod is too long. This is the drift.",
        palette::error},
       {say("JV = −(β/h)C = @ m/s", Value(-beta / h * C, 3)),
        "In the next step the bias b = (β/h)C asks for a speed along the rod.", palette::force},
       {say("(1 − β)C = @ mm", Value(1000 * left * C, 3)), fate, palette::error}});
  const double enlarged = drawn_step * length / way;
  page.sequence(
      "within_two_steps",
      say(R"(Tangent, drift, correction: two steps of @ s, slowed to @ s. The step is drawn @ long as it is@; the second
          step's motion along the circle is left out.)",
          setting.h, acts.seconds(), std::abs(enlarged - 1) < 0.05 ? "as" : say("@ times as", Value(enlarged, 2)),
          std::abs(enlarged - 1) < 0.05
              ? ""
              : say(", so the drift looks @ times as large", Value(enlarged * enlarged, 2))),
      Seconds{acts.seconds()},
      [film = CorrectionFilm{acts, beta}](Canvas& canvas, double time) { film.draw(canvas, time); });
}

}  // namespace byhand::baumgarte
