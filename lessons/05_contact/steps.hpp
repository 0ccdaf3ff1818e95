#pragma once

#include "lessons/05_contact/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::contact {

void push_only(const Setting& setting, course::Page& page);
void deep_contact(const Setting& setting, course::Page& page);
void friction_row(const Setting& setting, course::Page& page);
void sticks_or_slides(const Setting& setting, course::Page& page);
void bounce(const Setting& setting, course::Page& page);
void cradle(const Setting& setting, course::Page& page);
void stack_of_boxes(const Setting& setting, course::Page& page);
void wall_of_boxes(const Setting& setting, course::Page& page);
void heavy_on_light(const Setting& setting, course::Page& page);
void no_answer(const Setting& setting, course::Page& page);
void on_a_lift(const Setting& setting, course::Page& page);

/// Boxes on the floor, with the friction of step 3.
course::Hold in_hand(const Setting& setting);

}  // namespace byhand::contact
