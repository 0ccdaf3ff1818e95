#include "lessons/site/course/versions.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/checksum.hpp"

namespace byhand::site {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t letters = 8;  // of the checksum

/// `text` with the version of each file that is named between `before` and `after`, relative to `folder`.
void add_versions(std::string& text, const std::string& before, char after, const fs::path& folder,
                  std::map<fs::path, std::string>& versions) {
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
    const auto begin = at + before.size(), end = text.find(after, begin);
    const std::string name = text.substr(begin, end - begin);
    const fs::path file = (folder / name).lexically_normal();
    const auto extension = file.extension();
    if ((extension != ".js" && extension != ".css" && extension != ".woff2") || !fs::is_regular_file(file))
      continue;
    std::string& version = versions[file];
    if (version.empty()) version = course::sha256(course::read_whole(file).value_or("")).substr(0, letters);
    text.insert(end, "?v=" + version);
  }
}

}  // namespace

void write_versions(const fs::path& site) {
  std::map<fs::path, std::string> versions;
  std::vector<fs::path> sheets, pages;
  for (const auto& entry : fs::recursive_directory_iterator(site)) {
    if (entry.path().extension() == ".css") sheets.push_back(entry.path());
    if (entry.path().extension() == ".html") pages.push_back(entry.path());
  }
  // A sheet's own version tells of its fonts' too.
  const auto rewrite = [&](const fs::path& path, const std::vector<std::pair<std::string, char>>& places) {
    const std::string before = course::read_whole(path).value_or("");
    std::string after = before;
    for (const auto& [begin, end] : places) add_versions(after, begin, end, path.parent_path(), versions);
    if (after != before) course::write_whole(path, after);
  };
  for (const fs::path& sheet : sheets) rewrite(sheet, {{"url(", ')'}});
  for (const fs::path& page : pages)
    rewrite(page, {{"src=\"", '"'}, {"href=\"", '"'}, {"data-index=\"", '"'}, {"data-narrow=\"", '"'}});
}

}  // namespace byhand::site
