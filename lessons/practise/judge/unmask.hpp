#pragma once

#include <string>

#include "lessons/practise/judge/exercise.hpp"

// A wrong code whose mistake a learner finds by choosing the numbers of a test.
namespace byhand::practise {

/// Numbers on which the mutant is right, "m1=2 I1=3".
std::string blind_test(const Exercise& exercise);

/// The mutant's code, without the sentence that says what is wrong.
std::string masked_code(const Exercise& exercise);

/// Whether the mutant answers wrongly on these numbers, "m1=2 I1=3"; all others are those of the test it passes.
/// Throws std::invalid_argument for an unknown name.
bool unmask(const Exercise& exercise, const std::string& numbers, std::string& report);

}  // namespace byhand::practise
