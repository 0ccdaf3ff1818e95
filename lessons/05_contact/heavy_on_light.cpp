// Deeper: a heavy box on a light one.

#include <Eigen/LU>

#include "lessons/05_contact/column.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double pair_seconds = 2, settling = 8;  // [s]

Pile pair(const RowSolver& solver, double ratio, double beta) {
  Pile pile = column(2, solver, 0, ratio);
  pile.method.drift = Baumgarte{beta};
  return pile;
}

/// Of the upper box, below where it began [m].
double sunk(const Pile& pile) { return 1.5 - pile.scene.bodies().pose[2].position.y(); }

/// A pair in the last second of its run [m].
struct Settled {
  double least = INFINITY, most = -INFINITY;  // sunk
  double in_ground = 0, in_lower = 0;         // at the end: the lower box in the ground, the upper in the lower

  double moves() const { return most - least; }
};

Settled settled(Pile pile, double h) {
  Settled settled;
  while (pile.time < settling - 0.5 * h) {
    pile.step(h);
    if (pile.time < settling - 1) continue;
    settled.least = std::min(settled.least, sunk(pile));
    settled.most = std::max(settled.most, sunk(pile));
  }
  settled.in_ground = 0.5 - pile.scene.bodies().pose[1].position.y();
  settled.in_lower = sunk(pile) - settled.in_ground;
  return settled;
}

/// Where cold sweeps let the pair sink to, from the matrices of Gauss–Seidel [m]: the bias (β/h)C makes up for
/// what k sweeps leave of the fall, b = (1 − Gᵏ)⁻¹Gᵏ·(−gh, 0).
double textbook_sinking(double ratio, int sweeps, double beta, double h) {
  Eigen::Matrix2d A;
  A << 1, -1, -1, 1 + 1 / ratio;
  const Eigen::Matrix2d L = A.triangularView<Eigen::Lower>();
  const Eigen::Matrix2d G = Eigen::Matrix2d::Identity() - A * L.inverse();
  Eigen::Matrix2d left = Eigen::Matrix2d::Identity();
  for (int i = 0; i < sweeps; ++i) left = (left * G).eval();
  const Eigen::Vector2d bias =
      (Eigen::Matrix2d::Identity() - left).inverse() * left * Eigen::Vector2d(-gravity * h, 0);
  return -bias.sum() * h / beta;
}

/// A pair has come to rest if it moves less than this in the eighth second, and has sunk less [m].
constexpr double resting_range = 1e-6, resting_depth = 0.5;

/// The ratio up to which a warm-started pair comes to rest, by bisection of its logarithm; `heaviest` if that
/// does, and none above 1 if it is below `least_limit`.
constexpr double heaviest = 1000, least_limit = 1.05;
double largest_resting_ratio(int sweeps, double beta, double h) {
  const auto rests = [&](double ratio) {
    const Settled end = settled(pair(GaussSeidel{.sweeps = sweeps}, ratio, beta), h);
    return end.moves() < resting_range && end.most < resting_depth;
  };
  if (rests(heaviest)) return heaviest;
  double low = 0, high = std::log(heaviest);
  for (int i = 0; i < 8; ++i) {
    const double middle = (low + high) / 2;
    (rests(std::exp(middle)) ? low : high) = middle;
  }
  return std::exp(low);
}

Chart over_ratio(const Setting& setting, double limit) {
  const double h = setting.h(), beta = setting.beta();
  const int sweeps = setting.sweeps;
  Curve cold{.label = "cold", .style = CurveStyle::markers},
      warm{.label = "warm", .style = CurveStyle::line_and_markers},
      direct{.label = "direct", .style = CurveStyle::line_and_markers, .place = pictures::place_of("direct")},
      law{.label = "cold, theory", .style = CurveStyle::theory};
  constexpr double least = 1e-7;
  for (const double ratio : {1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 70.0, 100.0, 200.0}) {
    const std::pair<Curve*, RowSolver> all[] = {{&cold, GaussSeidel{.sweeps = sweeps, .warm_start = false}},
                                                {&warm, GaussSeidel{.sweeps = sweeps}},
                                                {&direct, Direct{}}};
    for (const auto& [curve, solver] : all) {
      const Settled end = settled(pair(solver, ratio, beta), h);
      curve->x.push_back(ratio);
      curve->y.push_back(std::max({least, std::abs(end.least), std::abs(end.most)}));
    }
    law.x.push_back(ratio);
    law.y.push_back(std::max(least, textbook_sinking(ratio, sweeps, beta, h)));
  }
  Chart chart{.x = {.label = "mass of the upper box over the lower", .scale = Scale::logarithmic},
              .y = {.label = "upper box off its place in the eighth second (m)", .scale = Scale::logarithmic},
              .curves = {cold, warm, direct, law},
              .references = {{.value = least, .label = "0.1 μm or less"}}};
  if (limit >= least_limit)
    chart.references.push_back({Reference::Across::x, std::min(limit, 200.0),
                                limit > 200 ? "warm rests beyond" : say("warm rests up to @", Value(limit, 2))});
  return chart;
}

