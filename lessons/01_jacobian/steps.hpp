#pragma once

#include "lessons/pictures/prelude.hpp"

// The steps of the lesson, one function each; the file of that name holds it.
namespace byhand::lesson01 {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// What the reader may turn.
struct Settings {
  course::Parameter<double> length, stretch, speed, spin, h, beta;
  double mass = 3;  // of a bob or link [kg]
  int links = 10;   // of the chain
};

void what_c_says(course::Page& page, const Settings& set);
void one_row(course::Page& page, const Settings& set);
void differentiate(course::Page& page, const Settings& set);
void triple_product(course::Page& page, const Settings& set);
void inspection(course::Page& page, const Settings& set);
void slopes(course::Page& page, const Settings& set);
void contact(course::Page& page, const Settings& set);

void dual_numbers(course::Page& page, const Settings& set);
void friction(course::Page& page, const Settings& set);
void separation(course::Page& page, const Settings& set);
void two_forms(course::Page& page, const Settings& set);
void linkage(course::Page& page, const Settings& set);
void dual_map(course::Page& page, const Settings& set);

/// The scene of the first step: a bob on a rod in the reader's hand, which no constraint holds.
course::Hold in_hand(const Settings& set);

/// The film of the step by inspection.
void four_parts(course::Page& page, const Settings& set);

}  // namespace byhand::lesson01
