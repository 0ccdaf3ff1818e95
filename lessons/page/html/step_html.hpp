#pragma once

#include <functional>
#include <string>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// A picture in the page and, where there are files of it, the links to them (HTML, may be empty).
struct Shown {
  std::string markup, links = {};
  bool sideways = false;  // on a narrow page it stays as wide as on others, and scrolls
};

/// How the page shows what is drawn: as written files, or drawn in the page itself.
struct Pictures {
  std::function<Shown(const course::Figure&)> figure;
  std::function<Shown(const course::Sequence&)> film;
};

/// A told step as HTML that is XML too: what the native program writes and what the program in the browser tells
/// again. Scripts may rely on this:
///
///     <section id="step-3a" data-step="3a">       also class="step", or "step deeper"
///       <h2>…</h2>
///       <div data-item="0">…</div> …              one child for each item, or for a run of claims or of measures
///     </section>
///
/// data-item is the index of the (first) item among the step's; every claim and measure carries its own inside.
/// To tell a step again, parse the new section and replace the children that differ. Among the children are
///
///     <figure data-figure="law_of_drift">         the picture in .picture, whose label is computed
///                                                 from it; readers of screens do not enter .picture, so nothing
///                                                 to press belongs there; data-sideways if a narrow page has
///                                                 it no narrower
///     <figure data-film="growing_circle">         the same; the key frames, until it is played
///     <figure data-hold="bob_in_hand">            the step's scene to hold, last, with data-item="hold": its
///     picture
///                                                 as it begins
///     <form data-question="3.1">                  the first question of step 3; data-kind="number" or "choice".
///                                                 Its .answer (a field and a button, or radio buttons with the
///                                                 value 1, 2, …; all named "typed") is hidden until <html> has
///                                                 the class "live"; .reply is empty
///     <details class="claims">                    with data-false, the number of false claims, in its rows
///                                                 data-verdict="holds", "false" or "not claimed"
///     <dl class="measures">
std::string step_html(const course::RecordedStep& step, const Pictures& pictures);

}  // namespace byhand::site
