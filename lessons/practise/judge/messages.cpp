#include "lessons/practise/judge/messages.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <regex>
#include <sstream>

namespace byhand::practise {
namespace {

std::string without(std::string text, const std::string& part) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at)) text.erase(at, part.size());
  return text;
}

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/') + 1); }

/// Each line at most 200 characters and 4 KB in all, without the path of `file`.
std::string shortened(const std::string& text, const std::string& file) {
  constexpr std::size_t most_in_line = 200, most = 4096;
  std::istringstream lines(without(text, folder_of(file)));
  std::string all;
  for (std::string line; std::getline(lines, line) && all.size() < most;)
    all += (line.size() > most_in_line ? line.substr(0, most_in_line) + " …" : line) + "\n";
  return all;
}

/// The messages of a kind about the learner's own lines, in order; `line` becomes that of the first.
std::string about_own_lines(const std::string& said, const std::string& file, const std::string& kind, int& line) {
  std::istringstream lines(said);
  std::string all, text;
  bool own = false;
  while (std::getline(lines, text)) {
    const bool quoted = text.starts_with(" ");
    if (!quoted) own = text.starts_with(file + ":") && text.find(kind) != std::string::npos;
    if (!own) continue;
    if (line == 0) line = std::atoi(text.c_str() + file.size() + 1);
    all += text + "\n";
  }
  return shortened(all, file);
}

/// The learner's line that an error in a header comes from, and what the compiler says there.
std::string about_a_header(const std::string& said, const std::string& file, int& line) {
  std::istringstream lines(said);
  std::string from, error, text;
  while (std::getline(lines, text)) {
    const auto at = text.find(file + ":");
    if (at != std::string::npos && from.empty()) {
      line = std::atoi(text.c_str() + at + file.size() + 1);
      if (line > 0) from = fmt::format("{}:{}: ", file, line);
    }
    for (const char* kind : {"error: ", "Error: "})
      if (const auto found = text.find(kind); found != std::string::npos && error.empty())
        error = text.substr(found);
  }
  return error.empty() ? "" : shortened(from + error + "\n", file);
}

}  // namespace

Messages::Messages(const std::string& said, const std::string& file) {
  errors = about_own_lines(said, file, " error: ", line);
  if (errors.empty()) errors = about_a_header(said, file, line);
  int unused = 0;
  warnings = about_own_lines(said, file, " warning: ", unused);
}

std::string about_linking(const std::string& said, const std::string& text) {
  if (said.find("multiple definition of `main'") != std::string::npos)
    return "Remove your main: the judge calls your functions from its own.";
  constexpr const char* undefined = "undefined reference to `";
  const auto at = said.find(undefined);
  if (at == std::string::npos) return "It compiles, and cannot be linked with the judge.";
  const auto begin = at + std::string(undefined).size();
  std::string name = without(said.substr(begin, said.find('\'', begin) - begin), "plain::");
  name = std::regex_replace(name, std::regex(", 18446744073709551615ul"), "");  // of a span without a fixed size
  const std::string called = name.substr(0, name.find('('));
  const bool other = std::regex_search(text, std::regex("\\b" + called + "\\s*\\("));
  return fmt::format("{} is missing; keep the signature of the task{}.", name,
                     other ? fmt::format(": your {} takes other types", called) : "");
}

}  // namespace byhand::practise
