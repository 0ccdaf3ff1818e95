#include "lessons/practise/judge/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/error.hpp"
#include "lessons/practise/judge/check.hpp"
#include "lessons/practise/judge/comparison.hpp"
#include "lessons/practise/judge/confine.hpp"
#include "renderer/error.hpp"

namespace byhand::practise {
namespace {

namespace fs = std::filesystem;

std::string picture_of(const Film& yours, const Film& right) {
  try {
    return yours.frames.empty() ? "" : still_png(yours, right);
  } catch (const renderer::Unavailable&) {
    return "";  // a machine without OpenGL grades without pictures
  }
}

Graded judged(const Exercise& exercise, const std::filesystem::path& folder, const Keys& keys) {
  Graded graded{.exercise = &exercise, .file = exercise.name + ".cpp"};
  const auto path = folder / graded.file;
  if (std::filesystem::exists(std::filesystem::symlink_status(path))) {
    Key key = keys(exercise);
    key.secret = true;
    graded.verdict = check(exercise, key, path);
    graded.picture = picture_of(graded.verdict.film, key.film);
  } else {
    graded.verdict.kind = Verdict::Kind::not_written;
    graded.verdict.sentence = graded.file + " is missing.";
  }
  return graded;
}

/// Whether the report goes through what is there, as through a pipe or a device, and replaces no file.
bool is_stream(const fs::path& file) {
  std::error_code error;
  const fs::file_status there = fs::status(file, error);
  return file == "-" || (fs::exists(there) && !fs::is_regular_file(there));
}

void write_through(const fs::path& stream, const std::string& report) {
  std::ofstream out(stream, std::ios::binary | std::ios::app);
  out << report << std::flush;
  if (!out)
    throw course::EnvironmentError(
        fmt::format("Cannot write {}: {}.", stream.string(), std::generic_category().message(errno)));
}

/// A link stands for the file that it names, and /dev/stdout for "-".
fs::path file_of_report(const fs::path& typed) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("--report …={}: {}", typed.string(), why));
  };
  if (typed == "-") return typed;
  if (typed.empty()) refuse("name a file, or - for the terminal");
  std::error_code error;
  const fs::file_status there = fs::status(typed, error);
  if (fs::is_directory(there)) refuse("this is a folder; name a file");
  if (fs::exists(there) && fs::equivalent(typed, "/proc/self/fd/1", error)) return "-";
  if (fs::exists(there)) return fs::is_regular_file(there) ? fs::canonical(typed) : typed;
  if (fs::is_symlink(fs::symlink_status(typed, error))) refuse("this is a link to a file that is not there");
  if (!fs::is_directory(fs::absolute(typed).parent_path(), error)) refuse("there is no folder to put it into");
  return typed;
}

}  // namespace

void require_confinement(bool unconfined) {
  const std::string missing = missing_confinement();
  if (missing.empty()) return;
  if (!unconfined) throw course::EnvironmentError(missing + ". --unconfined grades all the same.");
  fmt::print(stderr, "{}. Grading all the same.\n", missing);
}

Report parse_report(const std::string& words) {
  const auto equals = words.find('=');
  const auto found = formats().find(words.substr(0, equals));
  if (equals == std::string::npos || found == formats().end()) {
    std::string names;
    for (const auto& [name, format] : formats()) names += (names.empty() ? "" : ", ") + name;
    throw std::invalid_argument(fmt::format("--report {}: write FORMAT=FILE, with a FORMAT of {}", words, names));
  }
  return {found->second, file_of_report(words.substr(equals + 1))};
}

void write(const std::vector<Report>& reports, const std::vector<Graded>& graded) {
  for (const auto& [format, file] : reports)
    if (file == "-")
      fmt::print("{}", format(graded));
    else if (is_stream(file))
      write_through(file, format(graded));
    else
      course::write_whole(file, format(graded));
}

std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys, const std::vector<Report>& reports) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw std::invalid_argument(fmt::format("{} is not a folder of submitted files", folder.string()));
  std::vector<Report> files = reports;
  std::erase_if(files, [](const Report& report) { return is_stream(report.file); });
  std::vector<Graded> all;
  for (const Exercise* exercise : wanted) {
    Graded waits{.exercise = exercise, .file = exercise->name + ".cpp"};
    waits.verdict.kind = Verdict::Kind::stopped;
    waits.verdict.sentence = "The judge did not finish.";
    all.push_back(std::move(waits));
  }
  write(files, all);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto begun = std::chrono::steady_clock::now();
    all[i] = judged(*wanted[i], folder, keys);
    all[i].seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    write(files, all);
  }
  write(reports, all);
  return all;
}

}  // namespace byhand::practise
