#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/page/about.hpp"
#include "lessons/site/course/cover_scene.hpp"
#include "lessons/site/digest.hpp"

namespace byhand::site {

/// What the first page shows besides the lessons.
struct Cover {
  CoverScene scene = {};
  bool desk = false;            // the site has the derivation desk
  bool exercises = false;       // the site has the exercises
  bool cases = false;           // the site has the casebook
  std::string repository = {};  // its address; empty where nobody gave it
};

/// The pages of the course that belong to no single lesson. `exercises`: the site has them.
std::string contents_page(const std::vector<Digest>& lessons, const Cover& cover = {});
/// The article's equations, each with the place where the course displays it first.
std::string equations_page(bool exercises);
/// Every law that a lesson derives, with its place.
std::string laws_page(const std::vector<Digest>& lessons, bool exercises);
/// For those who teach with the course. `exercises`: their numbers by lesson. It links to what there is to
/// download in the folder `site`.
std::string teaching_page(const std::vector<Digest>& lessons,
                          const std::map<int, std::vector<int>>& exercises = {},
                          const std::filesystem::path& site = {});

}  // namespace byhand::site
