#include "lessons/site/course/course_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/equation_places.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/page/html/mathml.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/reading.hpp"

namespace byhand::site {
namespace {

using namespace course;

std::string list(const std::vector<std::string>& items) {
  std::string all = "<ul>";
  for (const std::string& item : items) all += "<li>" + inline_html(item) + "</li>";
  return all + "</ul>";
}

const About& about(const Digest& lesson) {
  const auto& all = contents();
  return *std::find_if(all.begin(), all.end(), [&](const About& one) { return one.slug == lesson.slug; });
}

/// Where an equation is displayed first, if the course has that lesson.
std::string first_place(const EquationPlace& place) {
  for (const About& lesson : contents())
    if (std::stoi(lesson.slug) == place.lesson)
      return fmt::format(R"(<p>First in <a href="{}#step-{}">lesson {}, step {}</a>.</p>)", page_of(lesson.slug),
                         place.step, place.lesson, place.step);
  return "";
}

std::string step_link(const Digest& lesson, const Digest::Step& step) {
  return fmt::format(R"(<a href="{}#step-{}">{} {}</a>)", page_of(lesson.slug), step.label, step.label,
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
  return fmt::format(R"(<section class="card" id="{}">
<p class="number">{}</p>
<div>
<h2><a href="{}">{}</a></h2>
<p class="summary">{}</p>
<p class="facts">{}; {}, {}, {}, {}</p>
<details><summary>Goals and steps</summary>
<p>Afterwards you can</p>
{}
<p><strong>Before:</strong> {}</p>
<ol class="steps">
{}</ol>
</details>
</div>
</section>
)",
                     lesson.slug, std::stoi(lesson.slug), page_of(lesson.slug), escaped(it.title),
                     inline_html(it.summary), in_words(reading_time(lesson)), several(questions, "prediction"),
                     several(lesson.figures, "figure"), several(lesson.films, "film"),
                     several(lesson.claims, "checked claim"), list(it.goals), inline_html(it.before), steps);
}

}  // namespace

std::string contents_page(const std::vector<Digest>& lessons, bool desk) {
  std::string cards;
  int claims = 0;
  for (const Digest& lesson : lessons) {
    cards += card(lesson);
    claims += lesson.claims;
  }
  constexpr auto summary =
      "A course that derives physical constraints, solves them and keeps them stable, with the C++ that computes "
      "every "
      "figure live in the page.";
  return framed({.title = "Lessons",
                 .content = fmt::format(R"(<header class="cover">
<h1>Constraints by Hand</h1>
<p class="summary">A course that derives physical constraints, solves them and keeps them stable, and shows where each method
fails and what its accuracy costs. Every number in it was computed by the C++ that it quotes; {} of them are checked against
independent answers.</p>
<p><a class="start" href="{}">Begin with lesson {}</a></p>
{}</header>
{})",
                                        claims, page_of(lessons.front().slug), std::stoi(lessons.front().slug),
                                        desk ? "<p><a href=\"desk.html\">The derivation desk</a>: derive a "
                                               "constraint yourself, and be told which line "
                                               "is wrong and why.</p>\n"
                                             : "",
                                        cards),
                 .summary = summary,
                 .here = "index.html"});
}

std::string equations_page() {
  std::string rows;
  for (int i = 1; i <= article_equations; ++i) {
    const EquationPlace& place = equation_places[static_cast<size_t>(i - 1)];
    rows += fmt::format(R"(<section class="law" id="equation-{0}">
<h2>({0}) {1}</h2>
<div class="equation"><div class="formula">{2}</div></div>
{3}
</section>
)",
                        i, inline_html(place.says, Links::none), display_mathml(article_equation(i).latex),
                        first_place(place));
  }
  return framed({.title = "Equations",
                 .content = fmt::format(R"(<h1>Equations (1) to ({})</h1>
<p class="summary">As R. Gaul prints them in <cite>Modelling and Solving Physical Constraints</cite>, 2013. Wherever a lesson
cites one, its number brings it back.</p>
{})",
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
  return framed({.title = "Laws",
                 .content = R"(<h1>Laws and derivations</h1>
<p class="summary">What the lessons derive line by line, beyond the article. Each is held against what was measured.</p>
)" + all,
                 .here = "laws.html"});
}

}  // namespace byhand::site
