#include "lessons/site/course/desk_page.hpp"

#include <fmt/format.h>

#include "lessons/page/html/escaped.hpp"
#include "lessons/site/frame.hpp"

namespace byhand::site {
namespace {

/// As the value of an attribute, which keeps its line ends.
std::string attribute(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : "&#10;") + escaped(line);
  return all;
}

}  // namespace

std::string desk_page(const std::vector<desk::Task>& tasks, bool exercises) {
  std::string items;
  int number = 0;
  for (const desk::Task& task : tasks) {
    std::vector<std::string> lines = task.before;
    lines.insert(lines.end(), task.start.begin(), task.start.end());
    ++number;
    items += fmt::format(
        "<li><button type=\"button\" id=\"task-{}\" data-start=\"{}\"><strong>{}</strong> {}<br "
        "/>{}</button></li>\n",
        number, attribute(lines), number, escaped(task.title), escaped(task.text));
  }
  return framed({.title = "Derivation desk",
                 .content = fmt::format(R"(<div class="desk">
<link rel="stylesheet" href="live/desk.css" />
<h1>The derivation desk</h1>
<p class="summary">Type a constraint C and then your own lines: dC, and each after an = of its own, down to J. Every line is held
against the one before, by value, and a wrong one is told why.</p>
<p><label for="sheet">Your lines: <code>.</code> and <code>x</code> multiply vectors, <code>|d|</code> is a length, <code>w2</code> is ω2; LaTeX may be
pasted.</label></p>
<textarea id="sheet" spellcheck="false" autocapitalize="off" autocomplete="off" rows="8">in the plane
C = |p2 - p1|^2/2 - L^2/2
dC = (p2 - p1) . (v2 + w2 x r2 - v1 - w1 x r1)</textarea>
<p id="verdict" role="status" aria-live="polite"></p>
<ol id="said" aria-label="The verdict on each line"></ol>
<section id="report" aria-label="The derived constraint"></section>
<section id="run" aria-label="The derived constraint in a scene" hidden="hidden">
<h2>It runs</h2>
<p id="scenes" role="group" aria-label="Scenes"></p>
<svg id="stage" role="img" aria-labelledby="told"></svg>
<p><button type="button" id="play">Play</button> <label>Time <input type="range" id="time" min="0" max="5" step="any" value="0" /></label> <output id="clock" for="time"></output></p>
<p id="told"></p>
</section>
<noscript><p>The desk runs in the page and needs JavaScript; ./lessons/run desk is the same at a terminal.</p></noscript>
<section id="tasks" hidden="hidden">
<h2>Tasks</h2>
<ol class="tasks">
{}</ol>
</section>
</div>
)",
                                        items),
                 .foot = R"(<script defer="defer" src="live/desk.js"></script>
)",
                 .here = "desk.html",
                 .exercises = exercises});
}

}  // namespace byhand::site
