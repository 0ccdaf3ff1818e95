#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {

/// Every file below the folder with its bytes.
inline std::map<std::string, std::string> all_files(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) files[fs::relative(entry.path(), folder).string()] = contents(entry.path());
  return files;
}

/// Path → SHA-256 of all files that the manifest in the folder lists.
inline std::map<std::string, std::string> listed(const std::filesystem::path& folder) {
  std::map<std::string, std::string> sums;
  const auto manifest = nlohmann::json::parse(contents(folder / "manifest.json"));
  for (const auto& made : manifest.at("runs"))
    for (const char* kind : {"files", "clocked"})
      for (const auto& [name, sum] : made.at(kind).items()) sums[name] = sum;
  return sums;
}

/// Whether the manifest lists every file of the folder but itself, each with the sum that sha256sum finds.
inline bool manifest_holds(const std::filesystem::path& folder) {
  std::set<std::string> names;
  std::ofstream sums(folder.parent_path() / "sums");
  for (const auto& [name, sum] : listed(folder)) {
    sums << sum << "  " << name << "\n";
    names.insert(name);
  }
  sums.close();
  std::set<std::string> there;
  for (const auto& [name, bytes] : all_files(folder))
    if (name != "manifest.json") there.insert(name);
  return there == names &&
         run("cd '" + folder.string() + "' && sha256sum --check --strict --status ../sums").status == 0;
}

/// The files of a lesson without what a clock measured and without the manifest, which holds sums of that.
inline std::map<std::string, std::string> lasting_files(const std::filesystem::path& folder) {
  auto files = all_files(folder);
  for (const char* clocked : {"data/clock.csv", "figures/clock.png", "manifest.json"}) files.erase(clocked);
  return files;
}

}  // namespace byhand::tests
