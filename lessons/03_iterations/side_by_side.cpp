// Step 7: the same chain with few sweeps, many and all at once.

#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/textbook.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/pictures/acts.hpp"

namespace byhand::iterations {
namespace {

using Chain = Simulation<PlaneParticle>;

constexpr double film_seconds = 5;
constexpr double lost = 50;  // lengths of a link: a chain that is stretched that far is watched no longer
const std::vector<int> compared_sweeps{1, 4, 16, 64};

Chain swinging(const Knobs& knobs, std::optional<int> sweeps, double degrees) {
  ChainOptions options = knobs.chain();
  options.angle = degrees * M_PI / 180;
  VelocityStepping method{.solver = Direct{}, .drift = Baumgarte{knobs.beta}};
  if (sweeps) method.solver = GaussSeidel{.sweeps = *sweeps, .warm_start = knobs.warm()};
  return {rod_chain<PlaneParticle>(options), method};
}

/// The largest | |d| - L | of all links [m].
double stretch(const Chain& chain) {
  double worst = 0;
  const auto& pose = chain.scene.bodies().pose;
  for (const auto& rod : chain.scene.all<Distance>()) {
    const double d = rod.at.separation(pose[rod.at.body1], pose[rod.at.body2]).norm();
    worst = std::max(worst, std::isfinite(d) ? std::abs(d - rod.length) : INFINITY);
  }
  return worst;
}

/// One chain of the comparison: what it is called, how it begins, how it goes.
struct Run {
  std::string name;
  Chain chain;
  renderer::Curve stretch;  // [mm] over time
  double lost_at = INFINITY;
  renderer::Point reach{0, 0};  // farthest to either side, and down
};

Run run_of(std::string name, Chain start, double h, double length) {
  Run run{std::move(name), start, {}};
  run.stretch.label = run.name;
  while (start.time < film_seconds) {
    start.step(h);
    const double now = stretch(start);
    run.stretch.x.push_back(start.time);
    run.stretch.y.push_back(now < lost * length ? std::max(1000 * now, 1e-9) : INFINITY);
    if (now >= lost * length) {
      run.lost_at = start.time;
      break;
    }
    for (const auto& pose : start.scene.bodies().pose)
      run.reach = run.reach.cwiseMax(renderer::Point(std::abs(pose.position.x()), -pose.position.y()));
  }
  return run;
}

double worst(const Run& run) { return *std::max_element(run.stretch.y.begin(), run.stretch.y.end()); }

/// When that was [s].
double peak_at(const Run& run) {
  const auto& y = run.stretch.y;
  return run.stretch.x[static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin())];
}

/// The largest stretch [m] of the chain hanging at rest, started cold in every step, once it has settled.
double settled_stretch(const Knobs& knobs, int sweeps) {
  Chain chain = swinging(knobs, sweeps, 0);
  // The slow wave's errors follow z² - (1 + q - (1 - q)β)z + q = 0; for a link that is far too long C/|d| is half
  // its stretch, and β half as large.
  const double q = laws::left_by_sweeps(knobs.links, sweeps), beta = 0.5 * knobs.beta,
               trace = 1 + q - (1 - q) * beta;
  const double root = trace * trace - 4 * q;
  const double z = root > 0 ? (trace + std::sqrt(root)) / 2 : std::sqrt(q);
  const int steps = 100 + static_cast<int>(std::log(1e-10) / std::log(z));
  for (int i = 0; i < steps; ++i) chain.step(knobs.h);
  return stretch(chain);
}

/// The same from the textbook's matrices: the bias that makes up for what k sweeps leave is as large as the speed
/// at which links part without it, (β/h) C / |d| = that speed, and C = ½(d² - L²).
double textbook_stretch(const Knobs& knobs, int sweeps) {
  const double speed = textbook_cold_errors(knobs.chain(), sweeps, knobs.fall()).maxCoeff(), L = knobs.length;
  const double s = speed * knobs.h / knobs.beta;
  return s + std::sqrt(s * s + L * L) - L;
}

void draw_runs(renderer::Canvas& canvas, const std::vector<Run>& runs, const renderer::Rectangle& world,
               const std::vector<renderer::Point>& right_length, double time, const renderer::Rectangle& frame) {
  const auto cells = frame.cells(1, static_cast<int>(runs.size()), 6);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const renderer::Rectangle& cell = cells[i];
    canvas.look_at_page();
    const renderer::TextStyle bold{.size = 21, .colour = palette::series(static_cast<int>(i)), .bold = true};
    const std::string name = pictures::wrapped(canvas, runs[i].name, cell.width, bold);
    const double lines = name == runs[i].name ? 1 : 2;
    canvas.text({cell.centre().x(), cell.top() - 14 * lines + 2}, name, bold);
    const renderer::Rectangle below{cell.x, cell.y, cell.width, cell.height - 28 * lines};
    const renderer::Camera camera = renderer::fit(world, {below.x, below.y, below.width, below.height - 30}, 4);
    canvas.clip(below);
    canvas.look(camera);
    if (time < runs[i].lost_at) {
      canvas.path(right_length, {palette::muted, 1.5, renderer::Dash::dashed});
      pictures::draw(canvas, pictures::rods_and_bobs(runs[i].chain.scene),
                     {.bob = 6, .rod = 2.6, .bodies = pictures::look_of_run(static_cast<int>(i))});
    } else {
      canvas.look_at_page();
      canvas.text(below.centre(), say("flew apart\nafter @ s", Value(runs[i].lost_at, 2)), {.size = 20});
    }
    canvas.clip({});
  }
  canvas.look_at_page();
}

