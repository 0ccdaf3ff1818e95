#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/site/digest.hpp"

namespace byhand::site {

/// The course as EPUB 3: the lessons, the equations and the laws, made of the pages that stand in the folder of
/// the site.
std::string book(const std::filesystem::path& site, const std::vector<Digest>& lessons);

}  // namespace byhand::site
