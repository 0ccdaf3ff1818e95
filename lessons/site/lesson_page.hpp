#pragma once

#include <string>
#include <vector>

#include "lessons/site/step_html.hpp"

namespace byhand::site {

/// The page of a lesson: <article data-lesson="04_baumgarte"> holds the steps (see step_html). Scripts find the
/// lesson's parameters as JSON in <script type="application/json" id="parameters">:
///
///     [{"name": "beta", "unit": "1", "meaning": "…", "low": 0.01, "high": 3, "whole": false, "choices": [],
///       "initial": "0.5", "value": "0.5", "step": ""}, …]
///
/// with the numbers as a reader types them; `step` is the label of the only step that depends on it, or empty.
std::string lesson_page(const tutor::Lesson& lesson, const std::vector<tutor::RecordedStep>& steps,
                        const Pictures& pictures);

std::string page_of(const std::string& slug);       // "04_baumgarte.html"
std::string lesson_title(const std::string& slug);  // "4. Baumgarte", of a lesson in the contents

}  // namespace byhand::site
