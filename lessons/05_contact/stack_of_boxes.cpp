// Step 7: a stack, and what it asks of a solver.

#include <array>
#include <map>

#include "lessons/05_contact/column.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/pictures/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double stack_seconds = 3.5, hurry = 4;  // of film [s]; seconds of the stack in one of the film
constexpr int most_tried = 64;                    // sweeps a step
constexpr double least_shift = 1e-4;              // that is drawn [m]

double weight_above(int boxes, int layer) { return (boxes - layer) * gravity; }

/// The same column as points on a line, swept from below: what each layer presses with after so many sweeps from
/// zero [N].
std::vector<double> swept_by_hand(int boxes, int sweeps, double h) {
  const auto n = static_cast<std::size_t>(boxes);
  std::vector<double> lambda(n, 0.0), v(n + 1, -gravity * h);
  v[0] = 0;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t i = 0; i < n; ++i) {
      const double share = i == 0 ? 1 : 0.5;
      const double change = std::max(-lambda[i], -share * (v[i + 1] - v[i]));
      lambda[i] += change;
      v[i + 1] += change;
      if (i > 0) v[i] -= change;
    }
  for (double& impulse : lambda) impulse /= h;
  return lambda;
}

std::vector<double> forces_after(Pile pile, int steps, double h) {
  for (int i = 0; i < steps; ++i) pile.step(h);
  return layer_forces(pile, h);
}

GaussSeidel sweeping(int sweeps, bool warm) { return {.sweeps = sweeps, .warm_start = warm}; }

Chart forces(const Setting& setting) {
  const int n = setting.boxes, sweeps = setting.sweeps;
  const double h = setting.h();
  Chart chart{.x = {.label = "contact, from the ground up"}, .y = {.label = "load on contact (box weights)"}};
  if (n <= 10)
    for (int i = 1; i <= n; ++i) chart.x.ticks.push_back({static_cast<double>(i), say("@", i)});
  const auto add = [&](std::string name, const std::vector<double>& forces, CurveStyle style,
                       std::optional<int> place = {}) {
    Curve curve{.label = std::move(name), .style = style, .place = place};
    for (std::size_t i = 0; i < forces.size(); ++i) {
      curve.x.push_back(static_cast<double>(i + 1));
      curve.y.push_back(forces[i] / gravity);
    }
    chart.curves.push_back(std::move(curve));
  };
  const auto resting = [&](bool warm) { return column(n, sweeping(sweeps, warm), 0); };
  add("1 step from zero", forces_after(resting(true), 1, h), CurveStyle::line_and_markers);
  add("4 warm steps", forces_after(resting(true), 4, h), CurveStyle::line_and_markers);
  add("16 warm steps", forces_after(resting(true), 16, h), CurveStyle::line_and_markers);
  add("direct, 1 step", forces_after(column(n, Direct{}, 0), 1, h), CurveStyle::markers,
      pictures::place_of("direct"));
  std::vector<double> weights;
  for (int i = 0; i < n; ++i) weights.push_back(weight_above(n, i));
  add("the weight above", weights, CurveStyle::theory);
  return chart;
}

/// Law 18 with the numbers of this page: a stiff column tips at σ² = 3g/2N, and a sweep takes 2/N⁴ of its bending.
double law_of_standing(int boxes, double h) {
  return laws::sweeps_to_stand(1.5 * gravity / boxes, 1 - 2 / std::pow(boxes, 4), h);
}

/// The fewest warm sweeps a step with which a kicked stack stands; infinity if more than `most_tried` are needed.
/// The search begins at the law's number, from which it goes away in growing strides.
double sweeps_needed(int boxes, double h, const Baumgarte& cure = left_alone) {
  // A reader who moves another slider does not wait for it again.
  static std::map<std::array<double, 4>, double> known;
  const std::array<double, 4> asked{static_cast<double>(boxes), h, cure.beta, cure.slop};
  if (const auto found = known.find(asked); found != known.end()) return found->second;
  int falls = 0, stands = most_tried + 1;
  const auto run = [&](int sweeps) {
    Pile pile = column(boxes, sweeping(sweeps, true));
    pile.method.drift = cure;
    (std::isinf(falls_at(pile, patience, h)) ? stands : falls) = sweeps;
  };
  int next = static_cast<int>(std::clamp(std::ceil(law_of_standing(boxes, h)), 1.0, 1.0 * most_tried));
  for (int stride = 1; falls < next && next < stands; stride *= 2) {
    run(next);
    next += stands == next ? -stride : stride;
  }
  while (stands - falls > 1) run((falls + stands) / 2);
  return known[asked] = stands <= most_tried ? stands : INFINITY;
}

