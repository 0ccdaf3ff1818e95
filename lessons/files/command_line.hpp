#pragma once

#include <string>
#include <vector>

namespace byhand::course {

/// The options of a lesson as they were typed.
struct CommandLine {
  bool interactive = false, no_interactive = false, list_parameters = false, check = false, quiet = false,
       questions = false, plain = false;
  std::string output;
  std::string quality = "medium";  // low, medium or high
  std::string frames;              // none, last, all; empty: the default
  std::string film;                // webm, mp4; empty: none
  std::string step;
  std::vector<std::string> settings;  // "NAME=VALUE"
};

/// Why what is typed names no folder, in a sentence; empty if it may.
std::string not_a_folder(const std::string& typed);

/// Parses a command line. `title`, `program` and `footer` appear in the help. Throws HelpRequested for --help and
/// std::invalid_argument with one sentence for an error.
CommandLine parse_command_line(const std::string& title, const std::string& program, const std::string& footer,
                               int argc, const char* const* argv);

}  // namespace byhand::course
