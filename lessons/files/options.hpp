#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace byhand::course {

class Lesson;

/// The size of pictures and the rate of sequences.
struct Quality {
  std::string name;
  int width, height, rate;  // pixels, pixels, frames per second
};

/// Frames of a sequence to write. The key frames are written for `last` and `all`.
enum class FramesWanted { none, last, all };
std::string_view to_string(FramesWanted frames);

struct Options {
  bool interactive = false;
  std::filesystem::path output;
  Quality quality;
  FramesWanted frames = FramesWanted::all;
  std::string film;                                      // format of films; empty: none
  std::vector<std::pair<std::string, std::string>> set;  // name, value
  bool list_parameters = false, check = false, quiet = false, questions = false;
  bool plain = false;  // for screen readers
  std::string step;    // label of the only step to run; empty: all
};

/// The project's output folder, relative to the current folder where it lies below it.
std::filesystem::path default_output();

/// Thrown for --help, with the text to print.
struct HelpRequested {
  std::string text;
};

/// Parses the command line of `lesson`. `at_terminal` is the default of --interactive. Throws HelpRequested for
/// --help and std::invalid_argument with one sentence for any error.
Options read_options(const Lesson& lesson, int argc, const char* const* argv, bool at_terminal);

}  // namespace byhand::course
