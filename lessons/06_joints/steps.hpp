#pragma once

#include "lessons/06_joints/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::joints {

void rows_to_joints(const Setting& setting, course::Page& page);
void block_or_row(const Setting& setting, course::Page& page);
void four_bar_linkage(const Setting& setting, course::Page& page);
void flat(const Setting& setting, course::Page& page);
void bounds_on_turns(const Setting& setting, course::Page& page);
void driven_crank(const Setting& setting, course::Page& page);
void conflicting_rods(const Setting& setting, course::Page& page);
void ropes(const Setting& setting, course::Page& page);
void soft_rows(const Setting& setting, course::Page& page);
void hanging_bridge(const Setting& setting, course::Page& page);
void ragdoll_on_a_stair(const Setting& setting, course::Page& page);

/// The four-bar linkage of step 3.
course::Hold in_hand(const Setting& setting);

}  // namespace byhand::joints
