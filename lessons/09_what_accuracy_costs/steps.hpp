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

// With `appendix` also the charts of all other errors.
void five_errors(tutor::Page& page, bool appendix);
void linkages(tutor::Page& page, bool appendix);
void in_space(tutor::Page& page, bool appendix);
void chains(tutor::Page& page, bool appendix);
void incline(tutor::Page& page, bool appendix);
void thousand_periods(tutor::Page& page);
void model_cost(tutor::Page& page);
void equations(tutor::Page& page);

}  // namespace byhand::accuracy