void draw_runs(Canvas& canvas, const std::vector<NamedPile>& runs, double ratio, const Rectangle& frame) {
  const auto cells = frame.cells(1, static_cast<int>(runs.size()), 8);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Rectangle below{cells[i].x, cells[i].y, cells[i].width, cells[i].height - 44};
    canvas.look_at_page();
    canvas.text({cells[i].centre().x(), cells[i].top() - 20}, runs[i].name,
                {.size = 21, .colour = palette::series(runs[i].place), .bold = true});
    canvas.clip(below);
    canvas.look(fit({-0.8, -0.3, 1.6, 2.9}, below, 0));
    pictures::Shapes shapes = pictures::shapes_of(runs[i].pile.scene);
    for (auto& box : shapes.boxes) {
      box.look = pictures::look_of_run(runs[i].place);
      if (box.body == 1) box.look.fill = mix(palette::paper, box.look.fill, 0.5);  // the light one
      box.look.fill = fade(box.look.fill, 0.75);
    }
    pictures::draw(canvas, shapes);
    canvas.line({-0.6, 2}, {0.6, 2}, {palette::muted, 1.5, Dash::dashed});
    for (const int body : {1, 2})
      canvas.text(runs[i].pile.scene.bodies().pose[body].position, say("@ kg", Value(body == 2 ? ratio : 1.0, 3)),
                  {.size = 18, .halo = 3});
    canvas.clip({});
  }
  canvas.look_at_page();
}

}  // namespace

