#include "lessons/tutor/command.hpp"

#include <map>

#include "lessons/tutor/lesson.hpp"

namespace byhand::tutor {
namespace {

std::string trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return "";
  return std::string(line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
}

}  // namespace

Command parse_command(const Lesson& lesson, std::string_view line) {
  using Kind = Command::Kind;
  static const std::map<std::string, Kind> keys = {
      {"", Kind::next},   {"b", Kind::back}, {"d", Kind::deeper}, {"h", Kind::hint}, {"hint", Kind::hint},
      {"why", Kind::why}, {"s", Kind::show}, {"r", Kind::repeat}, {"?", Kind::help}, {"q", Kind::quit}};
  const std::string words = trimmed(line);
  if (const auto key = keys.find(words); key != keys.end()) return {key->second, "", ""};

  const auto end = words.find_first_of(" \t=");
  const std::string name = words.substr(0, end);
  if (!lesson.is_parameter(name)) return {Kind::answer, "", words};
  if (end == std::string::npos) return {Kind::query, name, ""};
  std::string value = trimmed(std::string_view(words).substr(end));
  if (value.starts_with('=')) value = trimmed(std::string_view(value).substr(1));
  return {Kind::set, name, value};
}

}  // namespace byhand::tutor
