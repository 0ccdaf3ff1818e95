#pragma once

#include <map>
#include <string>
#include <vector>

#include "lessons/site/digest.hpp"

namespace byhand::site {

/// The parameters of a lesson (see lesson_page), safe within <script>.
std::string parameters_json(const course::Lesson& lesson, const std::vector<course::RecordedStep>& steps);

/// A lesson's program hands its digest over to the program that writes the site. Throws std::runtime_error for
/// anything but what `to_json` writes.
std::string to_json(const Digest& digest);
Digest digest_from_json(const std::string& json);

/// What the search looks through, as JSON: [page, lesson, [[anchor, title, words], …]], ….
std::string search_index(const std::vector<Digest>& lessons);

/// A script that sets `equations` to the MathML of the article's equations, by number.
std::string equations_script();

/// manifest.json of a site: what made it, and the SHA-256 of each file.
std::string site_manifest(const std::map<std::string, std::string>& files);

}  // namespace byhand::site
