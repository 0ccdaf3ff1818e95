#pragma once

#include "lessons/08_where_methods_fail/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::failures {

void too_few_iterations(const Setting& setting, course::Page& page);
void overshoots(const Setting& setting, course::Page& page);
void too_large_a_step(const Setting& setting, course::Page& page);
void too_soft(const Setting& setting, course::Page& page);
void wrong_rows(const Setting& setting, course::Page& page);
void which_knob(const Setting& setting, course::Page& page);
void regimes(const Setting& setting, course::Page& page);
void all_laws(const Setting& setting, course::Page& page);

void heavy_on_light(const Setting& setting, course::Page& page);
void many_contacts(const Setting& setting, course::Page& page);
void springs(const Setting& setting, course::Page& page);
void unseen(const Setting& setting, course::Page& page);

course::Hold stack_in_hand(const Setting& setting);
course::Hold chain_in_hand(const Setting& setting);

}  // namespace byhand::failures
