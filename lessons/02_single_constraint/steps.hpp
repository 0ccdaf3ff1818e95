#pragma once

#include "lessons/02_single_constraint/setting.hpp"

// The lesson's steps, a file each.
namespace byhand::single_constraint {

void gravity_first(const Setting& setting, course::Page& page);
void effective_mass(const Setting& setting, course::Page& page);
void lambda(const Setting& setting, course::Page& page);
void onto_the_tangent(const Setting& setting, course::Page& page);
void tension(const Setting& setting, course::Page& page);
void off_the_circle(const Setting& setting, course::Page& page);
void ten_seconds(const Setting& setting, course::Page& page);

void least_change(const Setting& setting, course::Page& page);
void gravity_after(const Setting& setting, course::Page& page);
void why_velocity(const Setting& setting, course::Page& page);
void rigid_rod(const Setting& setting, course::Page& page);

/// What the rest of the field calls what this lesson did.
void say_where_else(course::Page& page);

/// The bob that step 1 speaks of.
course::Hold in_hand(const Setting& setting);

}  // namespace byhand::single_constraint
