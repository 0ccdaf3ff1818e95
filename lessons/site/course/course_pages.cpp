#include "lessons/site/course/course_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "lessons/equations.hpp"
#include "lessons/site/course/reading.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/markup.hpp"
#include "lessons/site/mathml.hpp"
#include "lessons/tutor/equations.hpp"

namespace byhand::site {
namespace {

using namespace tutor;

std::string list(const std::vector<std::string>& items) {
  std::string all = "<ul>";
  for (const std::string& item : items) all += "<li>" + inline_html(item) + "</li>";
  return all + "</ul>";
}

const About& about(const Digest& lesson) {
  const auto& all = contents();
  return *std::find_if(all.begin(), all.end(), [&](const About& one) { return one.slug == lesson.slug; });
}

std::string step_link(const Digest& lesson, const Digest::Step& step) {
  return fmt::format("<a href=\"{}#step-{}\">{} {}</a>", page_of(lesson.slug), step.label, step.label,
                     inline_html(step.title, Links::none));
}

std::string card(const Digest& lesson) {
  const About& it = about(lesson);
  std::string steps;
  int questions = 0;
  for (const Digest::Step& step : lesson.steps) {
    steps += fmt::format("<li{}>{}</li>\n", step.deeper ? " class=\"deeper\"" : "", step_link(lesson, step));
    questions += step.questions;
  }
  return fmt::format(
      "<section class=\"card\" id=\"{}\">\n<p class=\"number\">{}</p>\n<div>\n<h2><a href=\"{}\">{}</a></h2>\n"
      "<p class=\"summary\">{}</p>\n<p class=\"facts\">{}; {}, {}, {}, {}</p>\n"
      "<details><summary>Goals and steps</summary>\n<p>Afterwards you can</p>\n{}\n<p><strong>Before:</strong> "
      "{}</p>\n"
      "<ol class=\"steps\">\n{}</ol>\n</details>\n</div>\n</section>\n",
      lesson.slug, std::stoi(lesson.slug), page_of(lesson.slug), escaped(it.title), inline_html(it.summary),
      in_words(reading_time(lesson)), several(questions, "prediction"), several(lesson.figures, "figure"),
      several(lesson.films, "film"), several(lesson.claims, "checked claim"), list(it.goals),
      inline_html(it.before), steps);
}

}  // namespace

std::string contents_page(const std::vector<Digest>& lessons) {
  std::string cards;
  int claims = 0;
  for (const Digest& lesson : lessons) {
    cards += card(lesson);
    claims += lesson.claims;
  }
  return framed(
      {.title = "Lessons",
       .content = fmt::format(
           "<header class=\"cover\">\n<h1>Constraints by Hand</h1>\n<p class=\"summary\">A course that derives "
           "physical "
           "constraints, solves them and keeps them stable, and shows where each method fails and what its "
           "accuracy "
           "costs. Every number in it was computed by the C++ that it quotes, and {} of them are checked against "
           "independent answers.</p>\n<p><a class=\"start\" href=\"{}\">Begin with lesson "
           "1</a></p>\n</header>\n{}",
           claims, page_of(lessons.front().slug), cards),
       .here = "index.html"});
}

std::string equations_page() {
  std::string rows;
  for (int i = 1; i <= article_equations; ++i) {
    const EquationPlace& place = equation_places[static_cast<size_t>(i - 1)];
    const About& lesson = contents()[static_cast<size_t>(place.lesson - 1)];
    rows += fmt::format(
        "<section class=\"law\" id=\"equation-{0}\">\n<h2>({0}) {1}</h2>\n<div class=\"equation\"><div "
        "class=\"formula\">"
        "{2}</div></div>\n<p>Derived or used first in <a href=\"{3}#step-{4}\">lesson {5}, step {4}</a>.</p>\n"
        "</section>\n",
        i, inline_html(place.says, Links::none), display_mathml(article_equation(i).latex), page_of(lesson.slug),
        place.step, place.lesson);
  }
  return framed(
      {.title = "Equations",
       .content = fmt::format("<h1>Equations (1) to ({})</h1>\n<p class=\"summary\">As R. Gaul prints them in "
                              "<cite>Modelling and Solving Physical Constraints</cite>, 2013. Wherever a "
                              "lesson cites one, its number brings it back.</p>\n{}",
                              article_equations, rows),
       .here = "equations.html"});
}

std::string laws_page(const std::vector<Digest>& lessons) {
  std::string all;
  for (const Digest& lesson : lessons) {
    std::string rows;
    for (const Digest::Step& step : lesson.steps)
      for (const std::string& law : step.laws)
        rows += fmt::format("<li><strong>{}</strong><br />{}</li>\n", inline_html(law), step_link(lesson, step));
    if (!rows.empty())
      all += fmt::format("<section>\n<h2>{}</h2>\n<ul class=\"laws\">\n{}</ul>\n</section>\n",
                         escaped(lesson_title(lesson.slug)), rows);
  }
  return framed(
      {.title = "Laws",
       .content = "<h1>Laws and derivations</h1>\n<p class=\"summary\">What the lessons derive line by line, "
                  "beyond the article. Each is held against what was measured.</p>\n" +
                  all,
       .here = "laws.html"});
}

}  // namespace byhand::site
