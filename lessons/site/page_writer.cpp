#include "lessons/site/page_writer.hpp"

#include <fmt/format.h>

#include "lessons/site/json.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/markup.hpp"
#include "lessons/tutor/picture_writer.hpp"
#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace byhand::site {
namespace {

namespace fs = std::filesystem;
using namespace tutor;

std::string link(const std::string& path, const char* words) {
  return fmt::format("<a href=\"{}\">{}</a>", path, words);
}

/// The pictures that a PictureWriter has written into the lesson's folder, and links to their files.
class Written {
 public:
  Written(const fs::path& site, const std::string& slug) : site_(site), folder_(slug + "/") {}

  Shown operator()(const Figure& figure) const {
    const bool is_drawing = std::holds_alternative<Drawing>(figure.picture);
    // What a clock measured stays out of the page, whose bytes are the same each time.
    const std::string svg = folder_ + svg_path(figure.name);
    const std::string markup =
        std::holds_alternative<TimedChart>(figure.picture)
            ? fmt::format("<img src=\"{}\" alt=\"Measured running times; the numbers are in the CSV file.\" />",
                          svg)
            : drawn(figure.name);
    return {markup, links(folder_ + figure_path(figure.name), svg) +
                        (is_drawing ? "" : " " + link(folder_ + data_path(figure.name), "CSV"))};
  }
  Shown operator()(const Sequence& film) const {
    return {drawn(film.name), links(folder_ + strip_path(film.name), folder_ + svg_path(film.name))};
  }

 private:
  static std::string links(const std::string& png, const std::string& svg) {
    return link(svg, "SVG") + " " + link(png, "PNG");
  }
  std::string drawn(const std::string& name) const {
    const fs::path path = site_ / folder_ / svg_path(name);
    const auto svg = renderer::read_whole(path);
    if (!svg) throw renderer::EnvironmentError(fmt::format("Cannot read {}.", path.string()));
    return *svg;
  }

  fs::path site_;
  std::string folder_;
};

}  // namespace

void write_page(const Lesson& lesson, const std::vector<RecordedStep>& steps,
                const std::filesystem::path& folder) {
  const std::string& slug = lesson.about().slug;
  const Written written(folder, slug);
  renderer::write_whole(folder / (slug + ".json"), to_json(digest(lesson, steps)));
  renderer::write_whole(folder / page_of(slug), lesson_page(lesson, steps, {.figure = written, .film = written}));
}

}  // namespace byhand::site
