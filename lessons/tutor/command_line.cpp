#include "lessons/tutor/command_line.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "lessons/tutor/options.hpp"

// The only source that includes CLI11, which takes seconds to compile.
namespace byhand::tutor {
namespace {

void add_choice(CLI::App& app, const std::string& name, std::string& value,
                const std::vector<std::string>& choices, const std::string& meaning) {
  app.add_option(name, value, meaning)
      ->type_name(CLI::detail::join(choices, "|"))
      ->check(CLI::IsMember(choices).description(""));
}

}  // namespace

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
  app.add_option("--output", line.output, "folder of pages and pictures (default output/)")->type_name("DIR");
  add_choice(app, "--quality", line.quality, {"low", "medium", "high"},
             "854×480 at 15/s, 1280×720 at 30/s (default),\n1920×1080 at 60/s");
  add_choice(app, "--frames", line.frames, {"none", "last", "all"},
             "of each sequence; default all, at a terminal last");
  app.add_option("--set", line.settings, "give a parameter another value; repeatable")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  app.add_flag("--list-parameters", line.list_parameters, "what can be set: unit, range, meaning");
  app.add_flag("--check", line.check, "no pictures, only the claims, as a table");
  app.add_option("--step", line.step, "only this step, 3 or 3a; at a terminal from there")->type_name("N");
  app.add_flag("--plain", line.plain,
               "at a terminal, for screen readers: pictures and tables\nin words, no box characters");
  app.add_flag("--quiet", line.quiet, "no text, no progress, only what is wrong");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw HelpRequested{app.help()};
  } catch (const CLI::ParseError& bad) {
    throw std::invalid_argument(std::string(bad.what()) + " (--help shows the options)");
  }
  return line;
}

}  // namespace byhand::tutor
