// Step 3: stems for several β, and the factor on both sides of 2.

#include "lessons/04_baumgarte/rod_end.hpp"
#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"

namespace byhand::baumgarte {
namespace {

constexpr int panel_steps = 10;
constexpr std::array shown{0.1, 0.2, 0.3, 1.0, 1.5, 1.9, 2.1};

struct Panel {
  double beta;
  std::vector<double> errors;  // [m]

  double reach() const {
    double largest = 0;
    for (const double error : errors) largest = std::max(largest, std::abs(error));
    return largest;
  }
};

Panel panel(const Setting& setting, double beta) {
  return {beta, errors(setting, {beta}, setting.h, panel_steps)};
}

void draw_panel(Canvas& canvas, const Panel& panel, std::size_t now, const Rectangle& cell) {
  now = std::min(now, panel.errors.size() - 1);
  const double reach = panel.reach();
  canvas.text({cell.centre().x(), cell.top() - 12}, say("β = @", panel.beta), {.size = 20, .bold = true});
  const auto [left, right] = Rectangle{cell.x, cell.y, cell.width, cell.height - 26}.split_columns(0.24, 2);
  draw_rod_end(canvas, left, panel.errors[now], 1.1 * reach,
               say("@ cm", std::round(1e4 * panel.errors[now]) / 100));
  Curve stems{.style = CurveStyle::stems, .colour = palette::error};
  for (std::size_t i = 0; i <= now; ++i) {
    stems.x.push_back(static_cast<double>(i));
    stems.y.push_back(100 * panel.errors[i]);
  }
  const bool one_side = panel.beta <= 1;
  draw(canvas,
       {.x = {.label = "step", .range = {{-0.5, panel_steps + 0.5}}},
        .y = {.label = "C (cm)", .range = {{one_side ? -5 * reach : -115 * reach, 115 * reach}}},
        .curves = {stems}},
       right);
}

void draw_key(Canvas& canvas, const Rectangle& cell) {
  canvas.text(cell.centre(),
              "Left: the end of the rod;\ndashed: where it belongs.\nRight: its error C\nafter every step.",
              {.size = 19, .colour = palette::muted});
}

void draw_panels(Canvas& canvas, const std::vector<Panel>& panels, std::size_t now) {
  const auto cells = canvas.page().inset(14).grid(2, 4, 14);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (i < panels.size())
      draw_panel(canvas, panels[i], now, cells[i]);
    else
      draw_key(canvas, cells[i]);
}

/// What a step leaves of the error.
double factor(const Setting& setting, double beta) {
  const std::vector<double> run = errors(setting, {beta}, setting.h, 1);
  return without_rounding(std::abs(run[1] / run[0]), 1);
}

}  // namespace

void both_sides_of_two(const Setting& setting, Page& page) {
  const double e = setting.error, bold = 1.5;
  const Panel overshooting = panel(setting, bold);
  const double after = overshooting.errors[1];
  const bool settles = std::abs(overshooting.errors.back()) < std::abs(e);

  page.text("β is a share. What happens if a step removes more than all of the error?");
  page.predict(
      {.ask = say("The rod is @ cm too long and β = @. How much too long is it after one step?", 100 * e, bold),
       .answer = 100 * after,
       .unit = "cm",
       .tolerance = 100 * e * 0.03,
       .wrong = {{-100 * after, "The size is right, but the bob has passed its place: mind the sign."},
                 {-100 * e * bold, "The step moves the bob that far; the question is where it arrives."}},
       .hints = {"The step moves the bob by more than the error. On which side does it arrive?", "C′ = (1 − β)C.",
                 say("(1 − @) · @ cm = …", bold, 100 * e)},
       .right = "1 − β = −½: the step overshoots by half of the error, so the rod is now too short."});
  page.choose(
      {.ask = say("If every step does this, with β = @, does the rod settle?", bold),
       .options = {{"yes", "Each step overshoots by half, and a half of a half of a half goes to zero."},
                   {"no", "It changes sign each time, but follow its size: a half, a quarter, an eighth …"}},
       .answer = settles ? 0 : 1,
       .hints = {"Watch the size of the error, not its sign.", "Cₖ = (1 − β)ᵏC₀.",
                 "What is left after two steps? After three?"}});

  std::vector<Panel> panels;
  panels.reserve(shown.size() + 1);
  for (const double beta : shown) panels.push_back(panel(setting, beta));
  const bool known = std::any_of(shown.begin(), shown.end(), [&](double b) { return b == setting.beta(); });
  if (!known) panels.push_back(panel(setting, setting.beta()));
  std::ranges::sort(panels, {}, &Panel::beta);
  page.sequence(
      "stems",
      say("The same rod with @ values of β, every step shown. Rods and charts are scaled panel by panel.",
          panels.size()),
      Frames{panel_steps + 1}, [panels](Canvas& canvas, double time) {
        draw_panels(canvas, panels, static_cast<std::size_t>(std::lround(time)));
      });

  page.text(
      R"(Each step multiplies the error by 1 − β, so the size |1 − β| decides. For 0 < β < 2 it is below 1 and the error
      shrinks, above 1 changing its sign; at β = 1 one step removes all of it; at β = 2 the bob jumps from side to side for ever; beyond 2 the
      error grows.)");

  page.measure("share of the error left by a step", factor(setting, setting.beta()), "1");

  page.claim("share of the error left by a step with this β", factor(setting, setting.beta()), "1",
             is(std::abs(1 - setting.beta()), "|1 − β|", absolute(1e-14 * setting.length / e + 1e-9)));
  for (const double beta : {1.99, 2.0, 2.01})
    page.claim(say("left after fifty steps, β = @", beta),
               std::abs(errors(setting, {beta}, setting.h, 50).back() / e), "1",
               is(std::pow(std::abs(1 - beta), 50), "|1 − β|⁵⁰", absolute(1e-11 * setting.length / e)));
}

}  // namespace byhand::baumgarte
