#include "lessons/practise/judge/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

namespace byhand::practise {
namespace {

std::string without(const std::string& text, const std::string& part) {
  std::string rest;
  std::size_t from = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, from)) {
    rest.append(text, from, at - from);
    from = at + part.size();
  }
  return rest.append(text, from);
}

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/') + 1); }

/// What GNU's linker or LLVM's misses first. Learners name what they like, at any length, so no regular expression
/// is made of it or sees it.
std::string undefined_name(const std::string& said) {
  for (const std::string words : {"undefined reference to `", "undefined symbol: "})
    if (const auto at = said.find(words); at != std::string::npos) {
      const auto begin = at + words.size(), end = std::min(said.find_first_of("'\n", begin), said.size());
      return said.substr(begin, std::min<std::size_t>(end - begin, 200));
    }
  return "";
}

/// Whether `name` and a parenthesis stand in a text.
bool has_function(const std::string& text, const std::string& name) {
  if (name.empty()) return false;
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const auto next = text.find_first_not_of(" \t\n", at + name.size());
    if ((at == 0 || !in_word(text[at - 1])) && next != std::string::npos && text[next] == '(') return true;
  }
  return false;
}

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

/// Whether a character lets what follows be read from the right to the left, or stands for none.
bool turns_the_line(unsigned point) {
  return (point >= 0x200B && point <= 0x200F) || (point >= 0x2028 && point <= 0x202E) ||
         (point >= 0x2060 && point <= 0x206F) || point == 0xFEFF;
}

}  // namespace

std::string rest_of_line(const std::string& text, const std::string& before) {
  const auto at = text.rfind(before);
  return at == std::string::npos ? "" : text.substr(at + before.size(), text.find('\n', at) - at - before.size());
}

Messages::Messages(const std::string& said, const std::string& file) {
  errors = about_own_lines(said, file, " error: ", line);
  if (errors.empty()) errors = about_a_header(said, file, line);
  int unused = 0;
  warnings = about_own_lines(said, file, " warning: ", unused);
}

std::string about_linking(const std::string& said, const std::string& text) {
  // As GNU's linker says it, or LLVM's.
  if (said.find("multiple definition of `main'") != std::string::npos ||
      said.find("duplicate symbol: main") != std::string::npos)
    return "Remove your main: the judge calls your functions from its own.";
  if (said.find("memory too large") != std::string::npos)
    return "Your global variables need more memory than an exercise has.";
  const std::string undefined = undefined_name(said);
  if (undefined.empty()) return "It compiles, and cannot be linked with the judge.";
  // Functions of C++ are named with their types; this is one of C, a variable, or what an assembler calls.
  if (undefined.find('(') == std::string::npos) return undefined + " is used, and nothing here defines it.";
  // Of a span without a fixed size.
  const std::string name = without(without(undefined, "plain::"), ", 18446744073709551615ul");
  const std::string called = name.substr(0, name.find('('));
  return fmt::format("{} is missing; keep the signature of the task{}.", name,
                     has_function(text, called) ? fmt::format(": your {} takes other types", called) : "");
}

std::string legible(const std::string& text, std::size_t most) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  std::string all;
  for (std::size_t i = 0; i < text.size() && all.size() < most;) {
    const unsigned first = byte(i);
    const std::size_t size = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    unsigned point = size < 2 ? first : first & (0x7Fu >> size);
    bool valid = size > 0;
    for (std::size_t k = 1; k < size; ++k) {
      valid = valid && (byte(i + k) & 0xC0) == 0x80;
      point = point << 6 | (byte(i + k) & 0x3F);
    }
    constexpr unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
    valid = valid && point >= least[size] && point < 0x110000 && (point < 0xD800 || point > 0xDFFF) &&
            point != 0xFFFE && point != 0xFFFF;
    if (!valid)
      all += "?";
    else if ((point >= 0xA0 && !turns_the_line(point)) || (point >= 0x20 && point < 0x7F) || point == '\n' ||
             point == '\t')
      all += text.substr(i, size);
    i += valid ? size : 1;
  }
  return all;
}

}  // namespace byhand::practise
