#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace byhand::site {

/// The folder of a site while it is written: a hidden one beside the site, which it replaces at the end in one
/// step. A reader finds the old site or the new one, never a half. What a person put into the old one, as a CNAME,
/// is in the new one too. One process at a time. Every function throws course::EnvironmentError.
class SiteFolder {
 public:
  /// Claims the hidden folder and empties it of what a killed run left. Throws std::invalid_argument if `site` is
  /// there and is not a site, for it would be replaced as a whole.
  explicit SiteFolder(std::filesystem::path site);
  SiteFolder(const SiteFolder&) = delete;
  SiteFolder& operator=(const SiteFolder&) = delete;
  /// Removes what is not finished.
  ~SiteFolder();

  /// Where the files go.
  const std::filesystem::path& path() const { return hidden_; }

  /// Lists all files in manifest.json, adds those of the old site that its own manifest does not list, puts the
  /// folder in the place of the site and removes the old one.
  void finish();

 private:
  void keep_what_a_person_added() const;

  std::filesystem::path site_, hidden_;
  int descriptor_ = -1;  // of the hidden folder, and locked
  bool finished_ = false;
};

/// The SHA-256 of every file below a folder but manifest.json, by path.
std::map<std::string, std::string> checksums(const std::filesystem::path& folder);

}  // namespace byhand::site
