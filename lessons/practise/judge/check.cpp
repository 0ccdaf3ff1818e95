#include "lessons/practise/judge/check.hpp"

#include <fmt/format.h>

#include <sstream>

#include "lessons/practise/judge/process.hpp"
#include "renderer/error.hpp"

namespace byhand::practise {
namespace {

namespace fs = std::filesystem;

/// Where the build leaves child.cpp for each exercise: beside this program.
fs::path child(const Exercise& exercise) {
  return fs::read_symlink("/proc/self/exe").parent_path() / "practise_children" /
         fmt::format("lib{}.a", exercise.name);
}

/// The messages about the learner's own lines, in order; their first line number is put into `line`.
std::string about_own_lines(const std::string& said, const std::string& file, int& line) {
  std::istringstream lines(said);
  std::string all, text;
  bool own = false;
  while (std::getline(lines, text)) {
    const bool quoted = text.starts_with(" ");
    if (!quoted) own = text.starts_with(file + ":") && text.find(" error: ") != std::string::npos;
    if (!own) continue;
    if (line == 0) line = std::atoi(text.c_str() + file.size() + 1);
    all += (quoted ? text : fs::path(file).filename().string() + text.substr(file.size())) + "\n";
  }
  return all;
}

/// The learner's line that an error in a header comes from, and what the compiler says there.
std::string about_a_header(const std::string& said, const std::string& file, int& line) {
  std::istringstream lines(said);
  std::string from, error, text;
  while (std::getline(lines, text)) {
    const auto at = text.find(file + ":");
    if (at != std::string::npos && from.empty()) {
      line = std::atoi(text.c_str() + at + file.size() + 1);
      if (line > 0) from = fmt::format("{}:{}: ", fs::path(file).filename().string(), line);
    }
    if (const auto found = text.find("error: "); found != std::string::npos && error.empty())
      error = text.substr(found);
  }
  return from + error + "\n";
}

Verdict not_compiled(const std::string& said, const std::string& file) {
  Verdict verdict;
  verdict.kind = Verdict::Kind::does_not_compile;
  if (const auto at = said.find("undefined reference to `"); at != std::string::npos) {
    const auto begin = at + 24;
    std::string name = said.substr(begin, said.find('\'', begin) - begin);
    for (auto found = name.find("plain::"); found != std::string::npos; found = name.find("plain::"))
      name.erase(found, 7);
    verdict.sentence = fmt::format("{} is missing; keep the signature of the task.", name);
    return verdict;
  }
  verdict.sentence = "It does not compile.";
  verdict.details = about_own_lines(said, file, verdict.line);
  if (verdict.details.empty()) verdict.details = about_a_header(said, file, verdict.line);
  if (said.empty()) verdict.sentence = "It does not compile within ten seconds.";
  return verdict;
}

}  // namespace

Verdict check(const Exercise& exercise, const Key& key, const fs::path& path) {
  const fs::path file = fs::absolute(path), signature = exercise.folder() / "signature.hpp",
                 header = practise_folder() / "learner", library = child(exercise);
  if (!fs::exists(library)) throw renderer::EnvironmentError(library.string() + " is missing");
  const Scratch scratch;
  const std::string program = (scratch.path() / "program").string();
  const Finished compiled = run_confined(
      {BYHAND_COMPILER, "-std=c++20", "-O1", "-static", "-Werror=return-type", "-fmax-errors=3",
       "-I" + header.string(), "-include", signature.string(), file.string(), library.string(), "-o", program},
      {file, signature, header, library}, scratch.path(), {.seconds = 10, .bytes = 1u << 30});
  if (compiled.status != 0) return not_compiled(compiled.said, file.string());

  Process process(program);
  Verdict verdict = judge(
      exercise, key, [&](std::size_t which, const Numbers& arguments) { return process.call(which, arguments); });
  verdict.printed = process.printed();
  return verdict;
}

}  // namespace byhand::practise
