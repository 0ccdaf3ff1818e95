#include "lessons/practise/page/practise_page.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "lessons/page/html/escaped.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/practise/handout.hpp"
#include "lessons/site/frame.hpp"

namespace byhand::practise {
namespace {

using site::escaped;

/// Lines that begin at the margin are prose, the others a drawing.
std::string drawn_html(const std::string& text) {
  std::istringstream lines(text);
  std::string all, block, line;
  bool drawing = false;
  const auto end = [&] {
    if (block.find_first_not_of(" \n") != std::string::npos)
      all += drawing ? "<pre>" + escaped(block) + "</pre>\n" : "<p>" + site::inline_html(block) + "</p>\n";
    block.clear();
  };
  while (std::getline(lines, line)) {
    const bool draws = line.starts_with(' ');
    if (line.empty() ? !drawing : draws != drawing) end();
    if (!line.empty()) drawing = draws;
    block += line + "\n";
  }
  end();
  return all;
}

std::string hints_html(const std::vector<std::string>& hints) {
  std::string all;
  for (std::size_t i = 0; i < hints.size(); ++i)
    all += fmt::format("<details class=\"hint\"><summary>Hint {} of {}</summary><p>{}</p></details>\n", i + 1,
                       hints.size(), site::inline_html(hints[i]));
  return all;
}

/// What a learner's file may use: the exercise's own types and the signatures.
std::string signature_of(const Exercise& exercise) {
  const std::string text = contents_of(exercise.folder() / "signature.hpp");
  const auto begin = text.find("#include \"practise.hpp\"\n") + 25, end = text.find("#define FUNCTIONS");
  return text.substr(begin, end - begin - 1);
}

std::string section(const Exercise& exercise) {
  const Task about = task(exercise);
  const std::string stub = contents_of(exercise.folder() / "stub.cpp");
  return fmt::format(R"(<section class="exercise" id="{0}">
<h2>{1}. {2}</h2>
<p class="facts">Lesson {3}, equations {4}</p>
{5}<pre class="signature">{6}</pre>
<details><summary>What practise.hpp declares, and the equations</summary>
<pre>{7}</pre>
<pre>{8}</pre>
</details>
{9}<details class="stub"><summary>The file to begin with</summary><pre><code>{10}</code></pre></details>
</section>
)",
                     exercise.name, exercise.number(), escaped(about.title), escaped(about.lesson),
                     site::inline_html(about.equations), drawn_html(about.statement),
                     escaped(signature_of(exercise)), escaped(given_types()), escaped(equations_of(exercise)),
                     hints_html(about.hints), escaped(stub));
}

}  // namespace

std::string practise_page() {
  std::string list, sections;
  for (const Exercise& exercise : exercises()) {
    list += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", exercise.name, escaped(task(exercise).title));
    sections += section(exercise);
  }
  return site::framed({.title = "Write it yourself",
                       .content = fmt::format(R"(<div class="practise">
<link rel="stylesheet" href="practise/practise.css" />
<h1>Write it yourself</h1>
<p class="summary">Each exercise is a function or two of the course, in C++; the eleventh is a whole program. The page compiles your code and judges it on 24 random
probes; if you made a frequent mistake, it says which.</p>
<noscript><p>To compile and judge, the page needs JavaScript; <code>./lessons/run practise</code> is the same at a terminal.</p></noscript>
<nav aria-label="Exercises"><ol class="exercises">
{0}</ol></nav>
{1}<div class="desk" id="desk" hidden="hidden">
<p id="place"><label for="code">Your file</label> <span class="keys">Tab leaves it; Ctrl+Enter checks</span></p>
<div class="editor"><pre id="numbers" aria-hidden="true"></pre><textarea id="code" spellcheck="false" autocapitalize="off" autocomplete="off" wrap="off"></textarea></div>
<p class="tools"><button type="button" id="check">Check</button> <button type="button" id="save">Save</button> <button type="button" id="open">Open</button> <button type="button" id="reset">Begin again</button>
<input type="file" id="file" accept=".cpp,.txt,text/plain" hidden="hidden" /></p>
<p id="state" role="status"></p>
<div id="ask" hidden="hidden"><p>Checking loads a compiler of 23 MB, once, and takes some 400 MB of this device's memory.</p>
<p><button type="button" id="load">Load it</button> <button type="button" id="refuse">Not now</button></p></div>
<div id="verdict" role="status" aria-live="polite"><p id="sentence"></p></div>
<pre id="details" hidden="hidden"></pre>
<figure id="film" hidden="hidden"><div class="picture"></div>
<figcaption><button type="button" id="play">Play</button> <label>Time <input type="range" id="time" min="0" max="1" step="1" value="0" /></label></figcaption></figure>
<section id="solution" hidden="hidden"><h3>A solution and its derivation</h3><pre><code></code></pre><p></p></section>
<details id="unmask"><summary>Unmask a wrong code</summary>
<p>This code is wrong, and it passes the test below. Choose numbers on which it is wrong; those that you leave out stay.</p>
<pre id="masked"></pre><p>The test: <code id="test"></code></p>
<form id="guess"><label for="numbers_given">Your numbers, such as NAME=1 or NAME=1,2</label> <input id="numbers_given" spellcheck="false" autocapitalize="off" autocomplete="off" /> <button>Try</button></form>
<pre id="unmasked" role="status"></pre></details>
</div>
<footer class="about"><p>The first check loads clang 22 and its headers, 23 MB, once; nothing is sent anywhere. Drafts stay in this browser.
<a href="practise/LICENCES.txt">Licences</a> of the compiler and its libraries.</p>
<p>The judge in this page holds compiled solutions, so for marks let a server judge: <code>./lessons/run practise --export</code>.</p></footer>
</div>
)",
                                              list, sections),
                       .summary = "Exercises of the course in C++, compiled and judged in the page.",
                       .foot = R"(<script defer="defer" src="practise/page.js"></script>
)",
                       .here = "practise.html",
                       .exercises = true});
}

}  // namespace byhand::practise
