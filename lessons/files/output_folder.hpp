#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace byhand::course {

/// What one run wrote into the folder of its lesson.
struct WrittenRun {
  std::string made_by;                                          // JSON: the step, options, versions
  std::map<std::string, std::string> files = {}, clocked = {};  // path below the folder → SHA-256
};

/// manifest.json of a lesson's folder, with the run that wrote each file last; or of a site, which one run writes.
struct Manifest {
  enum class Of { nothing, lesson, site } of = Of::nothing;
  std::string lesson = {};
  std::vector<WrittenRun> runs = {};
};

/// The folder of a lesson's files. It belongs to one process at a time. manifest.json is removed before the first
/// file is written and written again when all files are, so where it stands, they are whole. All functions throw
/// EnvironmentError.
class OutputFolder {
 public:
  /// Makes the folder, claims it until this process ends, and removes the temporary files of killed runs.
  explicit OutputFolder(std::filesystem::path folder);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file whose path is relative to the folder. Not for two threads at once.
  void write(const std::string& name, std::string_view bytes);
  /// Removes a file of an earlier run, or of a folder its numbered frames and what the manifest lists: what a
  /// person put beside them stays.
  void remove(const std::string& name);

  /// Checks that every file is there with the bytes that were written, then writes manifest.json. After a run of
  /// the whole lesson the files of earlier runs go.
  void finish(const std::string& made_by, const std::set<std::string>& clocked, bool whole);

 private:
  void begin_to_write();
  void claim();
  void check_in_place() const;
  void check_written() const;

  std::filesystem::path path_;
  int descriptor_ = -1;  // of the folder, and locked
  bool writing_ = false;
  Manifest before_;                           // what earlier runs wrote and is still there
  std::map<std::string, std::string> files_;  // path → SHA-256
};

/// Makes a folder and those above it. Throws EnvironmentError, which names a link that leads nowhere.
void make_folders(const std::filesystem::path& folder);

/// Whether a lesson, or ./lessons/run site, has written into the folder: it holds manifest.json, lesson.md,
/// figures, data or frames.
bool is_written_folder(const std::filesystem::path& folder);

/// What is wrong with the folder of a lesson or of a site according to its manifest, one line for each file;
/// nothing if all is as it was written. `files` becomes the number of files that the manifest lists.
std::vector<std::string> differences(const std::filesystem::path& folder, int& files);

}  // namespace byhand::course
