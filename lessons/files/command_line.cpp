#include "lessons/files/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "lessons/files/nearest.hpp"
#include "lessons/files/options.hpp"

// The only source that includes CLI11, which takes seconds to compile.
namespace byhand::course {
namespace {

constexpr auto seek_help = "; --help shows the options";

void add_choice(CLI::App& app, const std::string& name, std::string& value,
                const std::vector<std::string>& choices, const std::string& meaning) {
  app.add_option(name, value, meaning)
      ->type_name(CLI::detail::join(choices, "|"))
      ->check([choices](const auto& typed) {
        if (std::find(choices.begin(), choices.end(), typed) != choices.end()) return std::string();
        return "\"" + typed + "\" is none of " + CLI::detail::join(choices, ", ") + suggestion(typed, choices);
      });
}

std::string require_label(const std::string& typed) { return typed.empty() ? "\"\" is no label of a step" : ""; }

/// Refuses what CLI11 would accept, or refuse in words of its own: unknown options, values of flags, options
/// without their value or given twice.
void refuse_misshapen(const CLI::App& app, int argc, const char* const* argv) {
  std::map<std::string, const CLI::Option*> options;
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    names.push_back("--" + option->get_single_name());
    options[names.back()] = option;
  }
  const auto refuse = [](const std::string& sentence) { throw std::invalid_argument(sentence + seek_help); };
  std::set<std::string> seen;
  for (int i = 1; i < argc; ++i) {
    const std::string typed = argv[i], name = typed.substr(0, typed.find('='));
    const auto found = options.find(name);
    if (found == options.end()) refuse("There is no option \"" + typed + "\"" + suggestion(name, names));
    const CLI::Option& option = *found->second;
    const bool with_value = name != typed, flag = option.get_expected_min() == 0;
    if (flag && with_value)
      refuse(name + " takes no value, but \"" + typed.substr(name.size() + 1) + "\" is given");
    if (!flag && !with_value && ++i == argc) refuse(name + " needs a value: " + option.get_type_name());
    if (!flag && name != "--set" && !seen.insert(name).second) refuse(name + " is given twice");
  }
}

}  // namespace

std::string not_a_folder(const std::string& typed) {
  if (typed.empty()) return "\"\" names no folder";
  if (typed.front() == '-') return "\"" + typed + "\" looks like an option; a folder of that name is ./" + typed;
  return "";
}

CommandLine parse_command_line(const std::string& title, const std::string& program, const std::string& footer,
                               int argc, const char* const* argv) {
  CommandLine line;
  line.output = default_output().string();
  CLI::App app(title, program);
  app.footer(footer);
  app.get_formatter()->column_width(30);
  app.set_help_flag("--help", "this page");
  app.add_flag("--interactive", line.interactive, "step by step (default at a terminal)");
  app.add_flag("--no-interactive", line.no_interactive, "straight through, no questions asked");
  app.add_option("--output", line.output, "folder of pages and pictures (default output/)")
      ->type_name("DIR")
      ->check(not_a_folder);
  add_choice(app, "--quality", line.quality, {"low", "medium", "high"},
             "854×480 at 15/s, 1280×720 at 30/s (default),\n1920×1080 at 60/s");
  add_choice(app, "--frames", line.frames, {"none", "last", "all"},
             "of each sequence; default all, at a terminal last");
  add_choice(app, "--film", line.film, {"webm", "mp4"}, "each sequence as a film too, by ffmpeg");
  app.add_option("--set", line.settings, "give a parameter another value; repeatable")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  app.add_flag("--list-parameters", line.list_parameters, "what can be set: unit, range, meaning");
  app.add_flag("--check", line.check, "no pictures, only the claims, as a table");
  app.add_flag("--questions", line.questions, "no pictures, only the predictions, as JSON");
  app.add_option("--step", line.step, "only this step, 3 or 3a; at a terminal from there")
      ->type_name("N")
      ->check(require_label);
  app.add_flag("--plain", line.plain,
               "at a terminal, for screen readers: pictures and tables\nin words, no box characters");
  app.add_flag("--quiet", line.quiet, "no text, no progress, only what is wrong");
  refuse_misshapen(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw HelpRequested{app.help()};
  } catch (const CLI::ParseError& bad) {
    throw std::invalid_argument(bad.what() + std::string(seek_help));
  }
  return line;
}

}  // namespace byhand::course
