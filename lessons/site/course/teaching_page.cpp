#include <fmt/format.h>

#include <array>

#include "lessons/page/html/markup.hpp"
#include "lessons/site/course/course_pages.hpp"
#include "lessons/site/course/plan.hpp"
#include "lessons/site/frame.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/reading.hpp"

namespace byhand::site {
namespace {

using namespace course;

std::string schedule(const std::vector<Digest>& lessons) {
  std::string rows;
  int core = 0, deeper = 0;
  for (const Digest& lesson : lessons) {
    const Minutes minutes = reading_time(lesson);
    core += minutes.core;
    deeper += minutes.deeper;
    for (const About& about : contents())
      if (about.slug == lesson.slug)
        rows +=
            fmt::format("<tr><th scope=\"row\"><a href=\"{}\">{}</a></th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        page_of(lesson.slug), escaped(lesson_title(lesson.slug)), inline_html(about.before),
                        minutes.core, minutes.deeper);
  }
  return fmt::format(
      "<div class=\"scroll\"><table><thead><tr><th scope=\"col\">lesson</th><th scope=\"col\">before</th>"
      "<th scope=\"col\">minutes</th><th scope=\"col\">deeper</th></tr></thead><tbody>\n{}"
      "<tr><th scope=\"row\">all</th><td></td><td>{}</td><td>{}</td></tr>\n</tbody></table></div>\n"
      "<p>Minutes are estimated from the number of words and questions.</p>\n",
      rows, core, deeper);
}

/// A class of 90 minutes on each lesson.
std::string classes(const std::vector<Digest>& lessons, const std::map<int, std::vector<int>>& exercises) {
  std::string all;
  for (const Digest& lesson : lessons) {
    const auto found = exercises.find(std::stoi(lesson.slug));
    std::string rows;
    for (const PlannedPart& part : plan(lesson, found == exercises.end() ? std::vector<int>{} : found->second))
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", part.minutes,
                          part.step.empty() ? ""
                                            : fmt::format("<a href=\"{}#step-{}\">{}</a>", page_of(lesson.slug),
                                                          part.step, part.step),
                          part.show, part.ask);
    all += fmt::format(
        "<details class=\"class\"><summary>{} minutes on {}</summary>\n<table><thead><tr><th "
        "scope=\"col\">minutes</th>"
        "<th scope=\"col\">step</th><th scope=\"col\">show</th><th scope=\"col\">ask "
        "first</th></tr></thead><tbody>\n{}"
        "</tbody></table></details>\n",
        minutes_of_a_class, escaped(lesson_title(lesson.slug)), rows);
  }
  return all;
}

/// What a teacher takes along, as far as it is there.
std::string downloads(const std::vector<Digest>& lessons, const std::filesystem::path& site) {
  const auto link = [&](const std::string& file, const std::string& words) {
    return std::filesystem::exists(site / file) ? fmt::format("<a href=\"{}\">{}</a>", file, words) : "";
  };
  std::string all, rows;
  for (const auto& [file, words, about] :
       {std::array{"answers.html", "Answers", "the key to all questions, with their hints"},
        {"downloads/predictions_moodle.xml", "Moodle quiz",
         "the predictions of all lessons; wrong answers get "
         "their own reply"},
        {"downloads/predictions_qti.zip", "QTI 2.1 package", "the same for Canvas, ILIAS, OLAT and others"},
        {"downloads/exercises.zip", "Handouts", "the exercises: what each asks for, its frame and its types"},
        {"constraints_by_hand.epub", "E-book", "all lessons, with answers at the end of each chapter"}})
    if (const std::string found = link(file, words); !found.empty())
      all += fmt::format("<li>{}: {}</li>\n", found, about);
  for (const Digest& lesson : lessons)
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>\n",
                        escaped(lesson_title(lesson.slug)), link("slides/" + page_of(lesson.slug), "slides"),
                        link(fmt::format("downloads/{}_figures.zip", lesson.slug), "figures and films"));
  return fmt::format(
      "<section id=\"downloads\">\n<h2>To download</h2>\n<ul class=\"ways\">\n{}</ul>\n"
      "<table><thead><tr><th scope=\"col\">lesson</th><th scope=\"col\">slides</th><th scope=\"col\">figures and "
      "films, SVG and CSV</th></tr></thead><tbody>\n{}</tbody></table>\n"
      "<p>Slides are shown by the browser: arrow keys to go on, S for the speaker's notes. A film is an SVG file "
      "that plays in a browser or on "
      "such a slide.</p>\n</section>\n",
      all, rows);
}

