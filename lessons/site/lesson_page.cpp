#include "lessons/site/lesson_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "lessons/page/html/code_html.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/site/digest.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/page_json.hpp"
#include "lessons/site/reading.hpp"

namespace byhand::site {
namespace {

using namespace course;

std::string steps_beside(const std::vector<RecordedStep>& steps) {
  std::string all;
  for (const auto& [step, page, reads] : steps)
    all +=
        fmt::format("<li{0}><a href=\"#step-{1}\"><span>{1}</span> <span>{2}</span></a></li>\n",
                    step->deeper ? " class=\"deeper\"" : "", step->label, inline_html(step->title, Links::none));
  return "<details><summary>In this lesson</summary>\n<ol>\n" + all + "</ol>\n</details>\n";
}

std::string goals(const About& about) {
  if (about.goals.empty()) return "";
  std::string all;
  for (const std::string& goal : about.goals) all += "<li>" + inline_html(goal) + "</li>\n";
  return fmt::format(R"(<details class="goals"><summary>Goals and what it takes</summary>
<p>Afterwards you can</p>
<ul>
{}</ul>
<p><strong>Before:</strong> {}</p>
</details>
)",
                     all, inline_html(about.before));
}

std::string parameters(const Lesson& lesson) {
  if (lesson.parameters().empty()) return "";
  std::string rows;
  for (const ParameterRecord& p : lesson.parameters())
    rows += fmt::format(
        "<tr data-parameter=\"{0}\"><th scope=\"row\"><code>{0}</code></th><td>{1}</td><td>{2}</td><td>{3}</td>"
        "<td>{4}</td></tr>\n",
        p.name, p.typed(p.value), escaped(p.unit), escaped(p.allowed()), inline_html(p.meaning));
  return fmt::format(
      "<details class=\"parameters\"><summary>{} of this lesson</summary><div class=\"scroll\"><table><thead><tr>"
      "<th scope=\"col\">name</th><th scope=\"col\">value</th><th scope=\"col\">unit</th>"
      "<th scope=\"col\">allowed</th><th scope=\"col\">meaning</th></tr></thead><tbody>\n{}</tbody></table></div>"
      "</details>\n",
      several(static_cast<long>(lesson.parameters().size()), "parameter"), rows);
}

/// Why a page computes nothing again.
std::string static_page(const Lesson& lesson) {
  const About& about = lesson.about();
  return fmt::format(
      "<p class=\"facts\">This page has no sliders: {}. <code>./lessons/run {}</code> computes it with your own "
      "values.</p>\n",
      escaped(about.native.empty() ? "its program was not compiled for a browser" : about.native),
      lesson.number());
}

/// The settings of "./lessons/run 6 --step 5 --set strength=0.4" as a link of the live page:
/// "#step-5&strength=0.4". Without a step it leads to the first one that reads what is set.
std::string settings_link(const std::string& command, const std::vector<RecordedStep>& steps) {
  std::istringstream words(command);
  std::string word, name, label, settings;
  while (words >> word) {
    if (word == "--step") words >> label;
    if (word != "--set" || !(words >> word)) continue;
    settings += "&" + word;
    if (name.empty()) name = word.substr(0, word.find('='));
  }
  const auto reads_it = [&](const RecordedStep& step) {
    return std::find(step.reads.begin(), step.reads.end(), name) != step.reads.end();
  };
  const auto first = std::find_if(steps.begin(), steps.end(), reads_it);
  if (label.empty() && first != steps.end()) label = first->step->label;
  return settings.empty() || label.empty() ? "" : "#step-" + label + settings;
}

std::string try_it(const Try& attempt, const std::vector<RecordedStep>& steps, bool live) {
  const std::string link = live ? settings_link(attempt.command, steps) : "";
  const std::string button =
      link.empty() ? "" : fmt::format("<p><a class=\"try\" href=\"{}\">Try it here</a></p>\n", escaped(link));
  return fmt::format("<p>{}</p>\n{}<pre>{}</pre>\n", inline_html(attempt.what), button,
                     command_html(attempt.command));
}

std::string closing(const Closing& closing, const std::vector<RecordedStep>& steps, bool live) {
  std::string all;
  if (!closing.now_you_know.empty()) {
    all += "<section class=\"closing\" id=\"now-you-know\">\n<h2>What you now know</h2>\n<ul>\n";
    for (const std::string& known : closing.now_you_know) all += "<li>" + inline_html(known) + "</li>\n";
    all += "</ul>\n</section>\n";
  }
  if (!closing.tries.empty()) {
    all += "<section class=\"closing\" id=\"to-try\">\n<h2>To try</h2>\n";
    for (const Try& attempt : closing.tries) all += try_it(attempt, steps, live);
    all += "</section>\n";
  }
  if (!closing.next.empty())
    all += "<section class=\"closing\" id=\"next\">\n<h2>What comes next</h2>\n" + prose_html(closing.next) +
           "\n</section>\n";
  return all;
}

/// The lessons before and after this one.
std::string neighbours(const std::string& slug) {
  const std::vector<About>& all = contents();
  const auto here = std::find_if(all.begin(), all.end(), [&](const About& lesson) { return lesson.slug == slug; });
  const auto link = [](const About& lesson, const char* rel, const char* words) {
    return fmt::format("<a rel=\"{}\" href=\"{}\"><span>{}</span> {}. {}</a>", rel, page_of(lesson.slug), words,
                       std::stoi(lesson.slug), escaped(lesson.title));
  };
  std::string links;
  if (here != all.end() && here != all.begin()) links += link(*std::prev(here), "prev", "Previous");
  if (here != all.end() && std::next(here) != all.end()) links += link(*std::next(here), "next", "Next");
  return links.empty() ? ""
                       : "<nav class=\"neighbours\" aria-label=\"Neighbouring lessons\">" + links + "</nav>\n";
}

}  // namespace

