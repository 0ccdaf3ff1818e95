#include "lessons/site/page_writer.hpp"

#include <fmt/format.h>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/chart_data.hpp"
#include "lessons/files/lesson_json.hpp"
#include "lessons/files/picture_writer.hpp"
#include "lessons/page/html/drawn.hpp"
#include "lessons/page/html/seekable_film.hpp"
#include "lessons/page/html/step_html.hpp"
#include "lessons/site/bitmaps.hpp"
#include "lessons/site/card.hpp"
#include "lessons/site/controls.hpp"
#include "lessons/site/film_file.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/page_json.hpp"
#include "lessons/site/turned_step.hpp"
#include "renderer/opengl/space_picture.hpp"

namespace byhand::site {
namespace {

namespace fs = std::filesystem;
using namespace course;

/// Draws pictures into the page and writes their data beside it.
class Drawer {
 public:
  Drawer(const fs::path& site, const std::string& slug) : site_(site), folder_(slug + "/") {}

  Shown operator()(const Figure& figure) const {
    if (const auto* chart = chart_of(figure)) course::write_whole(site_ / data(figure), csv(*chart));
    const std::string link =
        std::holds_alternative<Drawing>(figure.picture) ? "" : fmt::format("<a href=\"{}\">CSV</a>", data(figure));
    const std::string svg = loaded_when_seen(drawn(figure, in_files(figure.name)));
    if (!std::holds_alternative<TimedChart>(figure.picture)) return {svg, link};
    // What a clock measured stays out of the page, whose bytes are the same each time.
    const std::string path = folder_ + "figures/" + figure.name + ".svg";
    course::write_whole(site_ / path, svg);
    return {fmt::format("<img src=\"{}\" alt=\"\" width=\"1280\" height=\"720\" />", path),
            fmt::format("<a href=\"{}\">SVG</a> {}", path, link)};
  }

  Shown operator()(const Sequence& film) const {
    SeekableFilm shown(film);
    const auto first = [&](renderer::Canvas& canvas) { shown.draw(canvas, 0); };
    return {shown.screen(loaded_when_seen(drawn(film.name, first, in_files(film.name))))};
  }

 private:
  /// Draws what a picture shows in space into files beside the page.
  renderer::SvgCanvas::DrawWindow in_files(const std::string& name) const {
    return [this, name, count = 0](const auto& window, const auto& page, auto paper) mutable {
      const std::string path = fmt::format("{}figures/{}-{}.png", folder_, name, ++count);
      course::write_whole(site_ / path, renderer::space_picture(window, page, paper));
      return path;
    };
  }

  std::string data(const Figure& figure) const { return folder_ + data_path(figure.name); }

  fs::path site_;
  std::string folder_;
};

/// For the archive that a teacher takes along.
void write_films(const std::vector<RecordedStep>& steps, const fs::path& folder) {
  for (const RecordedStep& step : steps)
    for (const Item& item : step.page.items())
      if (const auto* film = std::get_if<Sequence>(&item))
        course::write_whole(folder / ("film-" + film->name + ".svg"), film_file(*film));
}

}  // namespace

Told told(const Lesson& lesson, const fs::path& folder, bool quiet) {
  const Drawer drawer(folder, lesson.about().slug);
  Told all;
  for (const Step& step : lesson.steps()) {
    forget_reads(lesson);
    all.steps.push_back(record_step(lesson, step, quiet));
    all.sections.push_back(step_html(all.steps.back(), {.figure = drawer, .film = drawer}));
    all.steps.back().reads = reads(lesson);
  }
  validate(all.steps);
  return all;
}

std::vector<RecordedStep> write_page(Lesson& lesson, const fs::path& folder, bool quiet) {
  const std::string& slug = lesson.about().slug;
  auto [steps, sections] = told(lesson, folder, quiet);
  const bool live = fs::exists(folder / "live" / (slug + ".js"));
  std::string all;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i + 1 < steps.size())
      sections[i].insert(
          sections[i].find("<h2>"),
          fmt::format("<a class=\"skip\" href=\"#step-{0}\">Skip to step {0}</a>\n", steps[i + 1].step->label));
    if (!live) {
      all += sections[i];
      continue;
    }
    TurnedStep turned(lesson, *steps[i].step);
    all += with_controls(sections[i], steps[i], steps, [&](const std::string& picture, const std::string& name) {
      return turned.changes(picture, name);
    });
  }
  write_card(steps, folder / slug);
  write_films(steps, folder / slug / "films");
  course::write_whole(folder / page_of(slug), lesson_page(lesson, steps, all, live, has_exercises(folder)));
  course::write_whole(folder / (slug + ".json"), to_json(digest(lesson, steps)));
  course::write_whole(folder / "questions" / (slug + ".json"), course::questions(lesson, steps));
  return steps;
}

}  // namespace byhand::site