/// How far two chains whose stretch was largest `peak` [s] are stretched at the end [mm], unless that is said
/// already.
std::string at_the_end(const Value& sweeps, const Value& direct, double peak) {
  if (peak > 0.99 * film_seconds) return {};
  return sweeps.plain() == direct.plain()
             ? say("At @ s both are stretched by @ mm.", film_seconds, direct)
             : say("At @ s its stretch is @ mm, the direct chain's @ mm.", film_seconds, sweeps, direct);
}

/// What stretches the chain with the most sweeps: they, if the direct chain stretches less than half as far.
void ask_what_stretches(Page& page, const Knobs& knobs, const std::vector<Run>& runs) {
  const Run &swept = runs[compared_sweeps.size() - 1], &direct = runs.back();
  const int sweeps = compared_sweeps.back();
  const double left = laws::left_by_sweeps(knobs.links, sweeps);
  const bool sweeps_leave_more = std::isinf(direct.lost_at) && worst(swept) > 2 * worst(direct);
  const auto told = [](const Run& run) {
    return std::isinf(run.lost_at) ? say("stretches by @ mm", Value(worst(run), 2)) : std::string("flies apart");
  };
  const std::string found = say("Solved directly it @, with @ sweeps it @.", told(direct), sweeps, told(swept));
  page.choose(
      {.ask = say("What stretches the links most with @ sweeps a step?", sweeps),
       .options =
           {{"the error that the sweeps leave",
             sweeps_leave_more ? found : say("The direct solve leaves none, and the chain @ too.", told(direct))},
            {"the step, which leaves the circle (lesson 2)",
             sweeps_leave_more ? say("So it does when solved directly, and then it @.", told(direct)) : found},
            {"nothing", "Each step moves along a tangent, whatever λ is."}},
       .answer = sweeps_leave_more ? 0 : 1,
       .hints = {"A chain whose rows are solved exactly has one of the two causes left.",
                 say("@ cold sweeps leave q = ρᵏ@ of the slow wave (step 6).", sweeps,
                     left < 1e-6 ? ", next to nothing," : say(" = @", Value(left, 2)))}});
}

}  // namespace