/// The scene of a lesson alone, or an address of that form where it has none.
std::string embedded(const Digest& lesson) {
  return fmt::format("<code>{}?only={}</code>", page_of(lesson.slug), "bob_in_hand");
}

std::string example(const Digest& lesson) {
  const std::string address = fmt::format("{}#step-{}", page_of(lesson.slug), lesson.steps.front().label);
  return fmt::format("<a href=\"{0}\">{0}</a>", address);
}

}  // namespace

std::string teaching_page(const std::vector<Digest>& lessons, const std::map<int, std::vector<int>>& exercises,
                          const std::filesystem::path& site) {
  std::string content =
      "<h1>Use this in your course</h1>\n"
      "<p class=\"summary\">The pages are a folder of files. Nothing in them needs a server or a network.</p>\n" +
      downloads(lessons, site) + "<section id=\"plan\">\n<h2>Plan</h2>\n" + schedule(lessons) +
      classes(lessons, exercises) +
      R"(<p>Lessons 1 to 4 are the article's core; 5 to 7 build on it and can be chosen from; 8 to 10 suit a project. Deeper
steps can be left out: no core step needs one.</p>
</section>
<section id="hosting">
<h2>Hosting</h2>
<p>Copy the folder to any web server, a learning platform's file area or a USB stick; its name and place do not matter. Open
<code>index.html</code>. The whole course is also an e-book: <a href="constraints_by_hand.epub">constraints_by_hand.epub</a>.
No page loads anything from another host, sets a cookie or stores what a student does.</p>
<p>A server with a strict content security policy may use
<code>default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; img-src 'self' data:</code>.</p>
</section>
<section id="linking">
<h2>Linking</h2>
<p>Each step has an address, such as )" +
      example(lessons.front()) + R"(; so has each <a href="equations.html#equation-17">equation</a>. A
link can carry settings too: <code>04_baumgarte.html#step-3&amp;beta=1.9</code> opens that step with β = 1.9, and with
<code>&amp;versus=beta:0.2</code> after it, another setting stands beside.</p>
</section>
<section id="embedding">
<h2>Embedding</h2>
<p>A figure, a film or a scene stands alone in a frame of your page with <code>?only=</code> and its name, such as )" +
      embedded(lessons.front()) + R"(. The
frame is told its height:</p>
<pre><code>&lt;iframe src="04_baumgarte.html?only=rod_in_hand" style="width: 100%; border: 0"&gt;&lt;/iframe&gt;
&lt;script&gt;
  addEventListener('message', ({ data, source }) =&gt; {
    for (const frame of document.querySelectorAll('iframe'))
      if (data.byhand &amp;&amp; frame.contentWindow === source) frame.height = data.height;
  });
&lt;/script&gt;</code></pre>
</section>
<section id="exercises">
<h2>Exercises</h2>
<p>Ten exercises ask for one function of a step each, the eleventh for a whole program of some 45 lines, the last for a constraint that
no lesson derives. All are judged with probes; frequent wrong derivations get their own reply.
<code>./lessons/run practise</code> lists them. For a course:</p>
<pre><code>./lessons/run practise --export gradescope --to FOLDER
./lessons/run practise --export classroom50 --to FOLDER
./lessons/run practise --export prairielearn --to FOLDER
./lessons/run practise --export junit --to FOLDER</code></pre>
<p>write a judge without solutions, with probes of your own <code class="whole">--seed</code>. What learners get with each
exercise and the predictions as a quiz are ready <a href="#downloads">to download</a>.</p>
</section>
<section id="rebuilding">
<h2>Rebuilding</h2>
<pre><code>./lessons/run site</code></pre>
<p>writes the site anew from the checkout. Apart from charts of measured running times, the same commit gives the same bytes;
<code>manifest.json</code> lists the commit and the SHA-256 of each file. The slides stand on reveal.js, which npm fetches once;
without npm they are left out, as with <code class="whole">--without-slides</code>, and
<code class="whole">--without-answers</code> leaves out the key.</p>
</section>
<section id="licence">
<h2>Licence and citation</h2>
<p>Text, code and figures: MIT licence. You may change and redistribute them; keep the notice. The fonts are under the licences beside
them, in <code>assets/fonts</code>. To cite the course: see <code>CITATION.cff</code> in the repository. The equations are those of
R. Gaul, <cite>Modelling and Solving Physical Constraints</cite>, 2013.</p>
</section>
)";
  return framed({.title = "Use this in your course",
                 .content = content,
                 .here = "teaching.html",
                 .exercises = has_exercises(site)});
}

}  // namespace byhand::site
