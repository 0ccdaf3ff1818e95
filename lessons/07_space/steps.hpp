#pragma once

#include "lessons/07_space/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::space {

void same_code(const Setting& setting, course::Page& page);
void turned_inertia(const Setting& setting, course::Page& page);
void conical(const Setting& setting, course::Page& page);
void nutation(const Setting& setting, course::Page& page);
void left_out(const Setting& setting, course::Page& page);
void flips(const Setting& setting, course::Page& page);
void two_axes(const Setting& setting, course::Page& page);
/// Part of `orientation`.
void joints_in_space(const Setting& setting, course::Page& page);
void orientation(const Setting& setting, course::Page& page);
void swing_and_twist(const Setting& setting, Page& page);
void gyroscope(const Setting& setting, course::Page& page);
void let_loose(const Setting& setting, course::Page& page);
void turntable(const Setting& setting, course::Page& page);

course::Hold book_in_hand(const Setting& setting);
course::Hold gyroscope_in_hand(const Setting& setting);

}  // namespace byhand::space
