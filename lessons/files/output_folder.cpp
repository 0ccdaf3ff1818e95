#include "lessons/files/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/checksum.hpp"
#include "lessons/files/lesson_json.hpp"
#include "lessons/page/error.hpp"

namespace byhand::course {
namespace {

namespace fs = std::filesystem;

constexpr auto manifest_name = "manifest.json";

bool lies_below(const fs::path& name) {
  return name == name.lexically_normal() && name.has_filename() && name.is_relative() && *name.begin() != "..";
}

/// Only lessons' files are ever listed. A manifest is a file that anybody may have edited.
bool is_lessons(const std::string& name) {
  if (name == "lesson.md") return true;
  return lies_below(name) &&
         (name.starts_with("figures/") || name.starts_with("data/") || name.starts_with("frames/"));
}

Manifest read_manifest(const fs::path& folder) {
  const auto text = read_whole(folder / manifest_name);
  Manifest manifest = text ? manifest_from_json(*text) : Manifest{};
  const auto foreign = [&](const auto& file) {
    return manifest.of == Manifest::Of::site ? !lies_below(file.first) : !is_lessons(file.first);
  };
  for (WrittenRun& run : manifest.runs) {
    std::erase_if(run.files, foreign);
    std::erase_if(run.clocked, foreign);
  }
  return manifest;
}

/// Removes a name, and all names below it, from what earlier runs wrote.
void forget(Manifest& manifest, const std::string& name) {
  for (WrittenRun& run : manifest.runs)
    for (auto* const files : {&run.files, &run.clocked}) {
      files->erase(name);
      const std::string below = name + "/";
      const auto first = files->lower_bound(below);
      files->erase(first, std::find_if_not(first, files->end(),
                                           [&](const auto& file) { return file.first.starts_with(below); }));
    }
  std::erase_if(manifest.runs, [](const WrittenRun& run) { return run.files.empty() && run.clocked.empty(); });
}

bool lists(const Manifest& manifest, const std::string& name) {
  return std::any_of(manifest.runs.begin(), manifest.runs.end(), [&](const WrittenRun& run) {
    return run.files.contains(name) || run.clocked.contains(name);
  });
}

/// "0012.png"; a run that was killed lists its frames nowhere.
bool is_frame(const std::string& name) {
  constexpr size_t digits = 4;
  return name.size() >= digits + 4 && name.ends_with(".png") &&
         name.find_first_not_of("0123456789") == name.size() - 4;
}

/// Removes a file or a link, and nothing else.
void remove_file(const fs::path& path) {
  const fs::file_status there = fs::symlink_status(path);
  if (fs::is_regular_file(there) || fs::is_symlink(there)) fs::remove(path);
}

void remove_unfinished_of_killed_runs(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (is_unfinished(entry.path())) found.push_back(entry.path());
  for (const fs::path& path : found) fs::remove(path);
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder) : path_(std::move(folder)) {
  try {
    make_folders(path_);
    claim();
    remove_unfinished_of_killed_runs(path_);
  } catch (const std::system_error& error) {
    if (descriptor_ >= 0) close(descriptor_);
    throw EnvironmentError(fmt::format("Cannot use the folder {}: {}. Choose another with --output.",
                                       path_.string(), error.code().message()));
  } catch (...) {
    if (descriptor_ >= 0) close(descriptor_);
    throw;
  }
  before_ = read_manifest(path_);
  if (before_.of != Manifest::Of::lesson) before_ = {};
}

OutputFolder::~OutputFolder() { close(descriptor_); }

void OutputFolder::claim() {
  descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category());
  // The lock ends with the process. Some network file systems lock no folders: there the check at the end remains.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw EnvironmentError(
        fmt::format("Another run writes into {}: wait until it has ended, or choose another folder with --output.",
                    path_.string()));
}

void OutputFolder::begin_to_write() {
  if (writing_) return;
  std::error_code error;
  fs::remove(path_ / manifest_name, error);
  if (!error && fsync(descriptor_) != 0 && errno != EINVAL) error = {errno, std::generic_category()};
  if (error)
    throw EnvironmentError(
        fmt::format("Cannot remove {}: {}.", (path_ / manifest_name).string(), error.message()));
  writing_ = true;
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  begin_to_write();
  try {
    write_whole(path_ / name, bytes);
  } catch (const EnvironmentError&) {
    check_in_place();
    throw;
  }
  files_[name] = sha256(bytes);
}

