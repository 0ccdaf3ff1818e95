#include "lessons/stage/pages.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>

#include "lessons/doctor/doctor.hpp"
#include "lessons/stage/chosen.hpp"
#include "lessons/stage/knobs.hpp"
#include "lessons/stage/looks.hpp"

namespace byhand::stage {
namespace {

using namespace course;
using renderer::Canvas;
using renderer::Chart;
using renderer::Curve;

struct Counts {
  int moving = 0, held = 0, constraints = 0, rows = 0;
  std::string model;
};
Counts counts_of(const SceneOfAnyModel& any) {
  return std::visit(
      []<class M>(const Scene<M>& scene) {
        Counts counts;
        for (int i = 0; i < scene.bodies().size(); ++i)
          ++(moves(scene.bodies().inverse_mass[i]) ? counts.moving : counts.held);
        counts.constraints = scene.count();
        for (const auto& entry : scene.entries()) counts.rows += scene.store(entry.kind).rows;
        counts.model = M::linear == 2 ? (M::angular ? "bodies in the plane" : "particles in the plane")
                       : M::angular   ? "bodies in space"
                                      : "particles in space";
        return counts;
      },
      any);
}

/// One run for all steps of a page; made anew when a knob is turned.
class Runs {
 public:
  explicit Runs(std::shared_ptr<const Knobs> knobs) : knobs_(std::move(knobs)) {}
  std::shared_ptr<const Watched> now() {
    const SceneFile file = knobs_->file();
    const std::string key = knobs_->described() + fmt::format("{} {}", file.duration, write_scene(file));
    if (key != key_) {
      run_ = std::make_shared<const Watched>(watch(file, knobs_->method()));
      key_ = key;
    }
    return run_;
  }