void side_by_side(Page& page, const Knobs& knobs) {
  const double h = knobs.h, L = knobs.length;
  std::vector<Run> runs;
  for (const int sweeps : compared_sweeps)
    runs.push_back(
        run_of(say(sweeps == 1 ? "@ sweep" : "@ sweeps", sweeps), swinging(knobs, sweeps, knobs.angle), h, L));
  runs.push_back(run_of("direct", swinging(knobs, {}, knobs.angle), h, L));

  renderer::Rectangle world{0, 0, 0, 0};
  renderer::Chart chart;
  chart.x.label = "time (s)";
  chart.y = {.label = "largest stretch (mm)", .scale = renderer::Scale::logarithmic};
  renderer::Point reach{0, 0};
  for (const Run& run : runs) {
    chart.curves.push_back(run.stretch);
    if (std::isinf(run.lost_at)) reach = reach.cwiseMax(run.reach);
  }
  reach = reach.cwiseMin(renderer::Point::Constant(3 * knobs.links * L)) + renderer::Point::Constant(0.4 * L);
  double least = INFINITY, most = 0;
  for (const Run& run : runs) {
    least = std::min(least, worst(run));
    if (std::isinf(run.lost_at)) most = std::max(most, worst(run));
  }
  if (std::isinf(least)) least = most = 1000 * L;  // all flew apart
  chart.y.range = {{0.02 * least, 3 * std::max(most, least)}};
  world = {-reach.x(), -reach.y(), 2 * reach.x(), reach.y()};  // anchors are above
  std::vector<renderer::Point> right_length;  // as far as the end of a chain that does not stretch can be
  for (double part = -1; part <= 1.001; part += 0.05)
    right_length.emplace_back(knobs.links * L * from_straight_down<PlaneParticle>(part * M_PI / 2));

  page.text(
      R"(Now let it swing for @ s from @°, @. The same chain five times, started @; only the number of sweeps a step
      differs, and the last one solves all rows at once.)",
      film_seconds, knobs.angle,
      knobs.beta > 0 ? say("with the correction of lesson 4 pulling stretched links back (β = @)", knobs.beta)
                     : "without any correction (β = 0)",
      knobs.warm() ? "warm" : "cold");
  ask_what_stretches(page, knobs, runs);
  page.sequence(
      "sweeps_side_by_side",
      say(R"(@, @, @ and @ sweeps a step, and solved directly. Below: the largest stretch of any link. Dashed:
          the reach of an inextensible chain.)",
          compared_sweeps[0], compared_sweeps[1], compared_sweeps[2], compared_sweeps[3]),
      Seconds{film_seconds}, [=, runs = runs](renderer::Canvas& canvas, double time) mutable {
        for (Run& run : runs)
          while (run.chain.time < time - 0.5 * h && run.chain.time < run.lost_at) run.chain.step(h);
        const auto [upper, lower] = canvas.page().inset(14).split_rows(0.62, 8);
        draw_runs(canvas, runs, world, right_length, time, upper);
        draw(canvas, pictures::grown_to(chart, time), lower);
      });
  for (const Run& run : runs) {
    if (std::isinf(run.lost_at))
      page.measure(say("largest stretch, @", run.name), worst(run), "mm");
    else
      page.text("The chain @ flew apart after @ s (× in the chart).",
                &run == &runs.back() ? std::string("solved directly") : say("with @ a step", run.name),
                Value(run.lost_at, 2));
  }
  const Run &fewest = runs.front(), &direct = runs.back();
  const Run& most_sweeps = runs[compared_sweeps.size() - 1];
  const double both_at = peak_at(direct);
  if (std::isinf(direct.lost_at) && std::abs(worst(most_sweeps) / worst(direct) - 1) < 0.1 &&
      std::abs(peak_at(most_sweeps) - both_at) < 0.1)
    page.text(
        "With @ the largest stretch is no longer the sweeps' fault: at @ s the direct solve stretches as far. @",
        several(compared_sweeps.back(), "sweep"), Value(both_at, 2),
        at_the_end(Value(most_sweeps.stretch.y.back(), 2), Value(direct.stretch.y.back(), 2), both_at));
  const bool softer = worst(fewest) > 1.1 * worst(direct);
  if (knobs.warm() && knobs.beta > 0) {
    std::vector<double> limits;
    for (const int sweeps : compared_sweeps)
      limits.push_back(laws::largest_beta(laws::left_by_sweeps(knobs.links, sweeps)));
    const auto beyond = std::count_if(limits.begin(), limits.end(), [&](double at) { return at < knobs.beta; });
    page.text(
        R"(With a warm start β must stay below min((1 − q)/q, 2) (lesson 4, step 6b): @ for these sweeps. β = @ is @)",
        limits, knobs.beta,
        beyond == 0 ? std::string("below all four.")
                    : say("above @; there the correction makes the chain ring instead of bringing it to rest.",
                          beyond == 1   ? std::string("the first")
                          : beyond == 4 ? std::string("all four")
                                        : std::string(beyond == 2 ? "the first two" : "the first three")));
  } else if (std::isfinite(direct.lost_at)) {
    page.text("Here even the chain whose rows are solved exactly flies apart, so sweeps are not the reason.");
  } else if (!softer) {
    page.text("On this chain even @ a step stretches it hardly more than the direct solve does.",
              several(compared_sweeps.front(), "sweep"));
  } else if (knobs.beta > 0) {
    page.text(
        R"(Few sweeps make the chain *soft*, like a rubber band, by an amount that can be computed. Where the chain hangs
        still, the correction must make up in each step for what the sweeps leave: a bias of the same size meets the
        speed of stretching s of step 6, (β/h)C/|d| = s. So the worst link is too long by about s·h/β.)");
  } else if (!knobs.warm()) {
    page.text(
        R"(With β = 0 nothing pulls stretched links back: with few sweeps the links separate at the speed s of step 6 and
        go on separating.)");
  }
  for (const int sweeps : compared_sweeps) {
    if (knobs.warm() || knobs.beta < 0.01) break;  // nothing is settled
    const double smallest = 1e-6 * L, expected = textbook_stretch(knobs, sweeps);
    const Condition claimed{expected > smallest && expected < L, "stretch from 10⁻⁶ L to L"};
    page.claim(say("stretch at rest, sweeps a step: @", sweeps), claimed ? settled_stretch(knobs, sweeps) : 0, "m",
               is(claimed ? expected : 0, "(β/h) C/|d| = (1 − Sᵏ)⁻¹Sᵏ gh, S as in step 6", absolute(smallest)),
               claimed);
  }
  if (std::isinf(direct.lost_at))
    page.text(
        R"(Solved directly, each step's rows hold to rounding. Only the step itself, which leaves the circle
        (lesson 2), still stretches the chain. So when a chain is soft, find out why: too few sweeps, or too large a step?)");
  else
    page.text(
        R"(The time step makes it fly apart: the tension turns light links into springs that are too stiff for h (lesson 8).
        Smaller steps help, more sweeps do not.)");
}

}  // namespace byhand::iterations
