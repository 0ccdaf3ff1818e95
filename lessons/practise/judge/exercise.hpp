#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/practise/judge/film.hpp"
#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/judge/wire.hpp"

namespace byhand::practise {

/// Code that belongs to an exercise's folder, compiled into this program.
struct Variant {
  std::string file;  // "solution.cpp", "mutants/no_half.cpp"
  Code code;
};

/// A folder of lessons/practise. The build makes one of these from its signature.hpp, probe.cpp, solution.cpp and
/// mutants/*.cpp; a program for a course is built without the last two, and `variants` is empty.
struct Exercise {
  std::string name;  // the folder: "01_rod_between_particles"
  void (*probe)(Probe&, const Code&);
  void (*film)(Film&, const Code&);
  std::string functions;          // that the learner writes, as FUNCTIONS names them: "value, jacobian"
  std::vector<Variant> variants;  // the solution first

  std::string function(std::size_t which) const;
  int number() const { return std::stoi(name); }
  std::filesystem::path folder() const;
};

/// All exercises by number.
const std::vector<Exercise>& exercises();

/// lessons/practise of the sources that this program was built from.
std::filesystem::path practise_folder();

/// task.md of an exercise.
struct Task {
  std::string title, equations, lesson;
  std::string statement;
  std::vector<std::string> hints;
  std::string derivation;
  std::string mutant;                    // the one to be unmasked
  std::map<std::string, Numbers> blind;  // a test which that mutant passes
};
Task task(const Exercise& exercise);

/// The comment that a file begins with, as one line: a mutant's sentence.
std::string first_comment(const std::filesystem::path& file);

std::string contents_of(const std::filesystem::path& file);

/// "p1=0.4,2 L=3". Throws std::invalid_argument naming what cannot be read.
std::map<std::string, Numbers> parse_given(const std::string& words);

}  // namespace byhand::practise
