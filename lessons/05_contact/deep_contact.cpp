// Step 2: an overlap, and the speed at which it leaves.

#include "lessons/05_contact/steps.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/pictures/acts.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double pop_seconds = 1.5, deepest = 0.4;  // [s], [m]

/// A unit box that begins `depth` [m] deep in the ground.
Simulation<PlaneBody> sunk(double depth, const DriftCure& cure) {
  Simulation<PlaneBody> simulation{stack(1), {GaussSeidel{}, cure}};
  simulation.scene.set_position(1, simulation.scene.bodies().pose[1].position - Linear<PlaneBody>(0, depth));
  return simulation;
}

/// How far its lower side is above the ground [m].
double clearance(const Simulation<PlaneBody>& simulation) {
  return simulation.scene.bodies().pose[1].position.y() - 0.5;
}

/// Its highest point above the ground, or 0 if it stays down [m].
double peak(Simulation<PlaneBody> simulation, double h) {
  double highest = 0;
  do {
    simulation.step(h);
    highest = std::max(highest, clearance(simulation));
  } while (simulation.time < pop_seconds || simulation.scene.bodies().velocity[1].y() > gravity * h);
  return highest < 1e-11 ? 0 : highest;
}

/// The same step by step [m]: after n steps a throw at v = βd/h is at −d + h(nv − ghn(n − 1)/2), and the least d
/// that brings it above the ground at some n counts.
double pop_by_steps(double beta, double h) {
  double least = INFINITY;
  for (double n = std::floor(1 / beta) + 1; n < 3 / beta + 2; ++n)
    if (beta * n > 1) least = std::min(least, gravity * h * h * n * (n - 1) / (2 * (beta * n - 1)));
  return least;
}

/// The speed at which that depth leaves: what is slower does not get off the ground [m/s].
double harmless_speed(double beta, double h) { return beta / h * pop_by_steps(beta, h); }

double measured_pop(double beta, double h) {
  double stays = 0.5 * laws::popping_overlap(beta, h), pops = 1.5 * laws::popping_overlap(beta, h);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (stays + pops);
    (peak(sunk(middle, Baumgarte{beta}), h) > 0 ? pops : stays) = middle;
  }
  return 0.5 * (stays + pops);
}

/// The peak of a throw at v = βd/h from where the first step ends, in steps of symplectic Euler [m].
double law_of_peak(double depth, double beta, double h) {
  const double v = beta * depth / h, n = std::floor(v / (gravity * h)) + 1;
  return -depth + h * (n * v - gravity * h * n * (n - 1) / 2);
}

struct NamedBox {
  std::string name;
  Simulation<PlaneBody> box;
};

/// Heights over time, one curve for each run.
Chart heights(const std::vector<NamedBox>& runs, double h) {
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "height of the lower side (m)"}};
  for (NamedBox run : runs) {
    Curve curve{.label = run.name, .x = {0}, .y = {clearance(run.box)}};
    while (run.box.time < pop_seconds) {
      run.box.step(h);
      curve.x.push_back(run.box.time);
      curve.y.push_back(clearance(run.box));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = 0, .label = "ground"});
  return chart;
}

void draw_runs(Canvas& canvas, const std::vector<NamedBox>& runs, const Rectangle& frame, double top) {
  const auto cells = frame.cells(1, static_cast<int>(runs.size()), 12);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Rectangle below{cells[i].x, cells[i].y, cells[i].width, cells[i].height - 54};
    canvas.look_at_page();
    const TextStyle bold{.size = 16, .colour = palette::series(static_cast<int>(i)), .bold = true};
    canvas.text({cells[i].centre().x(), cells[i].top() - 24},
                pictures::wrapped(canvas, runs[i].name, cells[i].width, bold), bold);
    canvas.clip(below);
    canvas.look(fit({-0.7, -0.5, 1.4, top + 0.6}, below, 0));
    pictures::Shapes shapes = pictures::shapes_of(runs[i].box.scene);
    for (auto& box : shapes.boxes) box.look = pictures::look_of_run(static_cast<int>(i));
    pictures::draw(canvas, shapes);
    canvas.clip({});
  }
  canvas.look_at_page();
}

