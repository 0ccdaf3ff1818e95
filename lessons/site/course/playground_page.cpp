#include "lessons/site/course/playground_page.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "lessons/site/frame.hpp"

namespace byhand::site {
namespace {

struct Tool {
  std::string_view name, title, how, icon;  // the icon within 24 × 24
};
constexpr std::array<Tool, 9> tools{
    {{"hand", "Drag", "Drag a body and let it go. While the scene rests, it is moved.",
      R"(<path d="M6 12V8a1.5 1.5 0 0 1 3 0V5a1.5 1.5 0 0 1 3 0v-.5a1.5 1.5 0 0 1 3 0V7a1.5 1.5 0 0 1 3 0v7c0 4-2 6-5.5 6S8 18 6.500 15.500L4 12a1.400 1.400 0 0 1 2 0z"/>)"},
     {"box", "Box", "Drag out a box, or tap for one of a metre.", R"(<rect x="4" y="6" width="16" height="12"/>)"},
     {"ball", "Ball", "Drag out a ball from its middle, or tap.",
      R"(<circle cx="12" cy="12" r="8"/><path d="M12 12h8"/>)"},
     {"wall", "Wall", "Drag a wall from end to end. It never moves.",
      R"(<path d="M3 9h18M5 16l4-7M10 16l4-7M15 16l4-7"/>)"},
     {"rod", "Rod", "Drag from one body to another, or to the world: they keep their distance.",
      R"(<path d="M6 18L18 6"/><circle cx="5" cy="19" r="2"/><circle cx="19" cy="5" r="2"/>)"},
     {"spring", "Spring", "Drag from one body to another, or to the world.",
      R"(<path d="M3 12h3l1.500-4 3 8 3-8 3 8 1.500-4h3"/>)"},
     {"pin", "Pin", "Tap where two bodies overlap, or on one to pin it to the world.",
      R"(<circle cx="12" cy="12" r="3"/><path d="M12 2v7M12 15v7M2 12h7M15 12h7"/>)"},
     {"motor", "Motor", "Tap a body: it is pinned there and turns at 3 rad/s.",
      R"(<path d="M19 12a7 7 0 1 1-3-5.700M16 2v5h-5"/><circle cx="12" cy="12" r="1.500"/>)"},
     {"erase", "Remove", "Tap a body, a rod, a spring or a pin.", R"(<path d="M5 5l14 14M19 5L5 19"/>)"}}};

std::string tool_buttons() {
  std::string all;
  for (const Tool& tool : tools)
    all += fmt::format(
        "<button type=\"button\" data-tool=\"{}\" data-how=\"{}\" aria-pressed=\"false\"><svg viewBox=\"0 0 24 "
        "24\" "
        "aria-hidden=\"true\">{}</svg>{}</button>\n",
        tool.name, tool.how, tool.icon, tool.title);
  return all;
}

/// A slider with its label and its value.
std::string slider(std::string_view id, std::string_view words, double low, double high, double step) {
  return fmt::format(
      "<div class=\"knob\"><label for=\"{0}\">{1}</label><input type=\"range\" id=\"{0}\" min=\"{2}\" max=\"{3}\" "
      "step=\"{4}\" /><output id=\"{0}-value\" for=\"{0}\"></output></div>\n",
      id, words, low, high, step);
}

std::string chooser_of(std::string_view id, std::string_view words,
                       std::initializer_list<std::pair<const char*, const char*>> options) {
  std::string all =
      fmt::format("<div class=\"knob\"><label for=\"{0}\">{1}</label><select id=\"{0}\">", id, words);
  for (const auto& [value, title] : options) all += fmt::format("<option value=\"{}\">{}</option>", value, title);
  return all + "</select></div>\n";
}

std::string method_knobs() {
  return chooser_of("solver", "solver",
                    {{"by_graph", "by graph"},
                     {"gauss_seidel", "Gauss–Seidel"},
                     {"jacobi", "Jacobi"},
                     {"direct", "directly"},
                     {"conjugate_sweeps", "conjugate sweeps"},
                     {"newton", "Newton"}}) +
         slider("sweeps", "sweeps", 1, 100, 1) +
         "<div class=\"knob\"><label for=\"warm\">warm start</label><input type=\"checkbox\" id=\"warm\" "
         "/></div>\n" +
         chooser_of("cure", "cure of drift",
                    {{"baumgarte", "Baumgarte"},
                     {"none", "none"},
                     {"projection", "projection"},
                     {"split_impulse", "split impulse"},
                     {"soft", "soft constraints"}}) +
         slider("beta", "β", 0, 2, 0.01) + slider("slop", "slop", 0, 0.05, 0.001) +
         slider("frequency", "frequency", 10, 240, 1) + slider("substeps", "substeps", 1, 20, 1) +
         slider("step", "steps a second", 10, 480, 10);
}

constexpr auto opening = R"(<div class="opening" id="missing">
<h1>Playground</h1>
<p class="summary">A scene to build, throw, break and watch: {}</p>
<noscript><p>The playground runs in the page and needs JavaScript; ./lessons/run scene FILE runs a scene at a terminal.</p></noscript>
</div>
)";

constexpr auto stage_and_panel = R"(<div id="playground" hidden="hidden">
<div id="tools" role="group" aria-label="Tools">
{}</div>
<div id="stage" tabindex="0" role="application" aria-label="The scene. Arrow keys move a cross, Enter uses the tool there." aria-describedby="how">
<canvas id="picture" aria-hidden="true"></canvas>
<div id="part" aria-hidden="true" hidden="hidden"></div>
<div id="head"><p id="title"></p><p id="how"></p></div>
<p id="words" hidden="hidden"></p>
</div>
<div id="clock" role="group" aria-label="Time">
<button type="button" id="play" aria-label="Play">▶</button>
<button type="button" id="once">One step</button>
<button type="button" id="slow" aria-pressed="false">Slow ×100</button>
<button type="button" id="again">Restart</button>
<output id="time" aria-label="Time in the scene"></output>
<span class="space"></span>
<button type="button" id="undo" disabled="disabled">Undo</button>
<button type="button" id="redo" disabled="disabled">Redo</button>
<button type="button" id="farther" aria-label="Zoom out">−</button>
<button type="button" id="closer" aria-label="Zoom in">+</button>
<button type="button" id="all" aria-label="Show all">⤢</button>
<p id="said" role="status" aria-live="polite"></p>
</div>
<div id="panel">
<section aria-labelledby="scene-head">
<h2 id="scene-head">Scene</h2>
<label for="starts">Begin with</label>
<select id="starts"></select>
<p class="row"><button type="button" id="empty">Empty</button><button type="button" id="load">Open…</button><button type="button" id="save">Save</button><button type="button" id="link">Link</button><button type="button" id="shoot">Picture</button><button type="button" id="keep">Begin here</button></p>
<input type="file" id="chosen" accept=".json,application/json" hidden="hidden" />
<input type="text" id="address" aria-label="Link to this scene" readonly="readonly" hidden="hidden" />
</section>
<section id="selected" aria-labelledby="selected-name" hidden="hidden">
<h2 id="selected-name">Selected</h2>
<div class="knob"><label for="mass">mass (kg)</label><input type="number" id="mass" min="0.001" step="any" /></div>
<div class="knob"><label for="friction">friction μ</label><input type="number" id="friction" min="0" step="0.1" /></div>
<div class="knob"><label for="restitution">bounce e</label><input type="number" id="restitution" min="0" max="1" step="0.1" /></div>
<div class="knob"><label for="fixed">fixed</label><input type="checkbox" id="fixed" /></div>
<p class="row"><button type="button" id="turn">Turn 15°</button><button type="button" id="remove">Remove</button></p>
</section>
<section aria-labelledby="lines-head">
<h2 id="lines-head">The last ten seconds</h2>
<div class="line"><span>energy</span><output id="energy-value"></output><canvas id="energy" aria-hidden="true"></canvas></div>
<div class="line"><span>largest gap or overlap</span><output id="gap-value"></output><canvas id="gap" aria-hidden="true"></canvas></div>
<p id="speed"></p>
</section>
<section aria-labelledby="doctor-head">
<h2 id="doctor-head">The doctor</h2>
<p class="aside">It speaks <span id="judged">of the scene as it begins</span>. Pause, and it judges that moment.</p>
<p id="verdict">is looking at the scene</p>
<ol id="diagnosis" aria-busy="true"></ol>
</section>
<section aria-labelledby="method-head">
<h2 id="method-head">Method</h2>
{}<p class="aside">The playground steps by velocities. XPBD, AVBD and RATTLE run the same file at a terminal: ./lessons/run scene FILE --method xpbd.</p>
</section>
<details id="keys"><summary>Keys</summary>
<p>In the scene: <kbd>arrow keys</kbd> move a cross, with Shift finely; <kbd>Enter</kbd> begins and ends what the tool does there; <kbd>Escape</kbd> leaves it. <kbd>Space</kbd> plays and pauses, <kbd>.</kbd> is one step, <kbd>Delete</kbd> removes what is selected, <kbd>+</kbd> and <kbd>−</kbd> zoom, <kbd>Ctrl Z</kbd> undoes. A wheel or two fingers zoom; drag the empty scene to move it. In space that turns the view, as <kbd>A</kbd>, <kbd>D</kbd>, <kbd>W</kbd> and <kbd>S</kbd> do, and with Shift it moves it.</p>
</details>
</div>
</div>
)";

}  // namespace

std::string playground_page(bool runs, bool exercises) {
  Frame page{.title = "Playground",
             .content = {},
             .summary = "Build a scene, throw it, break it, and see in the page which law it breaks.",
             .here = "playground.html",
             .exercises = exercises};
  page.content = fmt::format(
      opening, runs ? "it is being loaded." : "this site was written without the compiler that it needs.");
  if (runs) {
    page.content += fmt::format(stage_and_panel, tool_buttons(), method_knobs());
    page.head = "<link rel=\"stylesheet\" href=\"live/playground.css\" />\n";
    page.foot = "<script defer=\"defer\" src=\"live/playground.js\"></script>\n";
  }
  return framed(page);
}

}  // namespace byhand::site
