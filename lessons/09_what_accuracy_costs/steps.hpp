#pragma once

#include "lessons/09_what_accuracy_costs/setting.hpp"

// The steps of this lesson, in order; each is a file of that name.
namespace byhand::accuracy {

void the_methods(course::Page& page);
void other_methods(course::Page& page);
void order_is_the_slope(course::Page& page);
void stable_is_not_accurate(course::Page& page);
void substeps_or_sweeps(course::Page& page);
void what_the_step_hides(course::Page& page);
void accuracy_as_the_input(course::Page& page);
void contacts(course::Page& page);
void one_page(course::Page& page);
void recommendation(course::Page& page, const Setting& setting);

/// Names of what the appendix can draw; the first is nothing.
std::vector<std::string> appendix_scenes();
void appendix(course::Page& page, const std::string& scene);
void stability(course::Page& page);
void model_cost(course::Page& page);

// Chapters of the appendix that are no charts of a scene.
/// What each method costs to a drift of a millimetre, by the links of a chain and by its mass ratio.
void cost_to_a_millimetre(course::Page& page);
void thousand_periods(course::Page& page);

}  // namespace byhand::accuracy
