#include "lessons/tutor/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "lessons/tutor/lesson.hpp"

namespace byhand::tutor {
namespace {

const std::array<Quality, 3> qualities = {
    {{"low", 854, 480, 15}, {"medium", 1280, 720, 30}, {"high", 1920, 1080, 60}}};

std::pair<std::string, std::string> split_setting(const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0)
    throw std::invalid_argument(fmt::format("--set {}: write NAME=VALUE, for example --set h=1/120", setting));
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

std::string teach(const Lesson& lesson) {
  std::string words =
      "At a terminal the lesson goes step by step. Type a prediction when it asks for one, and\n"
      "  Enter goes on    b goes back      d goes deeper    h hints    s shows the answer\n"
      "  beta 0.5, h 1/120  change a parameter: the step runs again, old and new side by side\n"
      "  r reads the step again    ? helps    q leaves and remembers where\n\n"
      "Parameters of this lesson:\n";
  for (const ParameterRecord& p : lesson.parameters()) words += fmt::format("  {}\n", p.described(p.initial));
  words += fmt::format(
      "\nExamples:\n"
      "  ./lessons/run {0}                   read it\n"
      "  ./lessons/run {0} --check           are all its numbers true?\n"
      "  ./lessons/run {0} --quality high    pictures for a talk, in output/{1}/\n",
      lesson.number(), lesson.about().slug);
  if (!lesson.parameters().empty())
    words += fmt::format("  ./lessons/run {} --set {}={}    with a parameter of your own\n", lesson.number(),
                         lesson.parameters().front().name,
                         lesson.parameters().front().typed(lesson.parameters().front().initial));
  return words +
         "\nExit status: 0 fine, 1 a claim is false, 2 bad usage or value, 3 the environment (no OpenGL,\n"
         "disk full, folder not writable).";
}

void add_choice(CLI::App& app, const std::string& name, std::string& value,
                const std::vector<std::string>& choices, const std::string& meaning) {
  app.add_option(name, value, meaning)
      ->type_name(fmt::format("{}", fmt::join(choices, "|")))
      ->check(CLI::IsMember(choices).description(""));
}

void require_step(const Lesson& lesson, const std::string& label) {
  std::string labels;
  for (const Step& step : lesson.steps()) {
    if (step.label == label) return;
    labels += (labels.empty() ? "" : ", ") + step.label;
  }
  throw std::invalid_argument(fmt::format("--step {}: this lesson has the steps {}", label, labels));
}

}  // namespace

std::string_view to_string(FramesWanted frames) {
  constexpr std::array<std::string_view, 3> names = {"none", "last", "all"};
  return names[static_cast<size_t>(frames)];
}

std::filesystem::path default_output() {
  const std::filesystem::path folder = std::filesystem::path(BYHAND_SOURCE_DIR) / "output";
  const std::filesystem::path nearby = std::filesystem::proximate(folder);
  return *nearby.begin() == ".." ? folder : nearby;
}

Options read_options(const Lesson& lesson, int argc, const char* const* argv, bool at_terminal) {
  Options options;
  options.output = default_output();
  std::string quality = "medium", frames;
  std::vector<std::string> settings;

  CLI::App app(fmt::format("{}. {}\n{}", lesson.number(), lesson.about().title, lesson.about().summary),
               fmt::format("./lessons/run {}", lesson.number()));
  app.footer(teach(lesson));
  app.get_formatter()->column_width(30);
  app.set_help_flag("--help", "this page");
  bool step_by_step = false, straight = false;
  app.add_flag("--interactive", step_by_step, "step by step (default at a terminal)");
  app.add_flag("--no-interactive", straight, "straight through, no questions asked");
  app.add_option("--output", options.output, "folder of pages and pictures (default output/)")->type_name("DIR");
  add_choice(app, "--quality", quality, {"low", "medium", "high"},
             "854×480 at 15/s, 1280×720 at 30/s (default),\n1920×1080 at 60/s");
  add_choice(app, "--frames", frames, {"none", "last", "all"},
             "of each sequence; default all, at a terminal last");
  app.add_option("--set", settings, "give a parameter another value; repeatable")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  app.add_flag("--list-parameters", options.list_parameters, "what can be set: unit, range, meaning");
  app.add_flag("--check", options.check, "no pictures, only the claims, as a table");
  app.add_option("--step", options.step, "only this step, 3 or 3a; at a terminal from there")->type_name("N");
  app.add_flag("--quiet", options.quiet, "no text, no progress, only what is wrong");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw HelpRequested{app.help()};
  } catch (const CLI::ParseError& bad) {
    throw std::invalid_argument(fmt::format("{} (--help shows the options)", bad.what()));
  }

  if (step_by_step && straight)
    throw std::invalid_argument("--interactive and --no-interactive: choose one of them");
  options.interactive = step_by_step || (at_terminal && !straight);
  if (options.check || options.quiet) options.interactive = false;
  options.quality =
      *std::find_if(qualities.begin(), qualities.end(), [&](const Quality& q) { return q.name == quality; });
  if (frames.empty()) frames = options.interactive ? "last" : "all";
  options.frames = frames == "none"   ? FramesWanted::none
                   : frames == "last" ? FramesWanted::last
                                      : FramesWanted::all;
  for (const std::string& setting : settings) options.set.push_back(split_setting(setting));
  if (!options.step.empty()) require_step(lesson, options.step);
  return options;
}

}  // namespace byhand::tutor