void OutputFolder::remove(const std::string& name) {
  begin_to_write();
  const fs::path path = path_ / name;
  try {
    if (fs::is_directory(fs::symlink_status(path))) {
      std::vector<std::string> ours;
      for (const auto& entry : fs::directory_iterator(path)) {
        const std::string file = entry.path().filename().string();
        if (is_frame(file) || lists(before_, name + "/" + file)) ours.push_back(file);
      }
      for (const std::string& file : ours) remove_file(path / file);
      if (fs::is_empty(path)) fs::remove(path);
    } else {
      remove_file(path);
    }
  } catch (const fs::filesystem_error& error) {
    throw EnvironmentError(fmt::format("Cannot remove {}: {}.", path.string(), error.code().message()));
  }
  forget(before_, name);
  std::erase_if(files_, [&](const auto& file) { return file.first.starts_with(name + "/"); });
  files_.erase(name);
}

void OutputFolder::check_in_place() const {
  struct stat claimed {
  }, named{};
  if (fstat(descriptor_, &claimed) != 0 || stat(path_.c_str(), &named) != 0 || claimed.st_ino != named.st_ino ||
      claimed.st_dev != named.st_dev)
    throw EnvironmentError(
        fmt::format("The folder {} was moved or removed while the lesson wrote into it.", path_.string()));
}

void OutputFolder::check_written() const {
  check_in_place();
  for (const auto& [name, sum] : files_)
    if (sha256_of_file(path_ / name) != sum)
      throw EnvironmentError(
          fmt::format("{} was changed or removed by another program while the lesson wrote its files.",
                      (path_ / name).string()));
}

void OutputFolder::finish(const std::string& made_by, const std::set<std::string>& clocked, bool whole) {
  begin_to_write();
  Manifest manifest = before_;
  for (const auto& [name, sum] : files_) forget(manifest, name);
  if (whole) {
    for (const WrittenRun& run : manifest.runs)
      for (const auto* files : {&run.files, &run.clocked})
        for (const auto& [name, sum] : *files) remove(name);
    manifest.runs.clear();
  }
  check_written();
  WrittenRun run{made_by};
  for (const auto& file : files_) (clocked.contains(file.first) ? run.clocked : run.files).insert(file);
  manifest.of = Manifest::Of::lesson;
  manifest.lesson = path_.filename().string();
  manifest.runs.push_back(std::move(run));
  write_whole(path_ / manifest_name, to_json(manifest));
  before_ = std::move(manifest);
  files_.clear();
  writing_ = false;
}

void make_folders(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!failed) return;
  fs::path above;
  for (const fs::path& part : folder) {
    above /= part;
    std::error_code ignored;
    if (fs::is_symlink(fs::symlink_status(above, ignored)) && !fs::is_directory(above, ignored))
      throw EnvironmentError(fmt::format(
          "Cannot use the folder {}: {} is a link to {}, which is no folder. Choose another with --output.",
          folder.string(), above.string(), fs::read_symlink(above, ignored).string()));
  }
  throw std::system_error(failed);
}

bool is_written_folder(const fs::path& folder) {
  std::error_code ignored;
  const auto exists = [&](const char* name) { return fs::exists(fs::symlink_status(folder / name, ignored)); };
  return fs::is_directory(folder, ignored) &&
         (exists(manifest_name) || exists("lesson.md") || exists("figures") || exists("data") || exists("frames"));
}

std::vector<std::string> differences(const fs::path& folder, int& files) {
  files = 0;
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(folder / manifest_name, ignored)))
    return {"manifest.json is missing: a run was stopped, or has not ended yet"};
  const Manifest manifest = read_manifest(folder);
  if (manifest.of == Manifest::Of::nothing) return {"manifest.json is no manifest of a lesson or of a site"};
  std::vector<std::string> wrong;
  for (const WrittenRun& run : manifest.runs)
    for (const auto* sums : {&run.files, &run.clocked})
      for (const auto& [name, sum] : *sums) {
        ++files;
        if (!fs::exists(fs::symlink_status(folder / name, ignored)))
          wrong.push_back(name + " is missing");
        else if (sha256_of_file(folder / name) != sum)
          wrong.push_back(name + " is not as it was written");
      }
  // A site keeps what its owner puts into it, as a CNAME.
  if (manifest.of == Manifest::Of::lesson)
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string name = entry.path().lexically_relative(folder).string();
      if (!entry.is_directory(ignored) && is_lessons(name) && !lists(manifest, name))
        wrong.push_back(name + " is not listed");
    }
  std::sort(wrong.begin(), wrong.end());
  return wrong;
}

}  // namespace byhand::course
