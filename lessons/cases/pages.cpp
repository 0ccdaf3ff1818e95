#include "lessons/cases/pages.hpp"

#include <fmt/format.h>

#include <memory>

#include "lessons/doctor/doctor.hpp"
#include "lessons/engines/contest.hpp"
#include "lessons/stage/looks.hpp"
#include "lessons/stage/watched.hpp"

namespace byhand::cases {
namespace {

using course::Page;

void show(Page& page, const std::vector<Number>& numbers) {
  for (const Number& number : numbers)
    page.claim(number.what, number.found, number.unit,
               course::is(number.predicted, number.from, number.tolerance()));
}

void film(Page& page, const std::string& name, const SceneFile& file,
          const std::shared_ptr<const stage::Watched>& run) {
  const stage::SceneLook look = stage::look_of(file.scene);
  const stage::View view = stage::view_of(look, run->instants);
  page.sequence(name, fmt::format("{}, {:.3g} s.", file.title, run->end()),
                course::Seconds{std::max(run->end(), 0.04)}, [=](renderer::Canvas& canvas, double time) {
                  draw(canvas, look, run->at(time), view, canvas.page(0.8).inset(24));
                  canvas.text({canvas.page().right() - 30, canvas.page().top() - 30},
                              fmt::format("{:.2f} s", time), {.anchor = renderer::Anchor::top_right});
                });
}

double row_solves_a_step(const stage::Watched& run) {
  return static_cast<double>(run.effort.row_solves + run.effort.executed.projected_rows) /
         std::max(1.0, static_cast<double>(run.effort.steps));
}

/// The case's question to each engine that this program was built with, as it is shipped.
void ask_engines(Page& page, const Question& question, const SceneFile& file) {
  const auto& scene = std::get<Scene<PlaneBody>>(file.scene);
  std::vector<std::vector<std::string>> rows;
  for (const engines::Engine& engine : engines::all_engines()) {
    if (!engine.in_plane || !refusal(engine, scene).empty()) continue;
    double found = 0;
    engines::run<PlaneBody>(engines::contestant<PlaneBody>(engine, engine.settings.contacts.front()), scene,
                            static_cast<int>(std::lround(question.seconds / engines::frame)),
                            [&](const Scene<PlaneBody>& seen, double) { found = question.read(seen); });
    rows.push_back({engine.name, engine.version, course::number(found, 3)});
  }
  if (rows.empty()) return;
  page.text("The same scene in other engines, as each is shipped:");
  page.table({"engine", "version", fmt::format("{} ({})", question.what, question.unit)}, rows);
}

/// What both runs of a case share between its steps.
struct Told {
  Case told;
  SceneFile file, cured;
  std::shared_ptr<const stage::Watched> run, run_cured;
};

}  // namespace

course::Lesson page_of(const Folder& folder) {
  const auto known = std::make_shared<Told>();
  known->told = folder.make();
  known->file = scene_of(folder);
  known->cured = known->told.cured(known->file);
  const auto runs = [known] {
    if (known->run) return;
    known->run = std::make_shared<const stage::Watched>(stage::watch(known->file));
    known->run_cured = std::make_shared<const stage::Watched>(stage::watch(known->cured));
  };
  course::Lesson lesson({.slug = folder.slug,
                         .title = known->told.title,
                         .summary = known->told.report,
                         .method = "as the file says"});
  lesson.step("The report", [=](Page& page) {
    page.text("@", known->told.report);
    page.text("Reported at @.", known->told.link);
    page.text("The scene as a file: `lessons/cases/@/scene.json`. `./lessons/run scene` runs it with any method.",
              folder.slug);
    const stage::SceneLook look = stage::look_of(known->file.scene);
    const std::vector<Placement> start =
        std::visit([](const auto& scene) { return AnyScene(scene).placements(); }, known->file.scene);
    page.figure("scene", known->file.title + ".", [=](renderer::Canvas& canvas) {
      draw(canvas, look, start, stage::view_of(look, {start}), canvas.page(0.8).inset(24));
    });
  });
  lesson.step("What the equations say", [=](Page& page) {
    page.text("@", known->told.why);
    page.formula(known->told.equation.plain, known->told.equation.latex);
  });
  lesson.step("The run", [=](Page& page) {
    runs();
    film(page, "as_reported", known->file, known->run);
    page.text("Each line is predicted from the equations before the run.");
    show(page, known->told.numbers(known->file));
    if (known->told.engines) ask_engines(page, *known->told.engines, known->file);
    const doctor::Diagnosis diagnosis = doctor::diagnose(known->file);
    if (diagnosis.law() > 0) page.text("The doctor says before the run: @", diagnosis.findings.front().sentence);
  });
  lesson.step("The cure", [=](Page& page) {
    runs();
    page.text("@", known->told.cure);
    film(page, "cured", known->cured, known->run_cured);
    show(page, known->told.numbers_cured(known->cured));
    page.text("It costs @ uses of (17) and (20) a step; the scene as reported costs @.",
              course::Value(row_solves_a_step(*known->run_cured), 2),
              course::Value(row_solves_a_step(*known->run), 2));
  });
  lesson.closing({.now_you_know = {known->told.takeaway},
                  .tries = {{"turn its knobs",
                             fmt::format("./lessons/run scene lessons/cases/{}/scene.json --list-parameters",
                                         folder.slug)}}});
  return lesson;
}

}  // namespace byhand::cases
