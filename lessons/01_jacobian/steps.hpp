#pragma once

#include "lessons/tutor/lesson.hpp"

// The steps of the lesson, one function each; the file of that name holds it.
namespace byhand::lesson01 {

/// What the reader may turn.
struct Settings {
  tutor::Parameter<double> length, stretch, speed, spin, mass, h, beta;
  tutor::Parameter<int> links;
};

void what_c_says(tutor::Page& page, const Settings& set);
void one_row(tutor::Page& page, const Settings& set);
void differentiate(tutor::Page& page, const Settings& set);
void triple_product(tutor::Page& page, const Settings& set);
void inspection(tutor::Page& page, const Settings& set);
void slopes(tutor::Page& page, const Settings& set);
void contact(tutor::Page& page, const Settings& set);

void dual_numbers(tutor::Page& page, const Settings& set);
void friction(tutor::Page& page, const Settings& set);
void separation(tutor::Page& page, const Settings& set);
void two_forms(tutor::Page& page, const Settings& set);
void linkage(tutor::Page& page, const Settings& set);
void dual_map(tutor::Page& page, const Settings& set);

/// The film of the step by inspection.
void four_parts(tutor::Page& page, const Settings& set);

}  // namespace byhand::lesson01
