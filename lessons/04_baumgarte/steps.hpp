#pragma once

#include "lessons/04_baumgarte/setting.hpp"

// The steps, each in the file of its name.
namespace byhand::baumgarte {

void drift(const Setting& setting, course::Page& page);
void a_share_of_the_error(const Setting& setting, course::Page& page);
void both_sides_of_two(const Setting& setting, course::Page& page);
void read_literally(const Setting& setting, course::Page& page);
void frame_rate(const Setting& setting, course::Page& page);
void what_it_costs(const Setting& setting, course::Page& page);
void steady_spin(const Setting& setting, course::Page& page);
void the_trap(const Setting& setting, course::Page& page);
void when_it_does_not_work(const Setting& setting, course::Page& page);

/// A bob on the rod that step 2 corrects.
course::Hold in_hand(const Setting& setting);

}  // namespace byhand::baumgarte
