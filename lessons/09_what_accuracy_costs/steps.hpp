#pragma once

#include "lessons/09_what_accuracy_costs/setting.hpp"

// The steps of this lesson, in order; each is a file of that name.
namespace byhand::accuracy {

void the_methods(course::Page& page);
void order_is_the_slope(course::Page& page);
void stable_is_not_accurate(course::Page& page);
void substeps_or_sweeps(course::Page& page);
void what_the_step_hides(course::Page& page);
void contacts(course::Page& page);
void one_page(course::Page& page);
void recommendation(course::Page& page, const Setting& setting);

void five_errors(course::Page& page);
void linkages(course::Page& page);
void in_space(course::Page& page);
void chains(course::Page& page);
void incline(course::Page& page);
/// Names of what the appendix can draw; the first is nothing.
std::vector<std::string> appendix_scenes();
void appendix(course::Page& page, const std::string& scene);
/// What each method costs to a drift of a millimetre, by the links of a chain and by its mass ratio; the figures
/// are called name_by_length and name_by_mass.
void cost_to_a_millimetre(course::Page& page, const std::vector<double>& lengths,
                          const std::vector<double>& ratios, const std::string& name);
void thousand_periods(course::Page& page);
void stability(course::Page& page);
void model_cost(course::Page& page);
void equations(course::Page& page);

}  // namespace byhand::accuracy
