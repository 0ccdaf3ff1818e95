#include "lessons/site/page_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

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

/// "<svg …" or "<img …" with room for the picture that a narrow page shows in its place: what has a width and a
/// height has their ratio.
std::string with_room_for(const std::string& narrow_one, std::string markup) {
  constexpr std::string_view box = " viewBox=\"0 0 ";
  const auto size = narrow_one.find(box) + box.size(), blank = narrow_one.find(' ', size);
  const std::string width = narrow_one.substr(size, blank - size),
                    height = narrow_one.substr(blank + 1, narrow_one.find('"', blank) - blank - 1);
  const auto at = std::min(markup.find("<svg "), markup.find("<img ")) + 5;
  return markup.insert(at, fmt::format("width=\"{}\" height=\"{}\" ", width, height));
}

/// Draws pictures into the page and writes their data beside it.
class Drawer {
 public:
  /// `narrow_ones` takes what a narrow page shows, by the id of the figure.
  Drawer(const fs::path& site, const std::string& slug, std::map<std::string, std::string>& narrow_ones)
      : site_(site), folder_(slug + "/"), narrow_(&narrow_ones) {}

  Shown operator()(const Figure& figure) const {
    const auto* chart = chart_of(figure);
    const std::string values = chart != nullptr ? csv(*chart) : figure.data;
    if (!values.empty()) course::write_whole(site_ / data(figure), values);
    const std::string link = values.empty() ? "" : fmt::format("<a href=\"{}\">CSV</a>", data(figure));
    const auto draw = [&](int width) { return drawn(figure, in_files(figure.name, width), width); };
    const std::string id = "figure-" + figure.name;
    if (!std::holds_alternative<TimedChart>(figure.picture)) return shown(id, draw, in_page, link);
    // What a clock measured stays out of the page, whose bytes are the same each time.
    const auto path = [&](int width) { return folder_ + "figures/" + named(figure.name, width) + ".svg"; };
    const auto image = [&](const std::string& svg, int width) {
      course::write_whole(site_ / path(width), svg);
      return fmt::format("<img src=\"{}\" alt=\"\" />", path(width));
    };
    return shown(id, draw, image, fmt::format("<a href=\"{}\">SVG</a> {}", path(wide), link));
  }

  Shown operator()(const Sequence& film) const {
    SeekableFilm seekable(film);
    const auto first = [&](renderer::Canvas& canvas) { seekable.draw(canvas, 0); };
    return shown(
        "film-" + film.name, [&](int width) { return drawn(film.name, first, in_files(film.name, width), width); },
        [&](const std::string& svg, int) { return seekable.screen(svg); });
  }

 private:
  static std::string in_page(const std::string& svg, int /*width*/) { return svg; }

  /// The picture that `draw` draws at a width, as `markup` puts it into the page.
  template <class Draw, class Markup>
  Shown shown(const std::string& id, const Draw& draw, const Markup& markup, const std::string& links = "") const {
    const std::string on_phones = draw(narrow), here = markup(draw(wide), wide);
    if (!is_legible(on_phones)) return {loaded_when_seen(here), links, true};
    const auto roomy = [&](const std::string& it) { return loaded_when_seen(with_room_for(on_phones, it)); };
    (*narrow_)[id] = roomy(markup(on_phones, narrow));
    return {roomy(here), links};
  }

  static std::string named(const std::string& name, int width) {
    return name + (width == narrow ? "-narrow" : "");
  }

  /// Draws what a picture shows in space into files beside the page.
  renderer::SvgCanvas::DrawWindow in_files(const std::string& name, int width) const {
    return [this, name = named(name, width), count = 0](const auto& window, const auto& page, auto paper) mutable {
      const std::string path = fmt::format("{}figures/{}-{}.png", folder_, name, ++count);
      course::write_whole(site_ / path, renderer::space_picture(window, page, paper));
      return path;
    };
  }

  std::string data(const Figure& figure) const { return folder_ + data_path(figure.name); }

  fs::path site_;
  std::string folder_;
  std::map<std::string, std::string>* narrow_;
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
  Told all;
  const Drawer drawer(folder, lesson.about().slug, all.narrow);
  for (const Step& step : lesson.steps()) {
    forget_reads(lesson);
    all.steps.push_back(record_step(lesson, step, quiet));
    all.sections.push_back(step_html(all.steps.back(), {.figure = drawer, .film = drawer}));
    all.steps.back().reads = reads(lesson);
  }
  validate(all.steps);
  return all;
}

void write_narrow(const std::map<std::string, std::string>& pictures, const fs::path& folder,
                  const std::string& slug) {
  course::write_whole(folder / (narrow_pictures(slug) + "on"), nlohmann::json(pictures).dump());
}

std::vector<RecordedStep> write_page(Lesson& lesson, const fs::path& folder, bool quiet) {
  const std::string& slug = lesson.about().slug;
  auto [steps, sections, narrow_ones] = told(lesson, folder, quiet);
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
  write_narrow(narrow_ones, folder, slug);
  write_card(steps, folder / slug);
  write_films(steps, folder / slug / "films");
  course::write_whole(folder / page_of(slug), lesson_page(lesson, steps, all, live, has_exercises(folder)));
  course::write_whole(folder / (slug + ".json"), to_json(digest(lesson, steps)));
  course::write_whole(folder / "questions" / (slug + ".json"), course::questions(lesson, steps));
  return steps;
}

}  // namespace byhand::site
