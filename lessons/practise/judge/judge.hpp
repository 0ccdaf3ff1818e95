#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lessons/practise/judge/exercise.hpp"

namespace byhand::practise {

inline constexpr int probes = 24;

/// What the judge compares with: the sheets of the right answer and of each misconception on the same probes.
/// Without any code, so that a course can send it to a machine where learners' programs run.
struct Key {
  struct Misconception {
    std::string sentence;
    std::vector<Sheet> sheets;
  };
  std::uint64_t seed = 1;
  std::vector<Sheet> right;
  std::vector<std::vector<Numbers>> tolerance;  // of each value of `right`
  std::vector<Misconception> misconceptions;
  Film film;
  std::vector<double> film_tolerance;  // of each frame, as a share of each number's largest value
  bool secret = false;                 // a course's: its numbers are not shown to a learner
};

/// Runs the solution and every mutant, which are the exercise's variants.
Key key(const Exercise& exercise, std::uint64_t seed);

/// The sheet of code on one probe.
Sheet sheet(const Exercise& exercise, const Code& code, std::uint64_t seed, int index);

struct Verdict {
  enum class Kind { right, misconception, wrong, not_written, stopped, does_not_compile };
  Kind kind = Kind::wrong;
  std::string sentence;  // one
  std::string details;   // the probe's numbers, or the compiler's lines
  std::string printed;   // by the learner's code
  int line = 0;          // of the learner's file, where one is to blame
  Film film;             // what the code did; may be cut short

  bool is_right() const { return kind == Kind::right; }
};

/// Runs the code on all probes and in the film, and compares. A Stopped that the code throws becomes the verdict.
/// Throws course::EnvironmentError if the key was made for other probes than these.
Verdict judge(const Exercise& exercise, const Key& key, const Code& code);

/// All that a frame shows: its reading, then of each shape two points and an angle.
Numbers numbers_of(const Frame& frame);

/// Whether both say the same on a probe, within what rounding explains.
bool same_sheet(const Sheet& one, const Sheet& other, const std::vector<Numbers>& tolerance);

/// The same for the answers alone, or for the laws where nothing is answered: what a test of a few numbers sees.
bool same_answers(const Sheet& one, const Sheet& other);

/// How much the values of the solution's sheet may differ by rounding: ten times what they change when each given
/// number changes by 1e-13 of itself, but at least 1e-12 of the largest value.
std::vector<Numbers> tolerance(const Exercise& exercise, const Code& solution, std::uint64_t seed, int index);

/// How far each frame of the film that this code made may differ, as a share of each number's largest value: by a
/// millionth, and by a hundred times what changes if each number that the code returns changes by 1e-13 of itself.
std::vector<double> film_tolerance(const Exercise& exercise, const Code& code, const Film& film);

}  // namespace byhand::practise
