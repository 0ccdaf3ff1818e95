#pragma once

#include <filesystem>
#include <string>

#include "lessons/practise/judge/exercise.hpp"

// What a learner is given with an exercise, at the terminal and as files.
namespace byhand::practise {

/// task.md without hints, derivation and what is to be unmasked.
std::string statement(const Exercise& exercise);

/// Where the lessons have the equations that a task names, one a line: "(17) λ of one row: lesson 2, step 3".
std::string equations_of(const Exercise& exercise);

/// The types and functions of practise.hpp in a few lines.
std::string given_types();

/// Writes task.md, the stub, signature.hpp and practise.hpp into this folder.
void write_handout(const std::filesystem::path& folder, const Exercise& exercise);

}  // namespace byhand::practise
