#pragma once

#include <string>
#include <vector>

#include "lessons/page/about.hpp"
#include "lessons/site/digest.hpp"

namespace byhand::site {

/// The pages of the course that belong to no single lesson.
std::string contents_page(const std::vector<Digest>& lessons, bool desk = false);
/// The article's equations, each with the place where the course displays it first.
std::string equations_page();
/// Every law that a lesson derives, with its place.
std::string laws_page(const std::vector<Digest>& lessons);
/// For those who teach with the course.
std::string teaching_page(const std::vector<Digest>& lessons);

}  // namespace byhand::site
