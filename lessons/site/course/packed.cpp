#include "lessons/site/course/packed.hpp"

#include <fmt/format.h>

#include <vector>

#include "lessons/files/atomic_file.hpp"
#include "lessons/site/course/zip.hpp"
#include "renderer/data_url.hpp"

namespace byhand::site {

namespace fs = std::filesystem;

std::string packed_script(const std::string& receiver, const std::string& json) {
  return fmt::format("'use strict';\n{}('{}');\n", receiver, renderer::base64(deflated(json)));
}

void pack_narrow_pictures(const fs::path& site) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::recursive_directory_iterator(site))
    if (entry.path().filename() == "narrow.json") all.push_back(entry.path());
  for (const fs::path& path : all) {
    course::write_whole(fs::path(path).replace_extension(".js"),
                        packed_script("byhandNarrow", course::read_whole(path).value_or("")));
    fs::remove(path);
  }
}

}  // namespace byhand::site