Chart peaks(const Setting& setting) {
  const double h = setting.h();
  Chart chart{.x = {.label = "overlap at the start (m)"}, .y = {.label = "peak above the ground (m)"}};
  for (const double beta : {0.5 * setting.beta(), setting.beta(), std::min(1.0, 2 * setting.beta())}) {
    const double limit = pop_by_steps(beta, h);
    Curve measured{.label = say("β = @", Value(beta, 2)), .style = CurveStyle::markers},
        law{.style = CurveStyle::theory};
    for (int i = 1; i <= 10; ++i) {
      measured.x.push_back(deepest * i / 10);
      measured.y.push_back(peak(sunk(measured.x.back(), Baumgarte{beta}), h));
    }
    for (int i = 4; i <= 40; ++i) {
      const double depth = deepest * i / 40;
      if (i > 4 && limit > law.x.back() && limit < depth) law.x.push_back(limit), law.y.push_back(0);
      law.x.push_back(depth);
      law.y.push_back(depth > limit ? law_of_peak(depth, beta, h) : 0);
    }
    if (beta == setting.beta() && limit < deepest)
      chart.references.push_back(
          {Reference::Across::x, limit, say("limit for β = @: @ m", Value(beta, 2), Value(limit, 4))});
    chart.curves.push_back(measured);
    chart.curves.push_back(law);
  }
  chart.curves.back().label = "a throw at βd/h";
  return chart;
}

}  // namespace

