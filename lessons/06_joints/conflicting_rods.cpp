// Step 7: rods that say the same, and rods that contradict each other.

#include <cmath>

#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::joints {
namespace {

using namespace tutor;
using namespace renderer;
using Rods = Simulation<PlaneParticle>;

constexpr double conflict_seconds = 10;           // [s]
constexpr double added_share = 0.01, give = 0.1;  // of each row's A: what the regularisation and the softness add
constexpr int frames = 36;

/// A bob that hangs from two rods between the same two points, one longer by `gap` [m].
Rods two_rods(const Setting& setting, double gap, const RowSolver& solver, double softness = 0) {
  const double length = setting.length();
  Rods rods{pendulum<PlaneParticle, NormalisedDistance>(0, length, setting.mass),
            {solver, Baumgarte{setting.beta}}};
  auto& scene = rods.scene;
  scene.add(NormalisedDistance<PlaneParticle>{{0, 1}, length + gap});
  scene.change_all<NormalisedDistance>([&](auto& rod) { rod.softness = softness; });
  return rods;
}

double lambda(const Rods& rods, int rod) { return rods.work.system.lambda[rods.work.system.row_of[rod]]; }

/// How much the two rods pull against each other: half the difference of what they push with [N s].
double quarrel(const Rods& rods) { return 0.5 * (lambda(rods, 1) - lambda(rods, 0)); }

struct Cure {
  std::string name;
  Rods rods;
};

Curve over_time(const Cure& cure, const Setting& setting) {
  Curve curve{.label = cure.name};
  Rods rods = cure.rods;
  advance_to(rods, conflict_seconds, setting.h, [&] {
    curve.x.push_back(rods.time);
    curve.y.push_back(quarrel(rods) / setting.h / (setting.mass() * gravity));
  });
  return curve;
}

void draw_rods(Canvas& canvas, const Rods& rods, double length, double gap, const Rectangle& frame) {
  const double apart = 0.09 * length;  // the rods are one line; drawn side by side they can be told apart
  canvas.look(fit({-0.6 * length, -1.3 * (length + gap), 1.2 * length, 1.45 * (length + gap)}, frame, 6));
  const Point bob = rods.scene.bodies().pose[1].position;
  canvas.anchor({0, 0});
  for (const auto& [side, colour] : {std::pair{-1, palette::constraint}, std::pair{1, palette::series(1)}}) {
    const Point off(side * apart, 0);
    canvas.rod(off, bob + off, {colour, {palette::ink, 0}}, 7);
  }
  canvas.rod({-1.4 * apart, 0}, {1.4 * apart, 0}, body_look, 12);
  canvas.rod(bob - Point(1.4 * apart, 0), bob + Point(1.4 * apart, 0), body_look, 12);
  canvas.disc(bob - Point(0, 0.16 * length), 0.12 * length);
  canvas.line({-0.5 * length, -length}, {0.5 * length, -length}, {palette::constraint, 1.6, Dash::dashed});
  canvas.line({-0.5 * length, -length - gap}, {0.5 * length, -length - gap},
              {palette::series(1), 1.6, Dash::dashed});
  canvas.look_at_page();
}

struct ConflictFilm {
  Rods rods;
  double length, gap, h, weight;
  Chart beside;

  void draw(Canvas& canvas, double frame) {
    const double time = conflict_seconds * frame / (frames - 1);
    advance_to(rods, time, h);
    const auto [left, right] = canvas.page().inset(16).split_columns(0.36, 20);
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
    canvas.text({left.x + 10, left.y + 40}, says(0),
                {.size = 19, .colour = palette::constraint, .anchor = Anchor::left});
    canvas.text({left.x + 10, left.y + 12}, says(1),
                {.size = 19, .colour = palette::series(1), .anchor = Anchor::left});
    renderer::draw(canvas, pictures::grown_to(beside, time), right.inset(0, 40));
  }
};

}  // namespace