/// Velocities of a stack at rest that is nudged, too little for any end of a contact to open, after so many sweeps
/// [m/s, rad/s].
std::vector<Velocity<PlaneBody>> nudged(int boxes, int sweeps, double h) {
  Pile pile = column(boxes, Direct{}, 0);
  pile.step(h);
  kick(pile.scene, 1e-4);
  pile.method.solver = sweeping(sweeps, true);
  pile.step(h);
  return pile.scene.bodies().velocity;
}

double largest_difference(const std::vector<Velocity<PlaneBody>>& one,
                          const std::vector<Velocity<PlaneBody>>& other) {
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    largest = std::max(largest, (one[i] - other[i]).cwiseAbs().maxCoeff());
  return largest;
}

/// The share that a sweep takes from the slowest error, measured where only that is left. It does not depend on h.
double share_taken(int boxes) {
  static std::map<int, double> known;
  const auto [place, fresh] = known.try_emplace(boxes);
  if (fresh) {
    constexpr double h = 1.0 / 60;
    const int span = boxes * boxes * boxes * boxes / 8;
    const auto first = nudged(boxes, span, h), second = nudged(boxes, 2 * span, h),
               third = nudged(boxes, 3 * span, h);
    place->second = -std::log(largest_difference(third, second) / largest_difference(second, first)) / span;
  }
  return place->second;
}

Chart needed(double h, const Baumgarte& cure) {
  Curve stands{.label = "uncorrected", .style = CurveStyle::line_and_markers},
      cured{.label = "corrected beyond 1 mm", .style = CurveStyle::line_and_markers},
      law_stands{.label = "¾ gh²N³", .style = CurveStyle::theory};
  for (const int boxes : {6, 8, 10, 12, 14, 16, 18, 20}) {
    for (Curve* curve : {&stands, &cured, &law_stands}) curve->x.push_back(boxes);
    stands.y.push_back(sweeps_needed(boxes, h));
    stands.point_labels.push_back(std::isinf(stands.y.back()) ? "> 64" : course::number(stands.y.back()));
    cured.y.push_back(sweeps_needed(boxes, h, cure));
    law_stands.y.push_back(law_of_standing(boxes, h));
  }
  std::vector<Tick> counted;
  for (const double boxes : stands.x) counted.push_back({boxes, course::number(boxes)});
  return {.x = {.label = "number of boxes N", .scale = Scale::logarithmic, .ticks = counted},
          .y = {.label = "sweeps a step to stand", .scale = Scale::logarithmic},
          .curves = {stands, cured, law_stands}};
}

/// Whether the stack comes down without being kicked: then its contacts do not even carry its weight.
double falls_by_itself(int boxes, const GaussSeidel& solver, double h) {
  return falls_at(column(boxes, solver, 0), patience, h);
}