void deep_contact(const Setting& setting, Page& page) {
  const double h = setting.h(), beta = setting.beta(), depth = setting.depth, cap = setting.cap;
  const double law = laws::popping_overlap(beta, h), by_steps = pop_by_steps(beta, h), speed = beta * depth / h;
  const Simulation<PlaneBody> free_run = sunk(depth, Baumgarte{beta}),
                              capped = sunk(depth, Baumgarte{.beta = beta, .speed_cap = cap}),
                              split = sunk(depth, SplitImpulse{.beta = beta}),
                              soft = sunk(depth, SoftConstraints{});
  Simulation<PlaneBody> first = free_run;
  first.step(h);
  const double leaves_at = first.scene.bodies().velocity[1].y();
  const double highest = peak(free_run, h), highest_capped = peak(capped, h), highest_split = peak(split, h),
               highest_soft = peak(soft, h);

  page.text(
      R"(Where C is positive there is a gap: the row lets it close within the step and no further, b = C/h. Such a row is
      called a *speculative contact*: it exists before the bodies touch, so even a fast body cannot pass through a thin
      wall between two steps. Its price is the ghost collision: the row knows a plane but not where the face ends, and
      would stop a body that flies past the edge. So the solver only takes a plane from shapes that will meet within
      the step, and at the place where they will meet.)");
  page.text(
      R"(Where C is negative, two bodies overlap, and (22) separates them as it did with rods. But a rod also pulls
      back; nothing pulls back a box that moves out of the ground. Here β is the share *per step*, so the rate is β/h
      (lesson 4):)");
  page.equation(22, "JV = −(β/h)·C = −(@/(@ s))·(−@ m) = @ m/s",
                R"(JV = -\frac{\beta}{h}\,C = -\frac{@}{@\,\mathrm{s}}\cdot(-@\,\mathrm{m}) = @\,\mathrm{m/s})",
                setting.beta, setting.h, setting.depth, speed);
  const double throw_height = speed * speed / (2 * gravity), half_step = speed * h / 2;
  // A throw in whole steps misses its top by up to gh²/8.
  const double tolerance = highest > 0 ? std::max(0.02 * highest, std::min(gravity * h * h / 4, 0.4 * highest))
                                       : 0.02 * depth + gravity * h * h / 4;
  std::vector<WrongAnswer> wrong;
  if (std::abs(throw_height - highest) > 2 * tolerance)
    wrong.push_back({throw_height, say("The throw begins @ m below the ground.", setting.depth)});
  page.predict(
      {.ask = say(
           R"(A unit box begins at rest, @ m deep in the ground; β = @, h = @ s, and it leaves at the speed above.
                  How high does its lower side rise above the ground? (0 if it stays below.))",
           setting.depth, setting.beta, setting.h),
       .answer = highest,
       .unit = "m",
       .tolerance = tolerance,
       .wrong = wrong,
       .hints = {"It is thrown upwards from that depth. How high does a throw rise?",
                 "v²/(2g) less the depth, plus ½hv: the first step moves at the full v.",
                 say("(@ m/s)²/(2 · 9.81 m/s²) + @ m = @ m, and it begins @ m deep.", Value(speed, 4),
                     Value(half_step, 3), Value(throw_height + half_step, 4), setting.depth)},
       .hinted = std::max(0.0, throw_height + half_step - depth),
       .right =
           highest > 0
               ? say("Its lower side rises @ m above the ground: v²/(2g) less the depth, plus ½hv, because the "
                     "first step moves at the full v.",
                     Value(highest, 3))
               : "Gravity and the next corrections stop it at the surface or below."});
  page.text(
      R"(Once it moves freely the box is a stone thrown upwards at βd/h, d being its depth. In the first step it rises by
      βd; after that gravity takes gh from its speed in each step. Its highest point is above the ground if)");
  page.formula("d > (1 − β/2) · 2gh²/β² = @ m",
               R"(d > \left(1-\tfrac{\beta}{2}\right)\frac{2 g h^2}{\beta^2} = @\,\mathrm{m})", law);
  page.derivation(
      "From which depth a box pops off the ground",
      {{"(22): the speed after the first step", "v = βd/h", R"(v = \beta d/h)"},
       {"after n steps, each with gh less", "y = −d + h(n v − gh n(n − 1)/2)",
        R"(y = -d + h\Bigl(n v - gh\,\frac{n(n-1)}{2}\Bigr))"},
       {"largest y, as if n = v/(gh) + ½ were a whole number", "y = −d + ½gh² (v/(gh) + ½)²",
        R"(y = -d + \tfrac12 gh^2\Bigl(\frac{v}{gh} + \tfrac12\Bigr)^2)"},
       {"insert v, and x = βd/(gh²)", "y > 0  ⟺  (x + ½)² > 2x/β", R"(y > 0 \iff (x+\tfrac12)^2 > 2x/\beta)"},
       {"the largest root of x² + (1 − 2/β)x + ¼ = 0, without the small ¼", "x > 2/β − 1", R"(x > 2/\beta - 1)"},
       {"back to d", "d > (1 − β/2) 2gh²/β²", R"(d > (1-\tfrac{\beta}{2})\frac{2gh^2}{\beta^2})"}});
  page.text(R"(With n a whole number the limit is @ m. @)", Value(by_steps, 4),
            page.verdict({{.when = Quantity("limit", by_steps, "m") > Quantity("deepest overlap", deepest, "m"),
                           .say = say("No overlap of this lesson, up to @ m, is as deep as that.", deepest)},
                          {.when = within(3,
                                          Quantity("limit/limit with twice the β",
                                                   by_steps / pop_by_steps(std::min(1.0, 2 * beta), h)),
                                          5),
                           .say = "Doubling β makes a box pop from about a quarter of the depth."}}));
  const double shallow = std::min(0.8 * by_steps, deepest);
  std::vector<NamedBox> runs{{say("@ m deep", depth), free_run},
                             {say("@ m, ≤ @ m/s", depth, cap), capped},
                             {say("@ m, split", depth), split},
                             {say("@ m, soft", depth), soft}};
  // A box that begins where it does not pop, unless that is too shallow to be seen.
  const bool seen = shallow >= 0.005;
  if (seen) runs.insert(runs.begin(), {say("@ m deep", Value(shallow, 2)), sunk(shallow, Baumgarte{beta})});
  const Chart chart = heights(runs, h);
  const Curve& unlimited = chart.curves[seen ? 1 : 0];
  const double filmed = *std::max_element(unlimited.y.begin(), unlimited.y.end());
  const double top = std::max(1.2, 1.1 + std::min(4.0, highest));
  const double from_shallow = seen ? peak(runs[0].box, h) : 0;
  std::string rises;
  if (std::max({highest, highest_capped, highest_split, highest_soft, from_shallow}) < 1e-9) {
    rises = say("None of the @ leaves it.", runs.size());
  } else {
    if (from_shallow > 0)
      rises = say("From @ m a box rises @ m above it. ", Value(shallow, 2), Value(from_shallow, 3));
    else if (seen)
      rises = say("A box @ m deep does not leave it. ", Value(shallow, 2));
    rises += say("From @ m a box rises @ m above it@. ", setting.depth, Value(highest, 3),
                 filmed < highest - 0.01 ? say(" (@ m when the film ends)", Value(filmed, 3)) : "");
    const std::string limited = say("With the correction's speed limited to @ m/s", setting.cap);
    rises += highest_capped > 1e-9 ? say("@ it rises @ m; with", limited, Value(highest_capped, 3))
                                   : limited + ", with";
    rises += " split impulse or a soft contact it does not leave it.";
  }
  page.sequence("pop", say("Boxes come out of the ground, β = @. @", setting.beta, rises), Seconds{pop_seconds},
                [=, runs = runs](Canvas& canvas, double time) mutable {
                  for (NamedBox& run : runs)
                    while (run.box.time < time - 0.5 * h) run.box.step(h);
                  const auto [left, right] = canvas.page().inset(16).panels(0.6, 20);
                  draw_runs(canvas, runs, left, top);
                  renderer::draw(canvas, pictures::grown_to(chart, time), right.lowered(60));
                });
  const Condition cannon = Quantity("βd/h", speed, "m/s") > 20;
  if (cannon)
    page.text(page.verdict({{.when = cannon,
                             .say = say(R"(At @ m/s this correction is a cannon. β/h is a speed for each metre of
                                      overlap, so half the step doubles it.)",
                                        Value(speed, 3))}}));
  if (pop_by_steps(std::min(1.0, 2 * beta), h) < deepest)
    page.figure(
        "pop_over_depth",
        say("How high a box rises above the ground, against its initial depth, h = @ s. Lines: a throw at βd/h.",
            setting.h),
        peaks(setting));
  page.text(R"(Four cures are in use.

            - A *smaller β*: the speed and the peak fall, but an overlap also lasts longer.
            - A *limit* on the speed that the correction may ask for: @.
            - *Split impulse*, a method of its own.
            - *Soft contacts*: a damped spring of @ rad/s takes the place of β, and after the bodies have moved the rows
              are solved again without it (lesson 6, step 7b; Box2D 3). That takes the spring's velocity back.)",
            by_steps > deepest
                ? std::string("here no overlap needs one")
                : say("below @ m/s, the speed of a box at the limiting depth, no box rises above the ground",
                      Value(harmless_speed(beta, h), 3)),
            SoftConstraints{}.frequency);
  page.text(
      R"(Split impulse keeps the correction out of V. Its recipe:

      - solve the rows with b = 0 where bodies overlap (and b = C/h at a gap), as if there were nothing to correct;
      - keep a copy of V and λ;
      - solve the rows again with b = (β/h)C: that adds a pseudo-velocity P to V;
      - move the bodies by h(V + P);
      - put the copies back: P is forgotten.

      Its knob is β, as before. No overlap can throw a body, because none of the correction's velocity is left after the
      step, and a warm start does not remember it either. The price is a second solve of all rows. Split impulse does
      not make JV = 0 more accurate, and it does not help where forces are too large for the step (lesson 8).)");
  page.text(
      R"(Engines also leave a few millimetres of overlap uncorrected, the *slop*, for another reason: a resting contact
      that is corrected completely opens every few steps and has to be found again.)");

  page.measure("peak above the ground", highest, "m");
  page.claim("speed at which it leaves", leaves_at, "m/s", is(speed, "βd/h, (22)", relative(1e-12)));
  const Condition shallow_law = Quantity("1.5 (1 − β/2)·2gh²/β²", 1.5 * law, "m") < deepest;
  const double popped = shallow_law ? measured_pop(beta, h) : NAN;
  page.claim("depth from which it pops off the ground", popped, "m",
             is(by_steps, "a throw at βd/h, step by step", absolute(1e-6 * by_steps + 1e-10)), shallow_law);
  const double u = 2 / beta - 1;
  page.claim("the same beside the law for many steps", popped, "m",
             is(law, "law of the pop: (1 − β/2)·2gh²/β², x at most ¼ too large",
                relative(1 - 0.5 * (1 + std::sqrt(1 - 1 / (u * u))) + 1e-6)),
             both(shallow_law, Quantity("β", beta) <= 0.5));
  page.claim("peak above the ground", highest, "m",
             is(depth > by_steps ? law_of_peak(depth, beta, h) : 0,
                "a throw at βd/h, step by step, or it stays down", absolute(1e-9 * (1 + highest))),
             Quantity("|depth/limit − 1|", std::abs(depth / by_steps - 1)) > 1e-6);
  page.claim("peak above the ground with the limit on the speed", highest_capped, "m",
             is_at_most(cap < harmless_speed(beta, h) ? 0 : cap * cap / (2 * gravity), "it stays down, or v²/2g"),
             Quantity("|limit/harmless − 1|", std::abs(cap / harmless_speed(beta, h) - 1)) > 0.05);
  page.claim("peak above the ground with a soft contact", highest_soft, "m",
             is(0, "the relaxed rows keep no velocity of the spring", absolute(1e-9)));
  page.claim("peak above the ground with split impulse", highest_split, "m",
             is(0, "no velocity of the correction is left", absolute(1e-9)));
}

}  // namespace byhand::contact
