#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lessons/practise/judge/judge.hpp"

namespace byhand::practise {

/// One exercise of a submission and what the judge says.
struct Graded {
  const Exercise* exercise = nullptr;
  std::string file{};  // as the learner knows it; empty if it is missing
  Verdict verdict{};
  std::string picture{};  // bytes of a PNG; may be empty
};

using Keys = std::function<Key(const Exercise&)>;

/// Judges <folder>/<exercise>.cpp for each of these exercises.
std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys);

/// gradescope, classroom50, prairielearn, junit, github (annotations, to be printed), summary (Markdown).
using Format = std::string (*)(const std::vector<Graded>&);
const std::map<std::string, Format>& formats();

/// Writes all reports, NAME=FILE; throws std::invalid_argument for an unknown name.
struct Report {
  Format format;
  std::filesystem::path file;  // "-": standard output
};
Report parse_report(const std::string& words);
void write(const std::vector<Report>& reports, const std::vector<Graded>& graded);

/// Grades and writes the reports. Files say at first that the judge did not finish, so that they exist whatever
/// happens.
std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys, const std::vector<Report>& reports);

/// A key as JSON, for a machine that has no solution.
std::string to_json(const Key& key);
Key key_from_json(const std::string& text);

}  // namespace byhand::practise