std::string lesson_title(const std::string& slug) {
  for (const About& lesson : contents())
    if (lesson.slug == slug) return fmt::format("{}. {}", std::stoi(slug), lesson.title);
  return slug;
}

std::string page_of(const std::string& slug) { return slug + ".html"; }

std::string live_head() { return "<link rel=\"stylesheet\" href=\"live/live.css\" />\n"; }

std::string live_scripts(const std::string& slug) {
  std::string all;
  for (const std::string& name : {std::string("worker"), std::string("files"), slug, std::string("settings"),
                                  std::string("hold"), std::string("live")})
    all += fmt::format("<script defer=\"defer\" src=\"live/{}.js\"></script>\n", name);
  return all;
}

std::string lesson_page(const Lesson& lesson, const std::vector<RecordedStep>& steps, const std::string& sections,
                        bool live, bool exercises) {
  const About& about = lesson.about();
  const bool excerpts = exercises && sections.find("/plain_") != std::string::npos;
  std::string content = fmt::format(R"(<article class="lesson">
<header class="lesson">
<p class="number">Lesson {}</p>
<h1>{}</h1>
<p class="summary">{}</p>
<p class="facts">{}</p>
{}{}{}</header>
)",
                                    lesson.number(), escaped(about.title), inline_html(about.summary),
                                    in_words(reading_time(digest(lesson, steps))), live ? "" : static_page(lesson),
                                    goals(about), parameters(lesson));
  content += sections + closing(lesson.closing(), steps, live) + "</article>\n" + neighbours(about.slug);
  return framed({.title = fmt::format("{}. {}", lesson.number(), about.title),
                 .content = content,
                 .summary = about.summary,
                 .picture = about.slug + "/card.png",
                 .beside = steps_beside(steps),
                 .lesson = about.slug,
                 .narrow = about.slug,
                 .head = live ? live_head() : "",
                 .foot = "<script type=\"application/json\" id=\"parameters\">" + parameters_json(lesson, steps) +
                         "</script>\n" + (live ? live_scripts(about.slug) : "") +
                         (excerpts ? "<script defer=\"defer\" src=\"practise/excerpts.js\"></script>\n" : ""),
                 .exercises = exercises});
}

}  // namespace byhand::site
