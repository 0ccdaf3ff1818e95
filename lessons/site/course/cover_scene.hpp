#pragma once

#include <filesystem>
#include <string>

namespace byhand::site {

/// The scene on the course's first page, which a reader can drag: the chain of lesson 3 with one slider.
struct CoverScene {
  std::string section;     // a step of the lesson with the scene alone
  std::string head, foot;  // what makes it live; empty where it is a picture
};

/// Takes the scene out of the lesson's page in the folder of the site; nothing where the page has none.
CoverScene cover_scene(const std::filesystem::path& site);

}  // namespace byhand::site
