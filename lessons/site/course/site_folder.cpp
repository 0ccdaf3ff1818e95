#include "lessons/site/course/site_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/checksum.hpp"
#include "lessons/files/lesson_json.hpp"
#include "lessons/files/output_folder.hpp"
#include "lessons/page/error.hpp"
#include "lessons/site/page_json.hpp"

namespace byhand::site {
namespace {

namespace fs = std::filesystem;
using course::EnvironmentError;

constexpr auto manifest = "manifest.json";

course::Manifest manifest_of(const fs::path& site) {
  return course::manifest_from_json(course::read_whole(site / manifest).value_or(""));
}

void refuse_foreign(const fs::path& site) {
  std::error_code ignored;
  const fs::file_status there = fs::status(site, ignored);
  if (!fs::exists(there) || (fs::is_directory(there) && fs::is_empty(site))) return;
  if (manifest_of(site).of != course::Manifest::Of::site)
    throw std::invalid_argument(fmt::format(
        "{} is not a site that ./lessons/run site wrote, and would be replaced as a whole: move it, or "
        "choose another folder with --output",
        site.string()));
}

/// Puts `fresh` in the place of `old`, which afterwards has the name of `fresh`.
void exchange(const fs::path& fresh, const fs::path& old) {
  if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) throw std::system_error(errno, std::generic_category());
  // Some file systems exchange nothing.
  const fs::path aside = old.string() + ".old";
  fs::remove_all(aside);
  fs::rename(old, aside);
  fs::rename(fresh, old);
  fs::rename(aside, fresh);
}

}  // namespace

SiteFolder::SiteFolder(fs::path site)
    : site_(std::move(site)), hidden_(site_.parent_path() / ("." + site_.filename().string() + ".part")) {
  refuse_foreign(site_);
  try {
    course::make_folders(hidden_);
    descriptor_ = open(hidden_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category());
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      throw EnvironmentError(
          fmt::format("Another run writes {}: wait until it has ended, or choose another folder "
                      "with --output.",
                      site_.string()));
    for (const auto& entry : fs::directory_iterator(hidden_)) fs::remove_all(entry.path());
  } catch (const std::system_error& error) {
    if (descriptor_ >= 0) close(descriptor_);
    throw EnvironmentError(fmt::format("Cannot use the folder {}: {}. Choose another with --output.",
                                       hidden_.string(), error.code().message()));
  } catch (...) {
    if (descriptor_ >= 0) close(descriptor_);
    throw;
  }
}

SiteFolder::~SiteFolder() {
  std::error_code ignored;
  if (!finished_) fs::remove_all(hidden_, ignored);
  close(descriptor_);
}

void SiteFolder::keep_what_a_person_added() const {
  if (!fs::is_directory(site_)) return;
  const course::Manifest old = manifest_of(site_);
  for (const auto& entry : fs::recursive_directory_iterator(site_)) {
    const fs::path name = entry.path().lexically_relative(site_);
    const bool ours = name == manifest || std::any_of(old.runs.begin(), old.runs.end(), [&](const auto& run) {
                        return run.files.contains(name.string());
                      });
    if (fs::is_directory(entry.symlink_status()) || ours || fs::exists(fs::symlink_status(hidden_ / name)))
      continue;
    fs::create_directories((hidden_ / name).parent_path());
    fs::copy(entry.path(), hidden_ / name, fs::copy_options::copy_symlinks);
  }
}

void SiteFolder::finish() {
  course::write_whole(hidden_ / manifest, site_manifest(checksums(hidden_)));
  try {
    keep_what_a_person_added();
    if (fs::exists(site_)) {
      exchange(hidden_, site_);
      fs::remove_all(hidden_);
    } else {
      fs::rename(hidden_, site_);
    }
  } catch (const std::system_error& error) {
    throw EnvironmentError(fmt::format("Cannot replace {}: {}.", site_.string(), error.code().message()));
  }
  finished_ = true;
}

std::map<std::string, std::string> checksums(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (!entry.is_regular_file() || name == manifest) continue;
    const auto bytes = course::read_whole(entry.path());
    if (!bytes) throw EnvironmentError(fmt::format("Cannot read {}.", entry.path().string()));
    all[name] = course::sha256(*bytes);
  }
  return all;
}

}  // namespace byhand::site