void conflicting_rods(const Setting& setting, Page& page) {
  const double h = setting.h(), beta = setting.beta(), m = setting.mass(), length = setting.length(),
               gap = setting.gap(), weight = m * gravity;
  const int sweeps = setting.sweeps(), steps = static_cast<int>(std::lround(conflict_seconds / h));
  const double softness = give / m;
  const GaussSeidel warm{.sweeps = sweeps}, cold{.sweeps = sweeps, .warm_start = false};

  // The same rod twice.
  Rods first = two_rods(setting, 0, cold), biased = two_rods(setting, 0, warm),
       shared = two_rods(setting, 0, Direct{.regularisation = 1e-6});
  biased.step(h);
  biased.work.system.lambda = {m, -m};  // any quarrel that makes no sum
  for (Rods* rods : {&first, &biased, &shared}) advance_to(*rods, 1, h);
  const auto sum = [](const Rods& rods) { return lambda(rods, 0) + lambda(rods, 1); };
  page.text(
      R"(Hang a bob of @ kg not from one rod of @ m but from two, between the same two points. Their rows are the
      same row, and A = (1/m)[1 1; 1 1] has no inverse. What is asked of λ is only that the *sum* carries the
      weight, mgh = @ N·s; how the two share it is anybody's guess, and each solver has its own:)",
      setting.mass, setting.length, weight * h);
  page.text(
      R"(
      - sweeps, started cold: the first row takes everything (@ and @ N·s), for when it is done the second finds
        nothing wrong;
      - sweeps, started warm from λ = (@, @): they stay in quarrel (@ and @ N·s), for nobody sees a difference;
      - directly with a regularisation: half each (@ and @ N·s), the least λ that will do.)",
      -lambda(first, 0), -lambda(first, 1), m, -m, lambda(biased, 0), lambda(biased, 1), -lambda(shared, 0),
      -lambda(shared, 1));
  for (const auto& [rods, name] :
       {std::pair{&first, "cold"}, std::pair{&biased, "warm, in quarrel"}, std::pair{&shared, "regularised"}})
    page.claim({.quantity = say("the same rod twice, @: sum of λ", name),
                .unit = "N s",
                .expected = -weight * h,
                .source = "the weight, whoever carries it",
                .measured = sum(*rods),
                .tolerance = absolute(1e-6 * weight * h + 1e-12 * m)});

  // Two lengths.
  const Rods start = two_rods(setting, gap, warm), end = after(start, conflict_seconds, h);
  const double a_step = sweeps * m * beta * gap / h;  // what a step adds to either λ
  const double grown = quarrel(end);
  page.text(
      R"(A repeated row is harmless. Now make one of them @ m longer. No place of the bob suits both: each row's C
      tells the other that it is wrong. Warm start, @ sweeps a step, β = @, and the bob starts at rest.)",
      gap, sweeps, setting.beta);
  const double halfway = lambda(after(start, conflict_seconds / 2, h), 1), doubled = lambda(end, 1) / halfway;
  page.choose(
      {.ask = say("To carry the bob takes @ N·s a step. What does the λ of either rod do within @ s?", weight * h,
                  conflict_seconds),
       .options =
           {{"it stays near that",
             "The bob's weight is the least of it: each row finds the other's length wrong, in every sweep."},
            {say("it is some @ N·s, and stays so", Value(a_step, 3)),
             "That is what one step adds; warm start keeps the sum. Look at λ, not at the picture."},
            {"it grows in proportion to time",
             say(R"(Each step corrects the other's correction, and warm start keeps the sum: @ N·s after @ s, @ N·s
                 after @ s.)",
                 Value(halfway, 5), conflict_seconds / 2, Value(lambda(end, 1), 5), conflict_seconds)},
            {"it explodes", "It would if each correction were larger than the last; they are all the same."}},
       .answer = doubled > 2.5               ? 3
                 : doubled > 1.5             ? 2
                 : halfway > 10 * weight * h ? 1
                                             : 0,
       .hints = {say("In every sweep either row takes back what the other just gave: m β ΔL/h = @ N·s.",
                     m * beta * gap / h)}});
  page.text(
      R"(Follow one sweep. The short rod's row asks for a speed inwards, (β/h)C₁, and gets it by an impulse. The
      long one's row finds its own C₂ violated by that speed, and takes it back. The bob stands still where the
      *last* row wants it; in every sweep the two have pushed against each other with)");
  page.formula("Δλ = m β ΔL/h = @ N·s,   @ sweeps a step:   λ grows by @ N·s a step, without end",
               R"(\Delta\lambda = \frac{m\,\beta\,\Delta L}{h} = @\,\mathrm{N\,s},\qquad @ \text{ sweeps a step: }
                  \lambda \text{ grows by } @\,\mathrm{N\,s} \text{ a step, without end})",
               m * beta * gap / h, sweeps, a_step);
  const std::vector<Cure> cures{{"warm start", start},
                                {"cold start", two_rods(setting, gap, cold)},
                                {"soft rows", two_rods(setting, gap, warm, softness)},
                                {"regularised", two_rods(setting, gap, Direct{.regularisation = added_share})}};
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "rod against rod (mg)", .scale = Scale::logarithmic}};
  double most = 0, least = INFINITY;
  for (const Cure& cure : cures) {
    chart.curves.push_back(over_time(cure, setting));
    most = std::max(most, chart.curves.back().y.back());
    least = std::min(least, chart.curves.back().y.back());
  }
  chart.y.range = {{0.2 * least, 4 * most}};
  page.sequence("calm_picture",
                say(R"(Ten seconds in @ frames: two rods, drawn side by side, one for each dashed length. The bob
                    stands. Right: with what force they push and pull against each other.)",
                    frames),
                Frames{frames},
                [film = ConflictFilm{start, length, gap, h, weight, chart}](Canvas& canvas, double frame) mutable {
                  film.draw(canvas, frame);
                });
  page.text(
      R"(After @ s the rods fight with @ times the bob's weight, and nothing moves. What reads λ is misled: a joint
      that breaks above some force, a friction whose bound is μλ, an arrow in a debugger. And when a rod is taken
      away, the other begins its next step with all of that. So **test for conflicts by |λ|, not by looking**, and
      give the quarrel an end:)",
      conflict_seconds, Value(grown / h / weight, 3));
  const Rods chilled = after(cures[1].rods, 2, h), soft = after(cures[2].rods, conflict_seconds, h),
             regularised = after(cures[3].rods, conflict_seconds, h);
  const double soft_end = beta * gap / (2 * h * softness),
               regularised_end = beta * gap * m / (2 * h * added_share);
  page.text(
      R"(
      - a *cold start* forgets it each step: @ N·s, what one step adds and half the weight;
      - *softness* γ lets a rod give way by γλ, so that both can be content: λ₂ − λ₁ = βΔL/(hγ), here ± @ N·s for γ
        = @ 1/kg;
      - a *regularisation* ε is the same with γ = εA for each row: ± @ N·s for ε = @. The bob then stands halfway
        between the two lengths, which is the fairest answer to a question that has none.)",
      Value(quarrel(chilled), 4), Value(quarrel(soft), 4), softness, Value(quarrel(regularised), 4), added_share);

  page.measure("rod against rod at the end", grown / h / weight, "mg");
  page.claim({.quantity = say("λ of the long rod after @ s", conflict_seconds),
              .unit = "N s",
              .expected = a_step * steps,
              .source = "law B8: k m β ΔL/h a step",
              .measured = lambda(end, 1),
              .tolerance = relative(1e-9)});
  page.claim({.quantity = "how far the bob is from where the last row wants it",
              .unit = "m",
              .expected = 0,
              .source = "the last row of a sweep is always content",
              .measured = end.scene.bodies().pose[1].position.norm() - (length + gap),
              .tolerance = absolute(1e-9 * length + 2 * gap * std::pow(1 - beta, steps)),
              .claimed = beta > 0.02,
              .range = "β > 0.02"});
  page.claim({.quantity = "rod against rod, cold",
              .unit = "N s",
              .expected = a_step + 0.5 * weight * h,
              .source = "k m β ΔL/h, and the short rod carries the bob",
              .measured = quarrel(chilled),
              .tolerance = relative(1e-3),
              .claimed = beta > 0.02,
              .range = "β > 0.02"});
  page.claim({.quantity = "rod against rod, soft",
              .unit = "N s",
              .expected = soft_end,
              .source = "βΔL/(2hγ)",
              .measured = quarrel(soft),
              .tolerance = relative(1e-3),
              .claimed = sweeps * give * steps > 20 && beta > 0.02,
              .range = "sweeps enough to settle, β > 0.02"});
  page.claim({.quantity = "rod against rod, regularised",
              .unit = "N s",
              .expected = regularised_end,
              .source = "βΔL m/(2hε)",
              .measured = quarrel(regularised),
              .tolerance = relative(1e-6),
              .claimed = beta > 0.02,
              .range = "β > 0.02"});
}

}  // namespace byhand::joints