void heavy_on_light(const Setting& setting, Page& page) {
  const double ratio = setting.ratio, beta = setting.beta(), h = setting.h();
  const int sweeps = setting.sweeps;
  std::vector<NamedPile> runs{
      {say("@ cold", sweeps), pair(GaussSeidel{.sweeps = sweeps, .warm_start = false}, ratio, beta),
       pictures::place_of("Gauss–Seidel, cold")},
      {say("@ warm", sweeps), pair(GaussSeidel{.sweeps = sweeps}, ratio, beta),
       pictures::place_of("Gauss–Seidel")},
      {"direct", pair(Direct{}, ratio, beta), pictures::place_of("direct")}};
  const double q = ratio / (1 + ratio), missing = std::pow(q, sweeps);

  page.text(
      R"(A box of @ kg stands on a box of 1 kg. The upper row finds the upper box moving towards the lower one and makes
      their speeds equal: @. The row below stops the lower box again, and so on. With the ratio r of the masses each
      sweep leaves r/(1 + r) = @ of the error, and @ @ @ of it.)",
      setting.ratio,
      ratio == 1  ? std::string("each gives way by half")
      : ratio < 3 ? say("the light one gives way by the share @", Value(q, 3))
                  : "mostly the light one gives way",
      Value(q, 4), several(sweeps, "sweep"), sweeps == 1 ? "leaves" : "leave", small_error(missing, 3));
  const Condition nothing_left = Quantity("k ln(1 + 1/r)", -std::log(missing)) > 14;
  if (nothing_left)
    page.text(
        page.verdict({{.when = nothing_left,
                       .say = R"(That is too little to be seen in what follows. Try fewer `sweeps` or a larger
                                    `ratio`.)"}}));
  page.derivation("What a sweep leaves of a heavy box on a light one",
                  {{"the upper row: masses M above and m below, r = M/m",
                    "the common speed is vM/(M + m) = v r/(1 + r)", R"(v\,\frac{M}{M+m} = v\,\frac{r}{1+r})"},
                   {"the lower row stops the light box; the heavy one keeps that speed", "share r/(1 + r) a sweep",
                    R"(\frac{r}{1+r} \text{ a sweep})"}});
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "upper box above its place (m)"}};
  for (NamedPile run : runs) {
    Curve curve{.label = run.name, .place = run.place};
    while (run.pile.time < pair_seconds) {
      run.pile.step(h);
      curve.x.push_back(run.pile.time);
      curve.y.push_back(-sunk(run.pile));
    }
    chart.curves.push_back(std::move(curve));
  }
  // Two boxes high; what is thrown farther leaves the chart.
  if (const auto [low, high] = ranges(chart).y; low < -2 || high > 2)
    chart.y.range = {{std::max(low, -2.0), std::min(high, 2.0)}};
  page.sequence("heavy_on_light",
                say("A box with @ of the one below, at rest at first: the first @ s. Dashed: where its upper side "
                    "belongs.",
                    ratio == 1 ? "the mass" : say("@ times the mass", setting.ratio), pair_seconds),
                Seconds{pair_seconds}, [=, runs = runs](Canvas& canvas, double time) mutable {
                  for (NamedPile& run : runs)
                    while (run.pile.time < time - 0.5 * h) run.pile.step(h);
                  const auto [left, right] = canvas.page().inset(16).panels(0.56, 20);
                  draw_runs(canvas, runs, ratio, left);
                  renderer::draw(canvas, pictures::grown_to(chart, time), right.lowered(60));
                });
  const Settled cold = settled(pair(runs[0].pile.method.solver, ratio, beta), h),
                warm = settled(pair(runs[1].pile.method.solver, ratio, beta), h),
                direct = settled(pair(Direct{}, ratio, beta), h);
  const double law = textbook_sinking(ratio, sweeps, beta, h), limit = largest_resting_ratio(sweeps, beta, h);
  const Quantity still("movement in the eighth second", warm.moves(), "m"), sunk("sunk", warm.most, "m");
  const Quantity in_ground("lower box in the ground, cold", cold.in_ground, "m");
  const Condition flush = Quantity("upper box in the lower", std::abs(cold.in_lower), "m") < 1e-6;
  // One after the other, so that each compiler lists them in this order.
  const std::string cold_end = page.verdict(
      {{.when = in_ground < 1e-6, .say = "Here that is too little to be seen."},
       {.when = in_ground < 0.95,
        .say = say(
            R"(It sinks until the correction of this overlap makes up for that, as in the soft chain of lesson 3: @ mm
            deep after @ s.)",
            Value(1000 * cold.in_ground, 3), settling),
        .law = flush},
       {.when = in_ground >= 0.95,
        .say = "Here the lower box is pushed under altogether, and the upper one stands in its place.",
        .law = flush}});
  const std::string warm_end = page.verdict(
      {{.when = where(still < resting_range, sunk < resting_depth),
        .say = say("This one has come to rest after @ s, @ its place.", settling,
                   warm.most < 1e-9 ? std::string("in") : say("@ mm below", Value(1000 * warm.most, 3)))},
       {.when = still >= resting_range,
        .say = say("This one does not: in the eighth second it moves by @ m.", Value(still.value, 3))},
       {.when = sunk >= resting_depth, .say = "This one has come down."}});
  page.text(
      R"(Started cold, the pair sinks into the ground: the row between the boxes is last in a sweep, so the ground's row
      is left unsolved. @ Started warm, λ reaches the weight over many steps. But meanwhile the overlap has grown, and λ
      remembers its correction too (lesson 4). With @, β = @ and h = @ s a pair comes to rest within @ s (to 1 μm)
      @. @ For a direct solve the ratio of the masses is just a number in A.)",
      cold_end, several(sweeps, "sweep"), setting.beta, setting.h, settling,
      limit < least_limit ? "at no ratio above 1"
      : limit < heaviest  ? say("up to a ratio of about @", Value(limit, 2))
                          : say("even at a ratio of @", heaviest),
      warm_end);
  page.figure("over_ratio",
              say(R"(The upper box's largest distance from its place in the eighth second; @ a step. Dashed: from
          the matrices of Gauss–Seidel.)",
                  several(sweeps, "sweep")),
              over_ratio(setting, limit));

  // What a step leaves of the overlap's way to its rest is 1 − β(1 − qᵏ).
  const bool mild = law < 0.3 && std::pow(1 - beta * (1 - std::pow(q, sweeps)), settling / h) < 1e-3 &&
                    cold.most < 0.5 && cold.moves() < 0.01 * law + 1e-9;
  page.measure("the upper box has sunk, cold", without_rounding(cold.most, 1), "m");
  page.claim("the upper box has sunk, cold sweeps", cold.most, "m",
             is(law, "(1 − Gᵏ)⁻¹Gᵏ gh = −(β/h)C", absolute(0.01 * law + 1e-9)),
             Condition{mild, "sinks less than 0.3 m, stands, and is at rest after 7 s"});
  page.claim("the upper box is off its place, solved directly",
             std::max(std::abs(direct.least), std::abs(direct.most)), "m", is_at_most(1e-6, "it stands"));
}

}  // namespace byhand::contact
