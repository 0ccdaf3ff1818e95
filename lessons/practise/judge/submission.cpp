#include "lessons/practise/judge/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/error.hpp"
#include "lessons/practise/judge/check.hpp"
#include "lessons/practise/judge/comparison.hpp"
#include "lessons/practise/judge/confine.hpp"
#include "renderer/error.hpp"

namespace byhand::practise {
namespace {

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
  return {found->second, words.substr(equals + 1)};
}

void write(const std::vector<Report>& reports, const std::vector<Graded>& graded) {
  for (const auto& [format, file] : reports)
    if (file == "-")
      fmt::print("{}", format(graded));
    else
      course::write_whole(file, format(graded));
}

std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys, const std::vector<Report>& reports) {
  if (!std::filesystem::is_directory(folder))
    throw std::invalid_argument(fmt::format("{} is not a folder of submitted files", folder.string()));
  std::vector<Report> files = reports;
  std::erase_if(files, [](const Report& report) { return report.file == "-"; });
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
