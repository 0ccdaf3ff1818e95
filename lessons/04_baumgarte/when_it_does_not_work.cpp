// Step 7: what a wrong step looks like, from the symptom to the line that is wrong.

#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/04_baumgarte/symptoms.hpp"
#include "lessons/pictures/acts.hpp"

namespace byhand::baumgarte {
namespace {

constexpr double film_length = 2;  // [s]

constexpr int least_steps = 10;  // that are shown of a run

/// A run over its own time: the rod in each step, until it leaves the view, and what is measured.
struct Track {
  std::vector<RodBetween> rods;
  std::vector<double> measured;

  const RodBetween& rod_at(double share) const { return rods[std::min(rods.size() - 1, step_at(share))]; }
  std::size_t step_at(double share) const {
    return static_cast<std::size_t>(share * static_cast<double>(measured.size() - 1) + 1e-9);
  }
};

struct Filmed {
  std::string name;
  Reading read;
  Track wrong, right;
  Rectangle world;  // what is seen [m]
};

/// Half the size of a box, and of a bob about as large.
constexpr double half_width = 0.3, half_height = 0.5;

bool inside(const Rectangle& world, const RodBetween& rod) {
  const Rectangle centres = world.inset(half_height);
  const auto seen = [&](const Body& body) { return body.inverse_mass == 0 || centres.contains(body.x); };
  return seen(rod.one) && seen(rod.two);
}

Track track(const FaultyRun& run, const Recipe& recipe, const Rectangle& world) {
  RodBetween rod = run.start;
  Track track{{rod}, {run.read.of(rod)}};
  const double seconds = std::max(run.steps, least_steps) * run.recipe.h;
  bool seen = true;
  for (int i = 0; i < static_cast<int>(std::lround(seconds / recipe.h)); ++i) {
    advance(rod, recipe);
    seen = seen && inside(world, rod);
    if (seen) track.rods.push_back(rod);
    track.measured.push_back(run.read.of(rod));
  }
  return track;
}

Filmed filmed(const Symptom& symptom) {
  const FaultyRun& run = *symptom.run;
  const bool anchored = run.start.one.inverse_mass == 0;
  const Rectangle world = anchored ? Rectangle{-2.6, -3.9, 5.2, 5.1} : Rectangle{-2.6, -2.4, 5.2, 4.8};
  return {symptom.seen, run.read, track(run, run.recipe, world), track(run, run.right, world), world};
}

void draw(Canvas& canvas, const RodBetween& rod, bool ghost) {
  const Look bodies = ghost ? Look{fade(palette::paper, 0), {palette::theory, 1.5, Dash::dashed}} : body_look;
  const Point from = rod.one.x + rod.one.turned(rod.arm1), to = rod.two.x + rod.two.turned(rod.arm2);
  if (ghost)
    canvas.line(from, to, {palette::theory, 1.5, Dash::dashed});
  else
    canvas.rod(from, to, {palette::constraint, {palette::ink, 0}}, 4);
  for (const Body* body : {&rod.one, &rod.two}) {
    if (body->inverse_inertia > 0)
      canvas.box(body->x, {2 * half_width, 2 * half_height}, angle(body->rotation), bodies);
    else if (body->inverse_mass > 0)
      canvas.disc(body->x, 0.2, bodies);
    else if (!ghost)
      canvas.anchor(body->x);
  }
}

/// What is measured, so far: of the wrong program, and dashed of the correct one.
void draw_measured(Canvas& canvas, const Filmed& run, double share, const Rectangle& frame) {
  double lowest = 0, highest = 0;
  for (const Track* track : {&run.wrong, &run.right})
    for (const double value : track->measured) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  const auto place = [&](double along, double value) {
    return Point(frame.x + along * frame.width, frame.y + (value - lowest) / (highest - lowest) * frame.height);
  };
  canvas.line(place(0, 0), place(1, 0), {palette::grid, 1.5});
  for (const Track* track : {&run.right, &run.wrong}) {
    const bool right = track == &run.right;
    std::vector<Point> path;
    for (std::size_t i = 0; i <= track->step_at(share); ++i)
      path.push_back(
          place(static_cast<double>(i) / static_cast<double>(track->measured.size() - 1), track->measured[i]));
    if (path.size() > 1)
      canvas.path(path, right ? Stroke{palette::theory, 1.8, Dash::dashed} : Stroke{palette::error, 2.6});
  }
}

/// A panel for each run, over its own time: the wrong program, and dashed the correct one.
void draw(Canvas& canvas, const std::vector<Filmed>& runs, double share) {
  // On a narrow page names break.
  const bool narrow = canvas.page().is_high();
  const int columns = narrow ? 3 : 4, rows = (static_cast<int>(runs.size()) + columns - 1) / columns;
  const double title = narrow ? 56 : 26;
  const auto panels = canvas.page().inset(12).cells(rows, columns, narrow ? 6 : 10);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Filmed& run = runs[i];
    const Rectangle panel = panels[i], below{panel.x, panel.y, panel.width, panel.height - title};
    canvas.look_at_page();
    const TextStyle bold{.size = 14, .bold = true};
    canvas.text({panel.centre().x(), panel.top() - (title / 2 - 1)},
                narrow ? pictures::wrapped(canvas, run.name, panel.width, bold) : run.name, bold);
    canvas.rectangle(below, {palette::paper, {palette::grid, 1.5}});
    const auto [picture, beside] = below.split_columns(narrow ? 0.5 : 0.38, 4);
    const auto [label, chart] = beside.inset(10).split_rows(16 / (below.height - 20), 2);
    draw_measured(canvas, run, share, chart);
    canvas.text({label.x, label.centre().y()},
                narrow ? run.read.name
                       : say("@ @ @", run.read.name, Value(run.wrong.measured[run.wrong.step_at(share)], 3),
                             run.read.unit),
                {.size = 13, .colour = palette::muted, .anchor = Anchor::left});
    canvas.look(fit(run.world, picture, 0));
    canvas.clip(picture);
    draw(canvas, run.wrong.rod_at(share), false);
    draw(canvas, run.right.rod_at(share), true);
    canvas.clip(std::nullopt);
  }
}

}  // namespace