 private:
  std::shared_ptr<const Knobs> knobs_;
  std::string key_;
  std::shared_ptr<const Watched> run_;
};

void show_scene(Page& page, const SceneFile& file, const Knobs& knobs) {
  if (!file.about.empty()) page.text("@", file.about);
  const Counts counts = counts_of(file.scene);
  page.table({"what", "count"}, {{counts.model + " that move", std::to_string(counts.moving)},
                                 {"fixed bodies", std::to_string(counts.held)},
                                 {"constraints", std::to_string(counts.constraints)},
                                 {"their rows", std::to_string(counts.rows)}});
  page.text("It runs for @ s, stepped by @.", file.duration, knobs.described());
  const SceneLook look = look_of(file.scene);
  const std::vector<Placement> start =
      std::visit([](const auto& scene) { return AnyScene(scene).placements(); }, file.scene);
  page.figure("scene", "The scene at the start.",
              [=](Canvas& canvas) { draw(canvas, look, start, view_of(look, {start}), canvas.page().inset(24)); });
}

void show_film(Page& page, const SceneFile& file, const std::shared_ptr<const Watched>& run) {
  const SceneLook look = look_of(file.scene);
  const View view = view_of(look, run->instants);
  page.sequence("film", fmt::format("{:.3g} s of the scene.", run->end()), Seconds{std::max(run->end(), 0.04)},
                [=](Canvas& canvas, double time) {
                  draw(canvas, look, run->at(time), view, canvas.page().inset(24));
                  canvas.text({canvas.page().right() - 30, canvas.page().top() - 30},
                              fmt::format("{:.2f} s", time), {.anchor = renderer::Anchor::top_right});
                });
  if (!run->stopped.empty())
    page.text("The run ended after @ s, because a step had no answer: @.", run->end(), run->stopped);
  else
    page.text("The run reached its end, @ s.", run->end());
}

void show_numbers(Page& page, const SceneFile& file, const std::shared_ptr<const Watched>& run) {
  Curve energy{.label = "energy"}, gap{.label = "gap"};
  for (const Sample& sample : run->samples) {
    energy.x.push_back(sample.time);
    energy.y.push_back(sample.energy);
    gap.x.push_back(sample.time);
    gap.y.push_back(sample.separation > 0 ? std::max(sample.separation, 1e-16) : NAN);
  }
  page.figure("energy", "Kinetic and potential energy.",
              Chart{.x = {.label = "time (s)"}, .y = {.label = "energy (J)"}, .curves = {energy}});
  const bool any_gap = run->largest_separation() > 0;
  if (any_gap)
    page.figure("drift", "The largest gap of a joint or overlap of two bodies.",
                Chart{.x = {.label = "time (s)"},
                      .y = {.label = "gap (m)", .scale = renderer::Scale::logarithmic},
                      .curves = {gap}});
  double smallest = INFINITY;
  for (const double size : doctor::body_sizes(file))
    if (size > 0) smallest = std::min(smallest, size);
  if (std::isinf(smallest)) smallest = 1;
  const double gap_in_bodies = run->largest_separation() / smallest;
  const Quantity open("largest gap over the smallest body", gap_in_bodies);
  page.text(
      "@", page.verdict(
               {{.when = open < 0.1,
                 .say = "No joint opens by a tenth of the smallest body, and no two bodies overlap by that much."},
                {.when = open >= 0.1,
                 .say = "A joint opens, or two bodies overlap, by more than a tenth of the smallest body."}}));
  page.measure("largest gap or overlap", run->largest_separation(), "m");
  page.measure("largest change of energy, over its scale", run->energy_change(), "1");
}

std::string words_of(const SceneFile& file, const std::vector<int>& bodies) {
  std::string words;
  for (std::size_t i = 0; i < bodies.size() && i < 6; ++i) words += (i ? ", " : "") + file.name_of(bodies[i]);
  return bodies.size() > 6 ? words + fmt::format(" and {} more", bodies.size() - 6) : words;
}

void show_doctor(Page& page, const SceneFile& file) {
  const doctor::Diagnosis diagnosis = doctor::diagnose(file);
  const char* says[] = {"The doctor finds nothing that would break this scene.",
                        "The doctor expects the scene to hold, near a limit.",
                        "The doctor expects the scene to fail by law @."};
  if (diagnosis.law() > 0)
    page.text(says[2], diagnosis.law());
  else
    page.text(says[static_cast<int>(diagnosis.grade())]);
  std::vector<std::vector<std::string>> rows;
  std::vector<int> marked;
  for (const doctor::Finding& finding : diagnosis.findings) {
    const bool fine = finding.grade == doctor::Grade::fine;
    const char* grades[] = {"fine", "near its limit", "fails"};
    rows.push_back({std::to_string(finding.law), grades[static_cast<int>(finding.grade)],
                    fmt::format("{} = {:.3g}, limit {:.3g}", finding.quantity, finding.number, finding.limit),
                    fine ? "" : words_of(file, finding.bodies)});
    if (finding.grade == doctor::Grade::fails)
      marked.insert(marked.end(), finding.bodies.begin(), finding.bodies.end());
  }
  page.table({"law", "", "number", "bodies"}, rows);
  for (const doctor::Finding& finding : diagnosis.findings) {
    if (finding.grade == doctor::Grade::fine) continue;
    std::string knobs;
    for (const doctor::Knob& knob : finding.knobs) knobs += (knobs.empty() ? "" : "; then ") + knob.words;
    page.text("**Law @.** @@", finding.law, finding.sentence,
              knobs.empty() ? "" : " What to turn, in this order: " + knobs + ".");
  }
  if (marked.empty()) return;
  const SceneLook look = look_of(file.scene);
  const std::vector<Placement> start =
      std::visit([](const auto& scene) { return AnyScene(scene).placements(); }, file.scene);
  page.figure("doctor", "The bodies that the findings name.", [=](Canvas& canvas) {
    draw(canvas, look, start, view_of(look, {start}), canvas.page().inset(24), marked);
  });
}

void show_cost(Page& page, const SceneFile& file, const std::shared_ptr<const Watched>& run,
               const Method& method) {
  const Effort& effort = run->effort;
  const double steps = std::max(1.0, static_cast<double>(effort.steps));
  page.table(
      {"a step", "count"},
      {{"uses of (17) and (20)",
        fmt::format("{:.0f}", static_cast<double>(effort.row_solves + effort.executed.projected_rows) / steps)},
       {"rows written", fmt::format("{:.0f}", static_cast<double>(effort.written_rows) / steps)},
       {"passes over the rows", fmt::format("{:.1f}", static_cast<double>(effort.executed.passes) / steps)}});
  page.clocked("time", "Time a step on this machine, over the first steps.", [=] {
    const AnyScene start = std::visit([](const auto& scene) { return AnyScene(scene); }, file.scene);
    const auto microseconds = [&](const Method& one) {
      AnyScene scene = start;
      if (!scene.refusal(one).empty()) return static_cast<double>(NAN);
      scene.use(one);
      constexpr int count = 60;
      const auto before = std::chrono::steady_clock::now();
      try {
        for (int i = 0; i < count; ++i) scene.step(file.step);
      } catch (const std::runtime_error&) {
        return static_cast<double>(NAN);
      }
      return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count() / count;
    };
    const std::vector<std::pair<std::string, Method>> all{
        {"as it is", method},
        {"10 sweeps", AnyStepping{GaussSeidel{}, Baumgarte{.slop = 0.001}}},
        {"by graph", AnyStepping{ByGraph{}, Baumgarte{.slop = 0.001}}}};
    Chart chart{.y = {.label = "time a step (µs)"}};
    renderer::Bars bars;
    for (const auto& [name, one] : all) {
      chart.bar_names.push_back(name);
      bars.values.push_back(microseconds(one));
    }
    chart.bars = {bars};
    return chart;
  });
}

}  // namespace

Lesson page_of(const SceneFile& given, const std::string& stem, bool with_chooser) {
  Lesson lesson({.slug = "00_" + stem,
                 .title = given.title.empty() ? stem : given.title,
                 .summary = "A scene from a file.",
                 .method = "as the file says"});
  const auto knobs = std::make_shared<const Knobs>(lesson, given);
  const auto runs = std::make_shared<Runs>(knobs);
  lesson.step("The scene", [=](Page& page) { show_scene(page, knobs->file(), *knobs); });
  lesson.step("What happens", [=](Page& page) { show_film(page, knobs->file(), runs->now()); });
  lesson.step("Energy and drift", [=](Page& page) { show_numbers(page, knobs->file(), runs->now()); });
  lesson.step("The doctor", [=](Page& page) { show_doctor(page, knobs->file()); });
  lesson.step("What it costs", [=](Page& page) { show_cost(page, knobs->file(), runs->now(), knobs->method()); });
  if (with_chooser) {
    const auto patience =
        lesson.parameter("patience", usual_patience, "s", {1, 1e5}, "how long the chooser looks for a method");
    lesson.step("The chooser", [=](Page& page) { show_chosen(page, knobs->file(), patience()); });
  }
  return lesson;
}

}  // namespace byhand::stage
