#include "lessons/site/course/course_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/equation_places.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/page/html/mathml.hpp"
#include "lessons/site/course/law_table.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/reading.hpp"

namespace byhand::site {
namespace {

using namespace course;

constexpr auto article_address =
    "https://gamedevelopment.tutsplus.com/tutorials/modelling-and-solving-physical-constraints--gamedev-12578";

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
  return fmt::format(R"(<section class="card" id="{0}">
<img src="{0}/card.svg" alt="" width="1280" height="720" loading="lazy" />
<div>
<h2><a href="{2}">{1}. {3}</a></h2>
<p class="summary">{4}</p>
<p class="facts">{5}; {6}, {7}, {8}, {9}</p>
<details><summary>Goals and steps</summary>
<p>Afterwards you can</p>
{10}
<p><strong>Before:</strong> {11}</p>
<ol class="steps">
{12}</ol>
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

std::string contents_page(const std::vector<Digest>& lessons, const Cover& cover) {
  std::string cards, links;
  int claims = 0;
  for (const Digest& lesson : lessons) {
    cards += card(lesson);
    claims += lesson.claims;
  }
  const auto link = [&](const std::string& to, const char* words, const char* what) {
    links += fmt::format("<li><a href=\"{}\">{}</a>{}</li>\n", escaped(to), words, what);
  };
  link("playground.html", "The playground", ": build a scene, throw it, and see which law breaks it");
  if (cover.cases)
    link("cases.html", "The casebook", ": reports of engines' users, predicted from the equations, run and cured");
  if (cover.desk)
    link("desk.html", "The derivation desk", ": derive a constraint yourself, and be told which line is wrong");
  if (cover.exercises)
    link("practise.html", "Write it yourself",
         ": functions of the course in C++, compiled and judged in the page");
  link("constraints_by_hand.epub", "The whole course as an e-book", "");
  if (!cover.repository.empty())
    link(cover.repository, "The repository", ": its source, its tests, its exercises");
  link(article_address, "The article", " that the course follows: R. Gaul, 2013");
  constexpr auto summary =
      "Derive a physical constraint by hand, solve it, break it, and see in the page what each choice costs.";
  const About& first = about(lessons.front());
  return framed({.title = "Lessons",
                 .content = fmt::format(R"(<div class="cover">
<header>
<h1>Constraints by Hand</h1>
<p class="summary">{0}</p>
</header>
{4}<p class="begin"><a class="start" href="{1}">Begin with lesson {2}: {3}</a></p>
</div>
<div class="cards">
{6}</div>
<ul class="ways">
{5}</ul>
<p class="facts">{7} numbers of these pages are checked against independent answers whenever they are computed.</p>
)",
                                        summary, page_of(lessons.front().slug), std::stoi(lessons.front().slug),
                                        escaped(first.title), cover.scene.section, links, cards, claims),
                 .summary = summary,
                 .picture = cover.scene.section.empty() ? "" : "03_iterations/card.png",
                 .head = cover.scene.head,
                 .foot = cover.scene.foot,
                 .here = "index.html",
                 .exercises = cover.exercises});
}

std::string equations_page(bool exercises) {
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
                 .here = "equations.html",
                 .exercises = exercises});
}

std::string laws_page(const std::vector<Digest>& lessons, bool exercises) {
  std::string all;
  for (const Digest& lesson : lessons) {
    std::string rows;
    for (const Digest::Step& step : lesson.steps)
      for (const std::string& law : step.laws)
        rows += fmt::format("<li><strong>{}</strong><br />{}</li>\n", inline_html(law), step_link(lesson, step));
    if (!rows.empty())
      all += fmt::format("<section>\n<h3>{}</h3>\n<ul class=\"laws\">\n{}</ul>\n</section>\n",
                         escaped(lesson_title(lesson.slug)), rows);
  }
  return framed(
      {.title = "Laws",
       .content = "<h1>Laws of failure</h1>\n<p class=\"summary\">Where methods fail, derived before it was "
                  "measured. In print the table is one page.</p>\n" +
                  law_table(lessons) +
                  "<section class=\"derivations\">\n<h2>Derivations</h2>\n<p>What the lessons derive line by "
                  "line, beyond the article.</p>\n" +
                  all + "</section>\n",
       .here = "laws.html",
       .exercises = exercises});
}

}  // namespace byhand::site