/// What becomes of a stack at rest each of whose overlaps is corrected, beside lesson 4's limit for warm starts.
std::string if_all_is_corrected(Page& page, int boxes, int sweeps, const course::Parameter<double>& beta,
                                double h) {
  Pile pile = column(boxes, sweeping(sweeps, true), 0);
  pile.method.drift = Baumgarte{beta};
  double fell = patience, least = INFINITY, most = 0, loosest = INFINITY;  // [s]; in the tenth second [boxes]
  while (pile.time < 10 - 0.5 * h && fell == patience) {
    pile.step(h);
    if (has_fallen(pile)) fell = pile.time;
    if (pile.time < 9) continue;
    const std::vector<double> forces = layer_forces(pile, h);
    least = std::min(least, forces.front() / gravity);
    most = std::max(most, forces.front() / gravity);
    loosest = std::min(loosest, *std::min_element(forces.begin(), forces.end()) / gravity);
  }
  const std::string begins = say("With every overlap corrected, β = @, ", beta);
  if (fell < 10)
    return page.verdict({{.when = Quantity("time stood, all corrected", fell, "s") < 10,
                          .say = begins + say("the stack comes down after @ s.", Value(fell, 2))}});
  const double limit = laws::largest_beta(laws::left_by_sweeps(boxes, sweeps));
  const Quantity swing("swing of the load in the tenth second/weight", (most - least) / boxes),
      corrected("β", beta), rods("lesson 4's limit", limit);
  const std::string beside = say("lesson 4's limit for warm starts, @ here", Value(limit, 2)),
                    swings =
                        begins +
                        say("it still swings in the tenth second: the lowest contact carries @ to @ boxes. β is ",
                            Value(without_rounding(least, boxes), 3), Value(most, 3));
  return page.verdict(
      {{.when = where(swing < 0.02, corrected < rods),
        .say = begins + "it comes to rest too: β is below " + beside + "."},
       {.when = swing < 0.02, .say = begins + "it comes to rest too, with β above " + beside + "."},
       {.when = corrected > rods, .say = swings + "above " + beside + "."},
       {.when = Quantity("least load on a contact", loosest) <= 0,
        .say = swings + "below " + beside + ", but that is for rods: these contacts open."},
       {.when = swing >= 0.02, .say = swings + "below " + beside + "."}});
}

/// Why the stack fell or may fall, of the three that can be told apart.
std::string why_it_falls(Page& page, int boxes, const GaussSeidel& solver, double fell, double h) {
  const double by_itself = falls_by_itself(boxes, solver, h);
  if (std::isfinite(by_itself))
    return page.verdict({{.when = has_fate("not kicked", by_itself),
                          .say = say("With @ it comes down even without a kick, after @ s.",
                                     several(solver.sweeps, "sweep"), Value(by_itself, 2))}}) +
           " The warm start does not bring λ up to the weight in time; with enough sweeps the weight is carried, "
           "and "
           "there is another reason to fall.";
  if (std::isinf(fell)) return "This stack stands; a taller one would fall. Why?";
  Pile sticky{stack(boxes, 1, {.friction = 1e4}), {solver, left_alone}};
  kick(sticky.scene, 0.02);
  const double glued = falls_at(sticky, patience, h);
  const std::string before = say("@ s", Value(fell, 3)), after = say("@ s", Value(glued, 3));
  return "Why does it fall, although every contact carries its weight? " +
         page.verdict({{.when = has_fate("μ = 10⁴", glued),
                        .say = say("Friction is not the reason: with μ = 10⁴ @.",
                                   std::isinf(glued) ? say("it stands for @ s", patience)
                                   : after == before ? say("it falls at the same time, after @", after)
                                                     : say("it falls after @ instead of @", after, before)),
                        .law = Quantity("time stood, μ = 10⁴", std::min(glued, patience), "s") <=
                               Quantity("1.2 · time stood, μ = 0.6", 1.2 * fell, "s")}});
}

/// A kicked stack's end: it has fallen, or it stands after `patience`.
struct End {
  double fell = INFINITY;  // [s]; infinity if it stands
  Pile pile;
  Curve shift;  // of the top box, for as long as the film shows
};

End run_to_the_end(const NamedPile& run, double h) {
  End end{.pile = run.pile, .shift = {.label = run.name, .place = run.place}};
  while (end.pile.time < patience - 0.5 * h && std::isinf(end.fell)) {
    const bool filmed = end.pile.time < hurry * stack_seconds;
    end.pile.step(h);
    if (has_fallen(end.pile)) end.fell = end.pile.time;
    if (!filmed) continue;
    end.shift.x.push_back(end.pile.time);
    end.shift.y.push_back(std::max(least_shift, shift(end.pile)));
  }
  return end;
}

Chart shifts(const std::vector<End>& ends) {
  double largest = 10 * least_shift;
  for (const End& end : ends)
    for (const double off : end.shift.y) largest = std::max(largest, off);
  Chart chart{.x = {.label = "time (s)"},
              .y = {.label = "top box is off by (m); 0.1 mm or less at the bottom",
                    .scale = Scale::logarithmic,
                    .range = {{least_shift, std::pow(10, std::ceil(std::log10(largest)))}}}};
  for (const End& end : ends) chart.curves.push_back(end.shift);
  return chart;
}

