#pragma once

#include "lessons/10_beside_the_engines/setting.hpp"

// The steps of this lesson, in order; each is a file of that name.
namespace byhand::beside {

void the_engines(const Setting& setting, course::Page& page);
void pendulums(const Setting& setting, course::Page& page);
void chains(const Setting& setting, course::Page& page);
void stacks(const Setting& setting, course::Page& page);
void block_on_a_slope(const Setting& setting, course::Page& page);
void wall_of_boxes(const Setting& setting, course::Page& page);

void chain_in_space(const Setting& setting, course::Page& page);
void stacks_in_space(const Setting& setting, course::Page& page);
void wall_in_space(const Setting& setting, course::Page& page);

void in_webassembly(const Setting& setting, course::Page& page);
// Its parts.
void chain_in_webassembly(const Setting& setting, course::Page& page);
void wall_in_webassembly(const Setting& setting, course::Page& page);

}  // namespace byhand::beside
