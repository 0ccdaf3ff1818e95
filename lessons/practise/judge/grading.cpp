#include "lessons/practise/judge/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "lessons/practise/judge/check.hpp"
#include "lessons/practise/judge/picture.hpp"
#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace byhand::practise {
namespace {

std::string picture_of(const Film& yours, const Film& right) {
  try {
    return yours.frames.empty() ? "" : still_png(yours, right);
  } catch (const renderer::EnvironmentError&) {
    return "";  // a machine without OpenGL grades without pictures
  }
}

std::vector<Graded> not_finished(const std::vector<const Exercise*>& wanted) {
  std::vector<Graded> all;
  for (const Exercise* exercise : wanted) {
    Graded graded{.exercise = exercise, .file = exercise->name + ".cpp"};
    graded.verdict.kind = Verdict::Kind::stopped;
    graded.verdict.sentence = "The judge did not finish.";
    all.push_back(std::move(graded));
  }
  return all;
}

}  // namespace

std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys) {
  std::vector<Graded> all;
  for (const Exercise* exercise : wanted) {
    Graded graded{.exercise = exercise, .file = exercise->name + ".cpp"};
    const auto path = folder / graded.file;
    if (std::filesystem::is_regular_file(path)) {
      const Key key = keys(*exercise);
      graded.verdict = check(*exercise, key, path);
      graded.picture = picture_of(graded.verdict.film, key.film);
    } else {
      graded.verdict.kind = Verdict::Kind::not_written;
      graded.verdict.sentence = graded.file + " is missing.";
    }
    all.push_back(std::move(graded));
  }
  return all;
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
      renderer::write_whole(file, format(graded));
}

std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys, const std::vector<Report>& reports) {
  std::vector<Report> files = reports;
  std::erase_if(files, [](const Report& report) { return report.file == "-"; });
  write(files, not_finished(wanted));
  auto graded = grade(wanted, folder, keys);
  write(reports, graded);
  return graded;
}

}  // namespace byhand::practise
