#pragma once

#include "lessons/07_space/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::space {

void same_code(const Setting& setting, tutor::Page& page);
void turned_inertia(const Setting& setting, tutor::Page& page);
void conical(const Setting& setting, tutor::Page& page);
void nutation(const Setting& setting, tutor::Page& page);
void left_out(const Setting& setting, tutor::Page& page);
void flips(const Setting& setting, tutor::Page& page);
void two_axes(const Setting& setting, tutor::Page& page);
void orientation(const Setting& setting, tutor::Page& page);
void gyroscope(const Setting& setting, tutor::Page& page);
void let_loose(const Setting& setting, tutor::Page& page);

}  // namespace byhand::space
