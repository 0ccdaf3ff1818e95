#include "lessons/site/course/narrow.hpp"

#include <fmt/format.h>

#include <vector>

#include "lessons/files/atomic_file.hpp"
#include "lessons/site/course/zip.hpp"
#include "renderer/data_url.hpp"

namespace byhand::site {

namespace fs = std::filesystem;

void pack_narrow_pictures(const fs::path& site) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::recursive_directory_iterator(site))
    if (entry.path().filename() == "narrow.json") all.push_back(entry.path());
  for (const fs::path& path : all) {
    const std::string pictures = course::read_whole(path).value_or("");
    course::write_whole(fs::path(path).replace_extension(".js"),
                        fmt::format("'use strict';\nbyhandNarrow('{}');\n", renderer::base64(deflated(pictures))));
    fs::remove(path);
  }
}

}  // namespace byhand::site
