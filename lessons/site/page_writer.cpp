#include "lessons/site/page_writer.hpp"

#include <fmt/format.h>

#include "lessons/site/json.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/markup.hpp"
#include "lessons/tutor/picture_writer.hpp"
#include "renderer/file.hpp"

namespace byhand::site {
namespace {

using namespace tutor;

std::string image(const std::string& path, const std::string& words) {
  return fmt::format("<img src=\"{}\" alt=\"{}\" loading=\"lazy\" width=\"1280\" height=\"720\" />", path,
                     escaped(plain_text(words)));
}

std::string link(const std::string& path, const char* words) {
  return fmt::format("<a href=\"{}\">{}</a>", path, words);
}

/// Links to the files of a lesson.
Pictures linked(const std::string& slug) {
  const std::string folder = slug + "/";
  return {.figure =
              [folder](const Figure& figure, const std::string& words) {
                const std::string path = folder + figure_path(figure.name);
                std::string links = link(path, "PNG");
                if (!std::holds_alternative<Drawing>(figure.picture))
                  links += " " + link(folder + data_path(figure.name), "CSV");
                return Shown{image(path, words), links};
              },
          .film =
              [folder](const Sequence& film, const std::string& words) {
                const std::string path = folder + strip_path(film.name);
                return Shown{image(path, words), link(path, "PNG")};
              }};
}

}  // namespace

void write_page(const Lesson& lesson, const std::vector<RecordedStep>& steps,
                const std::filesystem::path& folder) {
  const std::string& slug = lesson.about().slug;
  renderer::write_whole(folder / (slug + ".json"), to_json(digest(lesson, steps)));
  renderer::write_whole(folder / page_of(slug), lesson_page(lesson, steps, linked(slug)));
}

}  // namespace byhand::site
