#include "lessons/site/frame.hpp"

#include <fmt/format.h>

#include <array>

#include "lessons/page/html/markup.hpp"

namespace byhand::site {
namespace {

struct Destination {
  std::string_view page, words;
};
constexpr std::string_view exercises = "practise.html";
constexpr std::array<Destination, 6> destinations{{{"index.html", "Lessons"},
                                                   {"playground.html", "Playground"},
                                                   {exercises, "Exercises"},
                                                   {"equations.html", "Equations"},
                                                   {"laws.html", "Laws"},
                                                   {"teaching.html", "For teachers"}}};

std::string navigation(const Frame& frame) {
  std::string all;
  for (const auto& [page, words] : destinations)
    if (page != exercises || frame.exercises)
      all += fmt::format("<li><a href=\"{}\"{}>{}</a></li>", page,
                         page == frame.here ? " aria-current=\"page\"" : "", words);
  return all;
}

std::string described(const Frame& frame) {
  if (frame.summary.empty()) return "";
  return fmt::format(
             "<meta name=\"description\" content=\"{0}\" />\n<meta property=\"og:title\" content=\"{1}\" />\n"
             "<meta property=\"og:description\" content=\"{0}\" />\n",
             escaped(plain_text(frame.summary)), escaped(frame.title)) +
         (frame.picture.empty() ? ""
                                : fmt::format("<meta property=\"og:image\" content=\"{}\" />\n"
                                              "<meta name=\"twitter:card\" content=\"summary_large_image\" />\n",
                                              frame.picture));
}

}  // namespace

bool has_exercises(const std::filesystem::path& site) { return std::filesystem::exists(site / "practise"); }

std::string narrow_pictures(const std::string& slug) { return slug + "/narrow.js"; }

std::string framed(const Frame& frame) {
  const std::string beside =
      frame.beside.empty()
          ? ""
          : fmt::format("<nav class=\"beside\" aria-label=\"This page\">{}</nav>\n", frame.beside);
  return fmt::format(
      R"(<!DOCTYPE html>
<html lang="en" xmlns="http://www.w3.org/1999/xhtml"{1}>
<head>
<meta charset="utf-8" />
<meta name="viewport" content="width=device-width, initial-scale=1" />
<meta name="color-scheme" content="light dark" />
<title>{0} – Constraints by Hand</title>
{8}<link rel="icon" type="image/svg+xml" href="assets/icon.svg" />
<link rel="stylesheet" href="assets/style.css" />
<script src="assets/fonts.js"></script>
<script defer="defer" src="assets/equations.js"></script>
<script defer="defer" src="assets/site.js"></script>
{7}</head>
<body>
<a class="skip" href="#content">Skip to the content</a>
<header class="top">
<a class="course" href="index.html">Constraints by Hand</a>
<nav aria-label="Course"><button class="menu" type="button" popovertarget="course-pages">Menu</button><ul id="course-pages" popover="auto">{2}</ul></nav>
<div class="search" role="search" data-index="assets/search.js"></div>
</header>
<div class="page{3}">
{4}<main id="content" tabindex="-1">
<p class="printed">{0} – Constraints by Hand</p>
{5}</main>
</div>
<footer class="bottom">
<p>Constraints by Hand, MIT licence. Equations (1) to (23) are those of R. Gaul, <cite>Modelling and Solving Physical Constraints</cite>, 2013. <a href="teaching.html#licence">Licences</a></p>
</footer>
{6}</body>
</html>
)",
      escaped(frame.title),
      (frame.lesson.empty() ? "" : fmt::format(" data-lesson=\"{}\"", frame.lesson)) +
          (frame.narrow.empty() ? "" : fmt::format(" data-narrow=\"{}\"", narrow_pictures(frame.narrow))),
      navigation(frame), beside.empty() ? "" : " with-beside", beside, frame.content, frame.foot, frame.head,
      described(frame));
}

}  // namespace byhand::site
