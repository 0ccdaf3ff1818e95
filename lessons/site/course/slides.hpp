#pragma once

#include <filesystem>
#include <string>

#include "lessons/site/digest.hpp"

namespace byhand::site {

/// A lesson as slides for reveal.js, which lies beside them: a title for each step, then one formula, picture,
/// question or listing a slide, with the text around it as the speaker's notes. Made of the lesson's page in the
/// folder of the site; lies in slides/ there.
std::string slides(const std::filesystem::path& site, const Digest& lesson);

}  // namespace byhand::site
