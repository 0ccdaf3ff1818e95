#pragma once

#include <fstream>
#include <string>

#include "lessons/practise/judge/check.hpp"
#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {

inline const practise::Exercise& exercise(int number) {
  return practise::exercises().at(static_cast<std::size_t>(number) - 1);
}

inline const practise::Key& key_of(int number) {
  static std::map<int, practise::Key> keys;
  if (!keys.contains(number)) keys[number] = practise::key(exercise(number), 11);
  return keys[number];
}

/// The verdict on a file with this text.
inline practise::Verdict verdict_on(int number, const std::string& text) {
  const Folder folder;
  std::ofstream(folder / "mine.cpp") << text;
  return practise::check(exercise(number), key_of(number), folder / "mine.cpp");
}

inline std::string text_of(int number, const std::string& file) {
  return practise::contents_of(exercise(number).folder() / file);
}

}  // namespace byhand::tests
