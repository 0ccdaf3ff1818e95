#include "lessons/practise/judge/exercise.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "lessons/page/error.hpp"

namespace byhand::practise {
namespace {

std::string trimmed(const std::string& words) {
  const auto first = words.find_first_not_of(" \n");
  return first == std::string::npos ? "" : words.substr(first, words.find_last_not_of(" \n") + 1 - first);
}

}  // namespace

std::filesystem::path practise_folder() { return BYHAND_PRACTISE_FOLDER; }

std::filesystem::path Exercise::folder() const { return practise_folder() / name; }

std::string Exercise::function(std::size_t which) const {
  std::istringstream names(functions);
  std::string one;
  for (std::size_t i = 0; i <= which; ++i) std::getline(names >> std::ws, one, ',');
  return one;
}

std::string contents_of(const std::filesystem::path& file) {
  // By C's functions: the library of C++ for WebAssembly has no files.
  const std::unique_ptr<std::FILE, decltype(&std::fclose)> in(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!in) throw course::EnvironmentError(file.string() + " cannot be read");
  std::string text;
  char part[4096];
  for (std::size_t got; (got = std::fread(part, 1, sizeof part, in.get())) > 0;) text.append(part, got);
  return text;
}

std::string first_comment(const std::filesystem::path& file) {
  std::istringstream lines(contents_of(file));
  std::string sentence, line;
  while (std::getline(lines, line) && line.starts_with("// "))
    sentence += (sentence.empty() ? "" : " ") + line.substr(3);
  return sentence;
}

std::map<std::string, Numbers> parse_given(const std::string& words) {
  std::map<std::string, Numbers> given;
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    const auto equals = word.find('=');
    Numbers values;
    std::istringstream list(equals == std::string::npos ? "" : word.substr(equals + 1));
    for (std::string value; std::getline(list, value, ',');) {
      char* end = nullptr;
      values.push_back(std::strtod(value.c_str(), &end));
      if (value.empty() || *end != '\0') values.clear();
      if (values.empty()) break;
    }
    if (values.empty())
      throw std::invalid_argument(
          fmt::format("\"{}\" is no NAME=NUMBER or, for a vector, NAME=NUMBER,NUMBER", word));
    given[word.substr(0, equals)] = values;
  }
  return given;
}

Task task(const Exercise& exercise) {
  std::istringstream lines(contents_of(exercise.folder() / "task.md"));
  Task task;
  std::string line, blind;
  std::string* part = &task.statement;
  while (std::getline(lines, line)) {
    if (line.starts_with("# ")) {
      task.title = line.substr(2);
    } else if (line.starts_with("Lesson: ")) {
      task.lesson = line.substr(8);
    } else if (line.starts_with("Equations: ")) {
      task.equations = line.substr(11);
    } else if (line == "## Hint") {
      part = &task.hints.emplace_back();
    } else if (line == "## Derivation") {
      part = &task.derivation;
    } else if (line.starts_with("## Unmask ")) {
      task.mutant = line.substr(10);
      part = &blind;
    } else {
      *part += line + "\n";
    }
  }
  for (std::string* words : {&task.statement, &task.derivation}) *words = trimmed(*words);
  for (std::string& hint : task.hints) hint = trimmed(hint);
  task.blind = parse_given(blind);
  return task;
}

}  // namespace byhand::practise