/// What the camera sees of a run: as much as of a stack that stands, or, once boxes are outside, as little more as
/// shows all of them. The ground stays where it is on the page.
Rectangle seen(const Pile& pile, int boxes) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 1; i < pile.scene.bodies().pose.size(); ++i) {
    const double x = pile.scene.bodies().pose[i].position.x();
    low = std::min(low, x - 0.75);
    high = std::max(high, x + 0.75);
  }
  const double least = std::max(0.27 * boxes, 1.2), half = std::max(least, (high - low) / 2),
               middle = std::clamp(0.0, high - half, std::max(high - half, low + half)), out = half / least;
  return {middle - half, -0.03 * out * boxes, 2 * half, 1.06 * out * boxes};
}

void draw_runs(Canvas& canvas, const std::vector<NamedPile>& runs, const std::vector<double>& fell,
               const Rectangle& frame, int boxes) {
  const auto cells = frame.cells(1, static_cast<int>(runs.size()), 8);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Rectangle below{cells[i].x, cells[i].y, cells[i].width, cells[i].height - 56};
    canvas.look_at_page();
    canvas.text({cells[i].centre().x(), cells[i].top() - 16}, runs[i].name,
                {.size = 20, .colour = palette::series(runs[i].place), .bold = true});
    if (runs[i].pile.time >= fell[i])
      canvas.text({cells[i].centre().x(), cells[i].top() - 40}, say("falls after @ s", Value(fell[i], 3)),
                  {.size = 18, .colour = palette::error, .bold = true});
    canvas.clip(below);
    canvas.look(fit(seen(runs[i].pile, boxes), below, 0));
    pictures::Shapes shapes = pictures::shapes_of(runs[i].pile.scene);
    for (auto& box : shapes.boxes) {
      box.look = pictures::look_of_run(runs[i].place);
      box.look.edge.width = 1;
    }
    pictures::draw(canvas, shapes);
    canvas.clip({});
  }
  canvas.look_at_page();
}

}  // namespace

