#include "lessons/site/course/downloads.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/site/bitmaps.hpp"
#include "lessons/site/course/page_text.hpp"
#include "lessons/site/course/zip.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/lesson_page.hpp"
#include "renderer/data_url.hpp"

namespace byhand::site {

namespace fs = std::filesystem;

namespace {

/// A picture of a page as one file, with the bitmaps that stand beside the page.
std::string whole(const fs::path& site, const std::string& svg) {
  std::string all = loaded_at_once(svg);
  keep_no_room(all);
  constexpr std::string_view image = "<image ", address = " href=\"";
  for (auto at = all.find(image); at != std::string::npos; at = all.find(image, at)) {
    at = all.find(address, at) + address.size();
    const auto size = all.find('"', at) - at;
    all.replace(at, size, renderer::data_url(course::read_whole(site / all.substr(at, size)).value_or("")));
  }
  return all;
}

}  // namespace

std::string answer_key(const fs::path& site, const std::vector<Digest>& lessons) {
  std::string all;
  for (const Digest& lesson : lessons) {
    std::string page = content_of_page(site / page_of(lesson.slug));
    const std::string answers = take_answers(page, page_of(lesson.slug));
    if (!answers.empty())
      all += fmt::format("<section id=\"key-{}\">\n<h2>{}</h2>\n{}</section>\n", lesson.slug,
                         escaped(lesson_title(lesson.slug)), answers);
  }
  // An id is that of one lesson's question.
  replace_all(all, " id=\"answer-", "\"", "");
  return framed(
      {.title = "Answers",
       .content = "<h1>Answers</h1>\n<p class=\"summary\">Hints and the answer to every question of the lessons, "
                  "with the parameters that the pages begin with. Delete this file, "
                  "<code>answers.html</code>, from a site for students, or write the site with "
                  "<code class=\"whole\">--without-answers</code>.</p>\n" +
                  all,
       .exercises = has_exercises(site)});
}

std::string figures_of(const fs::path& site, const Digest& lesson) {
  const std::string page = course::read_whole(site / page_of(lesson.slug)).value_or("");
  Zip zip;
  constexpr std::string_view begin = "<figure class=\"", id = " id=\"", svg = "<svg", end = "</svg>";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const auto name = page.find(id, at) + id.size(), close = page.find("</figure>", at),
               first = page.find(svg, at);
    if (first >= close) continue;
    const std::string file = page.substr(name, page.find('"', name) - name) + ".svg";
    const auto film = course::read_whole(site / lesson.slug / "films" / file);
    zip.add(file, film ? *film : whole(site, page.substr(first, page.find(end, first) + end.size() - first)));
  }
  std::vector<fs::path> data;
  if (fs::is_directory(site / lesson.slug / "data"))
    for (const auto& entry : fs::directory_iterator(site / lesson.slug / "data"))
      // What a clock measured would make every archive another one.
      if (!fs::exists(site / lesson.slug / "figures" / entry.path().filename().replace_extension(".svg")))
        data.push_back(entry.path());
  std::sort(data.begin(), data.end());
  for (const fs::path& file : data) zip.add(file.filename().string(), course::read_whole(file).value_or(""));
  return zip.finish();
}

}  // namespace byhand::site