void when_it_does_not_work(const Setting&, Page& page) {
  const std::vector<SymptomGroup> groups = all_symptoms();
  const Symptom& sinks = groups.front().symptoms.front();

  page.text(
      R"(You have typed the seven lines of lesson 2 and the bias of this lesson, and something is wrong on the screen. What
      you see usually tells you which line. Each mistake below was put into the same program on purpose: a bob or a box of
      3 kg on a rod of 2 m, 60 steps a second, β = 0.2. Find your symptom, make the test, and only then change the
      line.)");
  page.choose(
      {.ask = say(
           R"(A bob on a vertical rod should hang still. Instead it sinks steadily at @ m/s. With half the time step it
                  sinks half as fast, and its mass does not matter. What is wrong?)",
           sinks.wrong),
       .options =
           {{"λ is multiplied by h", "Then the bob would fall almost freely at first, faster and faster."},
            {"gravity is added after λ",
             "The bob moves by a gh that the row has not seen; the next step removes it and adds the next."},
            {"m⁻¹ is missing in (19)", "Then the speed would depend on the mass: (m − 1)gh, with m in kg."},
            {"b is missing",
             "Without b a rod grows only while its bob moves along the circle; this one does not."}},
       .answer = 1,
       .hints = {"Which speed is it, in terms of g and h?", "Gravity adds gh in one step. What should remove it?",
                 "λ removes what it finds in V. Was gh there already?"}});

  std::vector<Filmed> runs;
  for (const SymptomGroup& group : groups)
    for (const Symptom& symptom : group.symptoms)
      if (symptom.run) runs.push_back(filmed(symptom));
  page.sequence(
      "symptoms",
      R"(Each rod over the time of its measurement, at least ten steps. Purple and in numbers: the wrong program; dashed:
                the correct one. NaN and the symptoms of several rows are not drawn.)",
      Seconds{film_length}, [runs](Canvas& canvas, double time) { draw(canvas, runs, time / film_length); });
  for (const auto& [title, symptoms] : groups) {
    std::string list;
    for (const Symptom& symptom : symptoms)
      list += say("\n- **@.** Measured: @, @ @; @: @ @. *Cause:* @. *Test:* @. (@)", symptom.seen,
                  symptom.quantity, symptom.wrong, symptom.unit, symptom.compared, symptom.right, symptom.unit,
                  symptom.cause, symptom.test, symptom.more);
    page.text("*@*\n@", title, list);
    for (const Symptom& symptom : symptoms)
      page.claim(
          symptom.quantity + " (" + symptom.seen + ")", symptom.wrong, symptom.unit,
          is(symptom.law, symptom.source, absolute(symptom.tolerance * std::max(1.0, std::abs(symptom.law)))));
  }
  page.text(
      R"(If your symptom is not listed, run one bob on one rod, without gravity, correction and warm start, and switch them
      on one by one. Print C, JV + b before λ, λ, and JV + b after it. The last must be zero to rounding. If it is not, look
      at λ, K and (20). If it is, look at C and J, then at b (sign, 1/h, size of β), then at the order of the step
      (gravity before λ).)");
}

}  // namespace byhand::baumgarte
