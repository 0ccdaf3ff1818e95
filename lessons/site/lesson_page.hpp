#pragma once

#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// The page of a lesson: <html data-lesson="04_baumgarte">, and in <main> the steps (see step_html). Scripts find
/// the parameters as JSON in <script type="application/json" id="parameters">, with those that each step reads:
///
///     {"parameters": [{"name": "h", "unit": "s", "meaning": "time step", "low": 0.001, "high": 0.05, "whole":
///     false,
///                      "choices": [], "initial": 0.016666666666666666, "typed": "1/60"}, …],
///      "steps": {"1": ["h", …], …}}
///
/// `sections` are those of the steps (see step_html). `live`: with the scripts in live/ (see lessons/site/live).
/// `exercises`: on a site that has them, where readers may change a lesson's plain algorithm.
/// `typed` is the initial value as a reader types it; of a choice, low, high and initial mean nothing but the
/// index.
std::string lesson_page(const course::Lesson& lesson, const std::vector<course::RecordedStep>& steps,
                        const std::string& sections, bool live, bool exercises);

/// In <head> and at the end of <body> of a page with the lesson's program: style sheet; program with what it
/// reads, its worker, and what makes the page live (see lessons/site/live).
std::string live_head();
std::string live_scripts(const std::string& slug);

std::string page_of(const std::string& slug);       // "04_baumgarte.html"
std::string lesson_title(const std::string& slug);  // "4. Baumgarte", of a lesson in the contents

}  // namespace byhand::site
