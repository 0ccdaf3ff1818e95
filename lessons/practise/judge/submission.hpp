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
  double seconds = 0;     // that judging took
};

/// Throws course::EnvironmentError where this system cannot keep a submission from reading the keys; if that is
/// wanted, says so on standard error.
void require_confinement(bool unconfined);

using Keys = std::function<Key(const Exercise&)>;

/// gradescope, classroom50, prairielearn, junit, github (annotations, to be printed), summary (Markdown).
using Format = std::string (*)(const std::vector<Graded>&);
const std::map<std::string, Format>& formats();

struct Report {
  Format format;
  std::filesystem::path file;  // "-": standard output
};
/// Reads NAME=FILE. Throws std::invalid_argument for an unknown name, a folder, or a file whose folder is not
/// there.
Report parse_report(const std::string& words);
/// Writes each report: through a pipe or a device, which is never replaced, or as a whole file.
void write(const std::vector<Report>& reports, const std::vector<Graded>& graded);

/// Judges <folder>/<exercise>.cpp for each of these exercises with keys that stay secret, and writes the reports:
/// files after each exercise, in which those that follow have not finished, so that a judge that is killed costs
/// no more. Throws std::invalid_argument if there is no such folder.
std::vector<Graded> grade(const std::vector<const Exercise*>& wanted, const std::filesystem::path& folder,
                          const Keys& keys, const std::vector<Report>& reports);

/// A key as JSON, for a machine that has no solution.
std::string to_json(const Key& key);
Key key_from_json(const std::string& text);

}  // namespace byhand::practise
