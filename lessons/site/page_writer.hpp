#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// The steps of a told lesson, each as HTML (see step_html), and what a narrow page shows for its pictures, by the
/// id of the figure.
struct Told {
  std::vector<course::RecordedStep> steps;
  std::vector<std::string> sections;
  std::map<std::string, std::string> narrow = {};
};

/// Runs the whole lesson; the data of its charts go into slug/data in the folder of the site.
Told told(const course::Lesson& lesson, const std::filesystem::path& folder, bool quiet);

/// Writes what narrow pages show as slug/narrow.json, which the site packs into slug/narrow.js.
void write_narrow(const std::map<std::string, std::string>& pictures, const std::filesystem::path& folder,
                  const std::string& slug);

/// Runs the whole lesson and writes its page, NN_slug.html, into the folder of the site, with the data of its
/// charts in NN_slug/data, its films, each one file, in NN_slug/films and its digest for the site's other pages in
/// NN_slug.json. Returns what was recorded. Turns the lesson's parameters and puts them back.
std::vector<course::RecordedStep> write_page(course::Lesson& lesson, const std::filesystem::path& folder,
                                             bool quiet);

}  // namespace byhand::site
