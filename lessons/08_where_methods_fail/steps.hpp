#pragma once

#include "lessons/08_where_methods_fail/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::failures {

void too_few_iterations(const Setting& setting, tutor::Page& page);
void overshoots(const Setting& setting, tutor::Page& page);
void too_large_a_step(const Setting& setting, tutor::Page& page);
void too_soft(const Setting& setting, tutor::Page& page);
void wrong_rows(const Setting& setting, tutor::Page& page);
void which_knob(const Setting& setting, tutor::Page& page);
void all_laws(const Setting& setting, tutor::Page& page);

void heavy_on_light(const Setting& setting, tutor::Page& page);
void many_contacts(const Setting& setting, tutor::Page& page);
void springs(const Setting& setting, tutor::Page& page);
void unseen(const Setting& setting, tutor::Page& page);

}  // namespace byhand::failures
