#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace byhand::site {

/// A page of the site around its content. All pages lie in one folder, beside assets/.
struct Frame {
  std::string title;           // of the page; the course's name follows it in <title>
  std::string content;         // of <main>
  std::string summary = {};    // what a preview of a link says; may be empty
  std::string picture = {};    // beside that summary, a path in the site; may be empty
  std::string beside = {};     // of the column beside it, such as the list of steps; may be empty
  std::string lesson = {};     // slug of the lesson whose page it is; may be empty
  std::string narrow = {};     // slug of the folder with its pictures for a narrow page; may be empty
  std::string head = {};       // more elements at the end of <head>
  std::string foot = {};       // more elements at the end of <body>
  std::string_view here = {};  // the page among those of the navigation, "equations.html"; may be empty
  bool exercises = false;      // the site has them, so that the navigation leads there
};

std::string framed(const Frame& frame);

/// The file with the pictures for a narrow page, in the folder of the site.
std::string narrow_pictures(const std::string& slug);

/// Whether a site has the exercises: what compiles them lies in its folder before any page does.
bool has_exercises(const std::filesystem::path& site);

}  // namespace byhand::site
