// Step 7: rods that say the same, and rods that contradict each other.

#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::joints {
namespace {

using Rods = Simulation<PlaneParticle>;

constexpr double conflict_seconds = 5;            // [s]
constexpr double added_share = 0.01, give = 0.1;  // of each row's A: what the regularisation and the softness add
constexpr int frames = 36;

/// A bob that hangs from two rods between the same two points, one longer by `gap` [m].
Rods two_rods(const Setting& setting, double gap, const RowSolver& solver, double softness = 0) {
  const double length = setting.length;
  Rods rods{pendulum<PlaneParticle, NormalisedDistance>(0, length, setting.mass),
            {solver, Baumgarte{setting.beta}}};
  auto& scene = rods.scene;
  scene.add(NormalisedDistance<PlaneParticle>{{0, 1}, length + gap});
  scene.change_all<NormalisedDistance>([&](auto& rod) { rod.softness = softness; });
  return rods;
}

double lambda(const Rods& rods, int rod) { return rods.impulse(rod)[0]; }

/// The impulse with which the two rods act against each other: half the difference of their λ [N s].
double opposed(const Rods& rods) { return 0.5 * (lambda(rods, 1) - lambda(rods, 0)); }

struct Cure {
  std::string name;
  Rods rods;
};

Curve over_time(const Cure& cure, const Setting& setting) {
  Curve curve{.label = cure.name};
  Rods rods = cure.rods;
  advance_to(rods, conflict_seconds, setting.h, [&] {
    curve.x.push_back(rods.time);
    curve.y.push_back(opposed(rods) / setting.h / (setting.mass * gravity));
  });
  return curve;
}

// Colours that no curve of the chart has.
const Colour short_rod = palette::ink, long_rod = palette::series(7);

void draw_rods(Canvas& canvas, const Rods& rods, double length, double gap, const Rectangle& frame) {
  const double apart = 0.09 * length;  // the rods are one line; drawn side by side they can be told apart
  canvas.look(fit({-0.6 * length, -1.3 * (length + gap), 1.2 * length, 1.45 * (length + gap)}, frame, 6));
  const Point bob = rods.scene.bodies().pose[1].position;
  canvas.anchor({0, 0});
  for (const auto& [side, colour] : {std::pair{-1, short_rod}, std::pair{1, long_rod}}) {
    const Point off(side * apart, 0);
    canvas.rod(off, bob + off, {colour, {palette::ink, 0}}, 7);
  }
  canvas.rod({-1.4 * apart, 0}, {1.4 * apart, 0}, body_look, 12);
  canvas.rod(bob - Point(1.4 * apart, 0), bob + Point(1.4 * apart, 0), body_look, 12);
  canvas.disc(bob - Point(0, 0.16 * length), 0.12 * length);
  canvas.line({-0.5 * length, -length}, {0.5 * length, -length}, {short_rod, 1.6, Dash::dashed});
  canvas.line({-0.5 * length, -length - gap}, {0.5 * length, -length - gap}, {long_rod, 1.6, Dash::dashed});
  canvas.look_at_page();
}

struct ConflictFilm {
  Rods rods;
  double length, gap, h, weight;
  Chart beside;

  void draw(Canvas& canvas, double frame) {
    const double time = conflict_seconds * frame / (frames - 1);
    advance_to(rods, time, h);
    const auto [left, right] = canvas.page().inset(16).panels(0.36, 20);
    const Rectangle picture{left.x, left.y + 96, left.width, left.height - 96};
    draw_rods(canvas, rods, length, gap, picture);
    const bool begun = rods.work.system.rows() > 0;
    const auto says = [&](int rod) {
      const double pull = begun ? -lambda(rods, rod) / h / weight : 0;
      return say("@ rod @ with @ mg", rod == 0 ? "short" : "long", pull < 0 ? "pushes" : "pulls",
                 Value(std::abs(pull), 3));
    };
    canvas.text({left.x + 10, left.y + 70}, say("@ s", Value(std::floor(time * 10 + 1e-9) / 10, 3)),
                {.size = 24, .anchor = Anchor::left, .bold = true});
    canvas.text({left.x + 10, left.y + 40}, says(0), {.size = 19, .colour = short_rod, .anchor = Anchor::left});
    canvas.text({left.x + 10, left.y + 12}, says(1), {.size = 19, .colour = long_rod, .anchor = Anchor::left});
    renderer::draw(canvas, pictures::grown_to(beside, time), right.lowered(40));
  }
};

}  // namespace

