#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// Writes the picture that stands for a lesson into its folder of the site: card.svg without letters, which would
/// be too small in the list of lessons, and card.png with them, for previews of links. It is the lesson's first
/// drawing, or else the middle of its first film, or else its first chart.
void write_card(const std::vector<course::RecordedStep>& steps, const std::filesystem::path& folder);

}  // namespace byhand::site
