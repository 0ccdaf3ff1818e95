#pragma once

#include "lessons/02_single_constraint/setting.hpp"

// The lesson's steps, a file each.
namespace byhand::single_constraint {

void gravity_first(const Setting& setting, tutor::Page& page);
void effective_mass(const Setting& setting, tutor::Page& page);
void lambda(const Setting& setting, tutor::Page& page);
void onto_the_tangent(const Setting& setting, tutor::Page& page);
void tension(const Setting& setting, tutor::Page& page);
void off_the_circle(const Setting& setting, tutor::Page& page);
void ten_seconds(const Setting& setting, tutor::Page& page);

void least_change(const Setting& setting, tutor::Page& page);
void gravity_after(const Setting& setting, tutor::Page& page);
void why_velocity(const Setting& setting, tutor::Page& page);
void rigid_rod(const Setting& setting, tutor::Page& page);

/// The bob that step 1 speaks of.
tutor::Hold in_hand(const Setting& setting);

}  // namespace byhand::single_constraint