void conflicting_rods(const Setting& setting, Page& page) {
  const double h = setting.h(), beta = setting.beta, m = setting.mass, length = setting.length, gap = setting.gap,
               weight = m * gravity;
  const int sweeps = setting.sweeps();
  const double softness = give / m;
  const GaussSeidel warm{.sweeps = sweeps}, cold{.sweeps = sweeps, .warm_start = false};

  // The same rod twice.
  Rods first = two_rods(setting, 0, cold), biased = two_rods(setting, 0, warm),
       shared = two_rods(setting, 0, Direct{.regularisation = 1e-6});
  biased.step(h);
  biased.work.system.lambda = {m, -m};  // any pair whose sum is zero
  for (Rods* rods : {&first, &biased, &shared}) advance_to(*rods, 1, h);
  const auto sum = [](const Rods& rods) { return lambda(rods, 0) + lambda(rods, 1); };
  page.text(
      R"(Hang a bob of @ kg from two rods of @ m in place of one, between the same two points. Their rows are equal, and
      A = (1/m)[1 1; 1 1] has no inverse. Only the *sum* of the two λ is determined: it carries the weight, mgh = @ N·s
      (pulls are counted positive). How the two share it depends on the solver:)",
      setting.mass, setting.length, weight * h);
  page.text(
      R"(
      - sweeps, started cold: the first row takes everything (@ and @ N·s), and the second finds no error left;
      - sweeps, started warm from pulls of @ and @ N·s: the first row adds the weight to its own (@ and @ N·s), and
        the two still pull against each other: no row measures that;
      - directly with a regularisation: half each, @ N·s, the solution with the smallest λ.)",
      -lambda(first, 0), without_rounding(-lambda(first, 1), weight * h), -m, m, -lambda(biased, 0),
      -lambda(biased, 1), Value(-sum(shared) / 2, 5));
  page.claim("the same rod twice, regularised: difference of λ over their sum",
             (lambda(shared, 0) - lambda(shared, 1)) / sum(shared), "1", is(0, "half each", absolute(1e-3)));
  for (const auto& [rods, name] :
       {std::pair{&first, "cold"}, std::pair{&biased, "warm, from opposed λ"}, std::pair{&shared, "regularised"}})
    // Two lengths.
    page.claim(say("the same rod twice, @: sum of the pulls", name), -sum(*rods), "N s",
               is(weight * h, "the weight", absolute(1e-6 * weight * h + 1e-12 * m)));
  const Rods start = two_rods(setting, gap, warm), end = after(start, conflict_seconds, h);
  const double steps = std::round(end.time / h);
  const double a_step = sweeps * m * beta * gap / h;  // what a step adds to either λ
  const double grown = opposed(end);
  page.text(
      R"(A repeated row is harmless. Now make one of the rods @ m longer. No position of the bob satisfies both. We
      start warm, with @ a step and β = @, and with the bob at rest.)",
      gap, several(sweeps, "sweep"), setting.beta);
  const double halfway = lambda(after(start, conflict_seconds / 2, h), 1), doubled = lambda(end, 1) / halfway;
  page.choose(
      {.ask = say("Carrying the bob takes @ N·s a step. What does the λ of either rod do within @ s?", weight * h,
                  conflict_seconds),
       .options =
           {{"it stays near the weight's share",
             "The weight is only a small part: in every sweep each row undoes the other's correction."},
            {say("it stays near @ N·s", Value(a_step, 3)),
             "One step adds that much, and the warm start keeps the sum of all steps."},
            {"it grows in proportion to time",
             say("Each step adds as much again, and the warm start keeps the sum: @ N·s after @ s, @ N·s after @ "
                 "s.",
                 Value(halfway, 5), conflict_seconds / 2, Value(lambda(end, 1), 5), conflict_seconds)},
            {"it grows exponentially",
             "It would if each correction were larger than the last; they are all equal."}},
       .answer = doubled > 2.5               ? 3
                 : doubled > 1.5             ? 2
                 : halfway > 10 * weight * h ? 1
                                             : 0,
       .hints = {"Follow one sweep: what does each row find after the other has acted?",
                 "Each row takes back what the other just gave: m β ΔL/h in a sweep.",
                 say("m β ΔL/h = @ N·s. Does a warm start forget it?", m * beta * gap / h)}});
  page.text(
      R"(Follow one sweep. The short rod's row asks for a speed inwards, (β/h)C₁, and gets it by an impulse. For the long
      rod's row this speed is an error, and it takes it back. The bob stands still where the *last* row wants it, and
      in every sweep the two push against each other with)");
  page.formula(
      "Δλ = m β ΔL/h = @ N·s,   times @ a step:   λ grows by @ N·s in each step",
      R"(\Delta\lambda = \frac{m\,\beta\,\Delta L}{h} = @\,\mathrm{N\,s},\qquad \text{times } @ \text{ a step: }
                  \lambda \text{ grows by } @\,\mathrm{N\,s} \text{ in each step})",
      m * beta * gap / h, several(sweeps, "sweep"), a_step);
  page.derivation("What one sweep adds", {{"(17) for the short rod, with b = (β/h)C₁, A = 1/m",
                                           "its speed becomes −(β/h)C₁", R"(-\tfrac{\beta}{h}\,C_1)"},
                                          {"(17) for the long rod, with C₂ = C₁ − ΔL, makes it −(β/h)C₂",
                                           "change of speed: (β/h)(C₁ − C₂) = βΔL/h",
                                           R"(\tfrac{\beta}{h}(C_1 - C_2) = \frac{\beta\,\Delta L}{h})"},
                                          {"impulse = mass times change of speed", "Δλ = m β ΔL/h",
                                           R"(\Delta\lambda = \frac{m\,\beta\,\Delta L}{h})"}});
  const std::vector<Cure> cures{{"warm start", start},
                                {"cold start", two_rods(setting, gap, cold)},
                                {"soft rows", two_rods(setting, gap, warm, softness)},
                                {"regularised", two_rods(setting, gap, Direct{.regularisation = added_share})}};
  // On two logarithmic axes, what grows in proportion to time is a straight line.
  Chart chart{.x = {.label = "time (s)", .scale = Scale::logarithmic},
              .y = {.label = "rod against rod (mg)", .scale = Scale::logarithmic}};
  double most = 0, least = INFINITY;
  for (const Cure& cure : cures) {
    chart.curves.push_back(over_time(cure, setting));
    most = std::max(most, chart.curves.back().y.back());
    least = std::min(least, chart.curves.back().y.back());
  }
  chart.y.range = {{0.2 * least, 4 * most}};
  page.sequence(
      "calm_picture",
      say(R"(@ s of the run. The two rods lie on one another; they are drawn side by side. Dashed: their two lengths.
          Right: rod against rod, half the difference of their forces.)",
          conflict_seconds),
      Frames{frames},
      [film = ConflictFilm{start, length, gap, h, weight, chart}](Canvas& canvas, double frame) mutable {
        film.draw(canvas, frame);
      });
  page.text(
      R"(After @ s the rods act against each other with @ times the bob's weight, and nothing moves. Everything that
      reads λ is then wrong: a joint that breaks above some force, friction with its bound μλ, an arrow in a debugger.
      And if one rod is removed, the other starts its next step with all of that λ. So **to find conflicts watch |λ|,
      not
      the picture**, and bound the growth:)",
      conflict_seconds, Value(grown / h / weight, 3));
  const Rods chilled = after(cures[1].rods, 2, h), soft = after(cures[2].rods, conflict_seconds, h),
             regularised = after(cures[3].rods, conflict_seconds, h);
  const double soft_end = beta * gap / (2 * h * softness),
               regularised_end = beta * gap * m / (2 * h * added_share);
  page.text(
      R"(
      - a *cold start* forgets it in each step: @ N·s, one step's addition and half the weight;
      - *softness* γ lets a rod give way by γλ, so that both rows can be satisfied at λ₂ − λ₁ = βΔL/(hγ): here ± @ N·s@
        for γ = @ 1/kg;
      - a *regularisation* ε is the same with γ = εA for each row: ± @ N·s for ε = @. The bob then stands halfway
        between the two lengths.)",
      Value(opposed(chilled), 4), Value(opposed(soft), 4),
      sweeps * give * steps > 20 ? "" : say(" after @ s, and still growing,", conflict_seconds), softness,
      Value(opposed(regularised), 4), added_share);

  page.measure("rod against rod at the end", grown / h / weight, "mg");
  page.claim(say("λ of the long rod after @ s", conflict_seconds), lambda(end, 1), "N s",
             is(a_step * steps, "law of the conflict: k m β ΔL/h a step", relative(1e-9)));
  page.claim("how far the bob is from where the last row wants it",
             end.scene.bodies().pose[1].position.norm() - (length + gap), "m",
             is(0, "the last row of a sweep has what it asks for",
                absolute(1e-9 * length + 2 * gap * std::pow(1 - beta, steps))),
             Quantity("β", beta) > 0.02);
  page.claim("rod against rod, cold", opposed(chilled), "N s",
             is(a_step + 0.5 * weight * h, "k m β ΔL/h, and the short rod carries the bob", relative(1e-3)),
             Quantity("β", beta) > 0.02);
  page.claim("rod against rod, soft", opposed(soft), "N s", is(soft_end, "βΔL/(2hγ)", relative(1e-3)),
             where(Condition{sweeps * give * steps > 20, "sweeps enough to settle"}, Quantity("β", beta) > 0.02));
  page.claim("rod against rod, regularised", opposed(regularised), "N s",
             is(regularised_end, "βΔL m/(2hε)", relative(1e-6)), Quantity("β", beta) > 0.02);
}

}  // namespace byhand::joints