void stack_of_boxes(const Setting& setting, Page& page) {
  const int n = setting.boxes, sweeps = setting.sweeps;
  const double h = setting.h();
  const std::vector<double> first = forces_after(column(n, sweeping(sweeps, false), 0), 1, h),
                            by_hand = swept_by_hand(n, sweeps, h),
                            direct = forces_after(column(n, Direct{}, 0), 1, h);

  page.text(
      R"(A stack is lesson 3's chain upside down: @ unit boxes of 1 kg, and each contact has to carry all boxes above it.
      From here on two boxes touch along a face. A face has three rows: two normals, one at each end, solved together as
      a block (solved in turn they would rock the box), and one row of friction.)",
      n);
  const double carried = first.front() / gravity, share = carried / n;
  const double missing = without_rounding(8 / (pi * pi) * laws::left_by_sweeps(n, sweeps), 1e3);
  // Bounds far enough from what the run gives that the hint's one wave decides between them.
  const bool third = std::abs(share - 0.5) < 0.1, four_fifths = std::abs(share - 0.9) < 0.06;
  const char *low = third ? "a third" : "half", *high = four_fifths ? "four fifths" : "nine tenths";
  const std::string carries = say("It carries @ of @ boxes. ", Value(carried, 3), n);
  const int answer = share < (third ? 1.0 / 3 : 0.5) ? 0 : share < (four_fifths ? 0.8 : 0.9) ? 1 : 2;
  page.choose(
      {.ask =
           say("λ = 0 at first, @ from the ground up in one step. How much of the @ boxes' weight does the lowest "
               "contact carry then?",
               several(sweeps, "sweep"), n),
       .options =
           {{say("less than @", low), (answer == 0 ? carries : "") +
                                          R"(The error is a wave along the stack, as in lesson 3: the weight of the
                            upper boxes travels down one contact per sweep, and each contact reflects half of it.)"},
            {say("@ or more, but less than @", low, high),
             (answer == 1 ? carries : "") +
                 "Each sweep leaves the same share of the slowest wave, so the weight comes in bit by bit."},
            {say("@ or more", high),
             (answer == 2 ? carries : "") +
                 "That takes enough sweeps for the slowest wave to die out: their number grows as N²."}},
       .answer = answer,
       .hints = {
           "How far along the chain did the weight come in as many sweeps?",
           R"(The error is a sum of waves. The slowest has 8/π² of it at the lowest contact, and a sweep leaves
                 cos²(π/2N) of that wave (lesson 3).)",
           say("At most 1 − (8/π²)·cos²ᵏ(π/2N) with k = @ and N = @: @. The faster waves lower it.", sweeps, n,
               Value(1 - missing, 3))}});
  page.figure("layers",
              say("The load on each contact, with @ a step and solved at once.", several(sweeps, "sweep")),
              forces(setting));
  const double sixteen = forces_after(column(n, sweeping(sweeps, true), 0), 16, h).front() / gravity;
  const Condition overshoots = Quantity("load after 16 warm steps/weight", sixteen / n) > 1.05;
  if (overshoots && std::isinf(falls_at(column(n, sweeping(sweeps, true), 0), 16 * h, h)))
    page.text(page.verdict({{.when = overshoots,
                             .say = say("After 16 warm steps the lowest contact carries @ boxes: it also has to "
                                        "stop those that have begun to fall.",
                                        Value(sixteen, 3))}}));
  // What the lowest contact carries, in boxes, if the stack still stands.
  const auto lowest_after = [&](double time) {
    Pile resting = column(n, sweeping(sweeps, true), 0);
    while (resting.time < time - 0.5 * h) {
      resting.step(h);
      if (has_fallen(resting)) return -1.0;
    }
    return layer_forces(resting, h).front() / gravity;
  };
  const double after_ten = lowest_after(10);
  if (after_ten < 0)
    page.text(
        R"(With a warm start each step continues where the last one stopped. Here that is too slow: within ten
        seconds the stack has come down under its own weight.)");
  else
    page.text(
        R"(With a warm start each step continues where the last one stopped. The lowest contact should carry @ boxes:
        after a second it carries @, after ten seconds @.)",
        n, Value(lowest_after(1), 4), Value(after_ten, 4));
  page.text("(To keep corrections out of this, overlaps below @ cm are left alone. @)", 100 * left_alone.slop,
            if_all_is_corrected(page, n, sweeps, setting.beta, h));
  page.text(
      R"(Now kick it sideways: @ m/s at the top, less below in proportion to the height. It is down when its
      top box has dropped by half a box.)",
      0.02);
  std::vector<NamedPile> runs{
      {several(sweeps, "sweep"), column(n, sweeping(sweeps, true)), pictures::place_of("Gauss–Seidel")},
      {say("@ sweeps", 2 * sweeps), column(n, sweeping(2 * sweeps, true)), 2},
      {"direct", column(n, Direct{}), pictures::place_of("direct")}};
  const std::vector<End> ends = page.side_by_side(
      static_cast<int>(runs.size()), [&](int i) { return run_to_the_end(runs[static_cast<std::size_t>(i)], h); });
  const Chart chart = shifts(ends);
  const std::vector<double> fell = each(ends, [](const End& end) { return end.fell; });
  page.sequence(
      "stack",
      say(R"(@ boxes after a kick, with @ and @ warm sweeps a step and solved directly; the first @ s, @ times as
            fast. A fallen stack is drawn smaller. Right: how far the top box is off, until it has fallen (dips: it
            passes its place).)",
          n, sweeps, 2 * sweeps, hurry * stack_seconds, hurry),
      Seconds{stack_seconds}, [=, runs = runs](Canvas& canvas, double time) mutable {
        for (NamedPile& run : runs)
          while (run.pile.time < hurry * time - 0.5 * h) run.pile.step(h);
        const auto [left, right] = canvas.page().inset(14).panels(0.62, 16);
        draw_runs(canvas, runs, fell, left, n);
        renderer::draw(canvas, pictures::grown_to(chart, hurry * time), right.lowered(50));
      });
  const double cold = falls_at(column(n, sweeping(sweeps, false)), patience, h);
  const std::string few = several(sweeps, "sweep"), twice = say("@ sweeps", 2 * sweeps);
  // One after the other, so that each compiler lists them in this order.
  const std::string warm_fates =
      page.verdict({{.when = where(has_fate(few, ends[0].fell), has_fate(twice, ends[1].fell),
                                   has_fate("solved directly", ends[2].fell)),
                     .say = std::all_of(fell.begin(), fell.end(), [](double at) { return std::isinf(at); })
                                ? say("All three still stand after @ s.", patience)
                            : fate(ends[1].fell) == fate(ends[2].fell)
                                ? say("With @ it @; with @, and solved directly, it @.", few, fate(ends[0].fell),
                                      2 * sweeps, fate(ends[1].fell))
                                : say("With @ it @, with @ it @; solved directly it @.", few, fate(ends[0].fell),
                                      2 * sweeps, fate(ends[1].fell), fate(ends[2].fell))}});
  const std::string cold_fate = page.verdict(
      {{.when = has_fate(few + ", cold", cold), .say = say("With @ started cold it @.", few, fate(cold))}});
  page.text("@ (@)", warm_fates, cold_fate);
  const double law = law_of_standing(n, h), needed_sweeps = sweeps_needed(n, h);
  page.text(why_it_falls(page, n, sweeping(sweeps, true), ends[0].fell, h));
  page.text(
      R"(Gravity pushes a leaning column further over, as it does a pencil on its tip, and the contacts resist by
      pressing more on one side: the column has to build up a bending moment. Of all errors
      sweeps remove bending most slowly: only the share 2/N⁴ (measured) in a sweep, against π²/4N² of an error in the weight.
      With a warm start two effects compete in each step: gravity adds the fraction (σh)² to a lean, where σ² = 3g/2N
      for a stiff column of N unit boxes, and k sweeps remove the fraction k · 2/N⁴. The column stands if the second is
      the larger:)");
  page.formula("k > ¾ gh²N³/a = @,   a = 1 m", R"(k > \tfrac34\, g h^2 N^3/a = @, \quad a = 1\,\mathrm{m})", law);
  const Condition any_will_do = Quantity("¾gh²N³/a", law) < 1;
  if (any_will_do)
    page.text(page.verdict(
        {{.when = any_will_do, .say = "That is less than one: by the law a single sweep is enough."}}));
  page.derivation(
      "How many sweeps a stack needs to stand",
      {{"a stiff column of N unit boxes of mass m leans by φ: torque of its weight", "τ = N m g (N/2) φ",
        R"(\tau = N m g\,\tfrac N2\,\varphi)"},
       {"its moment of inertia about the base", "I = N m N²/3", R"(I = \tfrac13 N m N^2)"},
       {"Iφ̈ = τ: the lean grows as e^(σt)", "σ² = 3g/(2N)", R"(\sigma^2 = \frac{3g}{2N})"},
       {"the sweeps leave q of the bending rate V = φ̇, with the warm start λ (impulse over inertia) and gravity's "
        "part",
        "V′ = q (V + λ + σ²h φ)", R"(V' = q\,(V + \lambda + \sigma^2 h\,\varphi))"},
       {"besides gravity only λ has changed V in the last step: λ = V − V₋ − σ²hφ₋; and φ − φ₋ = hV",
        "V′ = q ((2 + σ²h²) V − V₋)", R"(V' = q\,((2 + \sigma^2h^2)\,V - V_-))"},
       {"growth by z in a step", "z² − q(2 + σ²h²) z + q = 0", R"(z^2 - q\,(2 + \sigma^2h^2)\,z + q = 0)"},
       {"both roots stay within the unit circle until z = 1 is one of them", "(σh)² < (1 − q)/q",
        R"((\sigma h)^2 < \frac{1-q}{q})"},
       {"k sweeps of the bending, measured: q ≈ 1 − 2k/N⁴", "(1 − q)/q ≈ 2k/N⁴",
        R"(\frac{1-q}{q} \approx \frac{2k}{N^4})"},
       {"insert", "k > ¾ g h² N³", R"(k > \tfrac34\,g\,h^2 N^3)"}});
  const auto beside_law = [&] {
    if (std::isinf(needed_sweeps) && 2 * sweeps > most_tried)
      return std::isinf(ends[1].fell)
                 ? say("In runs, @ sweeps do not keep it standing, and @ do.", most_tried, 2 * sweeps)
                 : say("In runs, not even @ sweeps keep it standing.", 2 * sweeps);
    if (std::isinf(needed_sweeps)) return say("In runs, not even @ sweeps keep it standing.", most_tried);
    const std::string found =
        say("In a run of @ s, @.", patience,
            needed_sweeps > 1 ? say("@ sweeps keep it standing and @ not", needed_sweeps,
                                    needed_sweeps > 2 ? say("@ do", needed_sweeps - 1) : std::string("1 does"))
                              : std::string("1 sweep keeps it standing"));
    if (needed_sweeps < law)
      return found + R"( That is below the law: the lean still grows then, but so slowly that the stack has not
                      fallen in this time.)";
    return found;
  };
  page.text(beside_law());
  const int more = static_cast<int>(std::ceil(1.2 * law));
  const Baumgarte beyond_a_millimetre{.beta = setting.beta, .slop = 0.001};
  Pile corrected_pile = column(n, sweeping(more, true));
  corrected_pile.method.drift = beyond_a_millimetre;
  const double fell_corrected = falls_at(corrected_pile, patience, h);
  page.text(
      R"(The law is for a stack whose overlaps are left uncorrected. A correction adds to the lean as well. @)",
      page.verdict(
          {{.when = has_fate("corrected", fell_corrected),
            .say = say("With overlaps beyond 1 mm corrected (β = @) and @@ the stack @.", setting.beta,
                       several(more, "sweep"), law < 1 ? "" : say(", @ times the law,", Value(more / law, 3)),
                       fate(fell_corrected))}}));
  page.figure(
      "sweeps_needed",
      say(R"(How many warm sweeps a step a kicked stack needs to stand for @ s, h = @ s, if its overlaps are left
            uncorrected and if those beyond 1 mm are corrected, β = @ (no point: more than @). Dashed: the law; a run takes whole sweeps.)",
          patience, setting.h, setting.beta, most_tried),
      needed(h, beyond_a_millimetre));
  page.text(
      "By the law, halving the step takes a quarter of the sweeps, and twice the boxes take eight times as many.");
  const Pile& standing = ends[2].pile;
  const double steps = std::round(standing.time / h);
  page.text(
      R"(The direct solve (`solver/direct/active_set.cpp`) uses an *active set*:

      - take the rows that press;
      - solve them exactly, by lesson 3's elimination (a column is a chain);
      - release the rows whose λ would pull;
      - add the rows whose corners would sink in;
      - solve again, until the set no longer changes.

      No error is left to build up from step to step. Counted in multiplications, a direct step costs as much as @
      sweeps.)",
      Value(static_cast<double>(standing.work.row_solves) / standing.work.system.rows() / steps, 2));

  page.measure("lowest contact after the first step, in weights of a box", first.front() / gravity, "1");
  double worst_first = 0, worst_direct = 0;
  for (int i = 0; i < n; ++i) {
    worst_first = std::max(worst_first, std::abs(first[i] - by_hand[i]));
    worst_direct = std::max(worst_direct, std::abs(direct[i] / weight_above(n, i) - 1));
  }
  page.claim("largest difference of a contact's load from the same sweeps on points in a column", worst_first, "N",
             is(0, "the same sweeps by hand", absolute(1e-9)));
  page.claim("a layer over the weight above it, solved directly: largest deviation from 1", worst_direct, "1",
             is(0, "the weight above", absolute(1e-9)));
  page.claim(say("fewest warm sweeps with which @ boxes stand", n), needed_sweeps, "1",
             is(law, "law of the stack: ¾gh²N³, within one sweep and 10 %", absolute(1 + 0.1 * law)),
             within(2, Quantity("¾gh²N³", law), 50));
  constexpr int measured_boxes = 12;
  page.claim(say("share of the slowest error that a sweep takes, @ boxes, times N⁴", measured_boxes),
             share_taken(measured_boxes) * std::pow(measured_boxes, 4), "1",
             is(2, "law of bending: 2.0/N⁴", relative(0.1)));
  page.claim(say("solved directly, the top box is off after @ s", patience), shift(standing), "m",
             is_at_most(1e-3, "solved exactly it stands"));
}

}  // namespace byhand::contact
