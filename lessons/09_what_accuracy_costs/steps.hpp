#pragma once

#include "lessons/09_what_accuracy_costs/setting.hpp"
#include "lessons/tutor/page.hpp"

// The steps of this lesson, in order; each is a file of that name.
namespace byhand::accuracy {

void the_methods(tutor::Page& page);
void order_is_the_slope(tutor::Page& page);
void stable_is_not_accurate(tutor::Page& page);
void substeps_or_sweeps(tutor::Page& page);
void what_the_step_hides(tutor::Page& page);
void contacts(tutor::Page& page);
void one_page(tutor::Page& page);
void chooser(tutor::Page& page, const Setting& setting);

void five_errors(tutor::Page& page);
void linkages(tutor::Page& page);
void in_space(tutor::Page& page);
void chains(tutor::Page& page);
void incline(tutor::Page& page);
/// Names of what the appendix can draw; the first is nothing.
std::vector<std::string> appendix_scenes();
void appendix(tutor::Page& page, const std::string& scene);
/// What each method costs to a drift of a millimetre, by the links of a chain and by its mass ratio; the figures
/// are called name_by_length and name_by_mass.
void cost_to_a_millimetre(tutor::Page& page, const std::vector<double>& lengths, const std::vector<double>& ratios,
                          const std::string& name);
void thousand_periods(tutor::Page& page);
void stability(tutor::Page& page);
void model_cost(tutor::Page& page);
void equations(tutor::Page& page);

}  // namespace byhand::accuracy
