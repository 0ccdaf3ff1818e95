#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace byhand::tutor {

class Lesson;

/// The size of pictures and the rate of sequences.
struct Quality {
  std::string name;
  int width, height, rate;  // pixels, pixels, frames per second
};

/// Which frames of a sequence are wanted; the strip comes with `last` and `all`.
enum class FramesWanted { none, last, all };
std::string_view to_string(FramesWanted frames);

struct Options {
  bool interactive = false;
  std::filesystem::path output;
  Quality quality;
  FramesWanted frames = FramesWanted::all;
  std::vector<std::pair<std::string, std::string>> set;  // name, value
  bool list_parameters = false, check = false, quiet = false;
  std::string step;  // its label; empty: all
};

/// The project's own output folder, said as briefly as the present folder allows.
std::filesystem::path default_output();

/// What to do at once instead of running: words for standard output (`--help`).
struct Answered {
  std::string words;
};

/// Reads the command line of `lesson`. `at_terminal` decides where neither --interactive nor --no-interactive
/// is given. Throws Answered for --help and std::invalid_argument for anything that is not in order, in one
/// sentence.
Options read_options(const Lesson& lesson, int argc, const char* const* argv, bool at_terminal);

}  // namespace byhand::tutor
