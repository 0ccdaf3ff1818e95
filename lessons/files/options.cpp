#include "lessons/files/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>

#include "lessons/files/command_line.hpp"
#include "lessons/page/lesson.hpp"

namespace byhand::course {
namespace {

const std::array<Quality, 3> qualities = {
    {{"low", 854, 480, 15}, {"medium", 1280, 720, 30}, {"high", 1920, 1080, 60}}};

std::pair<std::string, std::string> split_setting(const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0)
    throw std::invalid_argument(fmt::format("--set {}: write NAME=VALUE, for example --set h=1/120", setting));
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

std::string usage(const Lesson& lesson) {
  std::string words =
      "At a terminal the lesson goes step by step. Type a prediction when it asks for one, and\n"
      "Enter to go on. hint, show, why, deeper, back, again, open, set, menu and quit do what they say; ? lists\n"
      "them all. `beta 0.5` or `h 1/120` changes a parameter: the step runs again, old and new side by side.\n\n"
      "Parameters of this lesson:\n";
  for (const ParameterRecord& p : lesson.parameters()) words += fmt::format("  {}\n", p.described(p.initial));
  words += fmt::format(
      "\nExamples:\n"
      "  ./lessons/run {0}                   read it\n"
      "  ./lessons/run {0} --check           are all its numbers true?\n"
      "  ./lessons/run {0} --quality high    pictures for a talk, in output/{1}/\n",
      lesson.number(), lesson.about().slug);
  if (!lesson.parameters().empty())
    words += fmt::format("  ./lessons/run {} --set {}={}    with your own value instead (this is the default)\n",
                         lesson.number(), lesson.parameters().front().name,
                         lesson.parameters().front().typed(lesson.parameters().front().initial));
  return words +
         "\nExit status: 0 fine, 1 a claim is false, 2 bad usage or value, 3 the environment (no OpenGL,\n"
         "disk full, folder not writable).";
}

void require_step(const Lesson& lesson, const std::string& label) {
  std::string labels;
  for (const Step& step : lesson.steps()) {
    if (step.label == label) return;
    labels += (labels.empty() ? "" : ", ") + step.label;
  }
  throw std::invalid_argument(fmt::format("--step {}: this lesson has the steps {}", label, labels));
}

void refuse_contradictions(const CommandLine& line) {
  const auto both = [](bool one, bool other, const char* names) {
    if (one && other) throw std::invalid_argument(fmt::format("{}: choose one of them", names));
  };
  both(line.interactive, line.no_interactive, "--interactive and --no-interactive");
  both(line.interactive, line.check, "--interactive and --check");
  both(line.interactive, line.quiet, "--interactive and --quiet");
  both(line.interactive, line.list_parameters, "--interactive and --list-parameters");
  both(line.interactive, line.questions, "--interactive and --questions");
  both(line.check, line.list_parameters, "--check and --list-parameters");
  both(line.check, line.questions, "--check and --questions");
  both(line.questions, line.list_parameters, "--questions and --list-parameters");
  if (!line.film.empty() && !line.frames.empty() && line.frames != "all")
    throw std::invalid_argument(fmt::format("--film needs all frames, not --frames {}", line.frames));
}

}  // namespace

std::string_view to_string(FramesWanted frames) {
  constexpr std::array<std::string_view, 3> names = {"none", "last", "all"};
  return names[static_cast<size_t>(frames)];
}

std::filesystem::path default_output() {
  const std::filesystem::path folder = std::filesystem::path(BYHAND_SOURCE_DIR) / "output";
  std::error_code removed;  // the current folder
  const std::filesystem::path here = std::filesystem::current_path(removed);
  const std::filesystem::path nearby = std::filesystem::proximate(folder, here, removed);
  return removed || *nearby.begin() == ".." ? folder : nearby;
}

Options read_options(const Lesson& lesson, int argc, const char* const* argv, bool at_terminal) {
  CommandLine line =
      parse_command_line(fmt::format("{}. {}\n{}", lesson.number(), lesson.about().title, lesson.about().summary),
                         fmt::format("./lessons/run {}", lesson.number()), usage(lesson), argc, argv);
  refuse_contradictions(line);
  Options options;
  options.output = line.output;
  options.list_parameters = line.list_parameters;
  options.check = line.check;
  options.quiet = line.quiet;
  options.questions = line.questions;
  options.plain = line.plain;
  options.step = line.step;
  options.interactive = line.interactive || (at_terminal && !line.no_interactive);
  if (options.check || options.quiet || options.questions) options.interactive = false;
  options.quality =
      *std::find_if(qualities.begin(), qualities.end(), [&](const Quality& q) { return q.name == line.quality; });
  if (line.frames.empty()) line.frames = options.interactive && line.film.empty() ? "last" : "all";
  options.film = line.film;
  options.frames = line.frames == "none"   ? FramesWanted::none
                   : line.frames == "last" ? FramesWanted::last
                                           : FramesWanted::all;
  for (const std::string& setting : line.settings) {
    options.set.push_back(split_setting(setting));
    const std::string& name = options.set.back().first;
    if (std::any_of(options.set.begin(), options.set.end() - 1,
                    [&](const auto& set) { return set.first == name; }))
      throw std::invalid_argument(
          fmt::format("--set {}: {} is set twice, and can have one value only", setting, name));
  }
  if (!options.step.empty()) require_step(lesson, options.step);
  return options;
}

}  // namespace byhand::course
