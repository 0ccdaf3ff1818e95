#pragma once

#include <filesystem>
#include <string>

#include "lessons/practise/judge/check.hpp"
#include "lessons/practise/judge/unmask.hpp"

// What a learner sees at a terminal.
namespace byhand::practise {

/// All exercises with what is solved.
std::string overview();

/// A task on one screen: title, statement, signature.
std::string task_text(const Exercise& exercise);

/// The verdict in words; "" never.
std::string verdict_text(const Verdict& verdict);

/// Hint 1, 2 or 3. Throws std::invalid_argument naming the range.
std::string hint_text(const Exercise& exercise, int degree);

/// The reference solution and its derivation; notes that it was requested unless the exercise is solved.
std::string solution_text(const Exercise& exercise);

void note_solved(const Exercise& exercise);

/// Copies the stub to `<folder>/<name>.cpp` unless there is such a file; returns its path.
std::filesystem::path learners_file(const Exercise& exercise, const std::filesystem::path& folder);

/// Judges the file at each save until Ctrl-C or `q`. After each verdict the picture lies beside the file.
int watch(const Exercise& exercise, const Key& key, const std::filesystem::path& file);

/// The code of the mutant and the test that it passes.
std::string unmask_text(const Exercise& exercise);

}  // namespace byhand::practise
