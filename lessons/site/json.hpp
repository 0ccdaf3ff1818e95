#pragma once

#include <string>

#include "lessons/tutor/lesson.hpp"

namespace byhand::site {

/// The parameters of a lesson (see lesson_page), safe within <script>.
std::string parameters_json(const tutor::Lesson& lesson);

}  // namespace byhand::site
