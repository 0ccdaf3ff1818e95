#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/site/digest.hpp"

namespace byhand::site {

/// A page with the answer to every question of the lessons, which a site for students can do without.
std::string answer_key(const std::filesystem::path& site, const std::vector<Digest>& lessons);

/// The figures and films of a lesson as a ZIP archive: SVG, and CSV where there are data. Its films stand in the
/// folder `films` beside its figures, or show their first picture.
std::string figures_of(const std::filesystem::path& site, const Digest& lesson);

}  // namespace byhand::site
