// The menu of the course: lists the lessons with the reader's progress, builds and runs the chosen one. Started by
// `lessons/run`.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "lessons/files/bookmark.hpp"
#include "lessons/files/child_process.hpp"
#include "lessons/files/command_line.hpp"
#include "lessons/files/options.hpp"
#include "lessons/files/output_folder.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/about.hpp"
#include "lessons/terminal/dialogue.hpp"
#include "lessons/terminal/keyboard.hpp"
#include "lessons/terminal/screen.hpp"
#include "lessons/terminal/typeset.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand::course;
using Arguments = std::vector<std::string>;

fs::path program(const std::string& slug) { return fs::read_symlink("/proc/self/exe").parent_path() / slug; }

/// Builds a target with the command in BYHAND_BUILD, if it is set, so that a reader waits for one lesson only.
Ended build(const std::string& target) {
  const char* builder = std::getenv("BYHAND_BUILD");
  return builder == nullptr ? Ended{} : run_program(builder, {target}, Group::own);
}

/// Builds the lessons from `first` on, one after another, while the reader reads.
std::unique_ptr<Beside> build_behind(const std::vector<std::string>& slugs, const std::string& first) {
  const char* builder = std::getenv("BYHAND_BUILD");
  if (builder == nullptr) return nullptr;
  Arguments arguments{"--behind"};
  arguments.insert(arguments.end(), std::find(slugs.begin(), slugs.end(), first), slugs.end());
  return std::make_unique<Beside>(builder, arguments);
}

Ended run_lesson(const std::string& slug, const Arguments& arguments) {
  const fs::path path = program(slug);
  if (!fs::exists(path))
    throw std::runtime_error(fmt::format("{} is not built yet: ./lessons/run {} builds it.", slug,
                                         std::isdigit(slug.front()) ? std::to_string(std::stoi(slug)) : slug));
  const Ended ended = run_program(path.string(), arguments, Group::ours);
  if (ended.by_signal && !ended.passed_on)
    complain(
        fmt::format("{} was ended by signal {} ({}).\n", slug, ended.status - 128, strsignal(ended.status - 128)));
  return ended;
}

Ended build_and_run(const std::string& slug, const Arguments& arguments) {
  const Ended built = build(slug);
  return built.well() ? run_lesson(slug, arguments) : built;
}

/// The same for a reader at a terminal.
Ended build_and_read(const std::vector<std::string>& slugs, const std::string& slug, const Arguments& arguments) {
  const Ended built = build(slug);
  if (!built.well()) return built;
  const auto behind = build_behind(slugs, slug);
  return run_lesson(slug, arguments);
}

/// The exit status of the course after this; after a signal that ended the program, ends by it too.
int status_of(const Ended& ended) {
  if (ended.by_signal && ended.passed_on) end_by(ended.passed_on);
  return ended.status;
}

std::string progress(const Bookmark& bookmark) {
  if (!bookmark.step.empty()) return fmt::format("at step {}", bookmark.step);
  return bookmark.finished ? "finished" : "";
}

/// A line for each lesson, so that the menu fits on a screen of 24 rows.
std::string menu(const Style& style, const std::optional<std::string>& next) {
  std::vector<std::vector<std::string>> rows;
  std::string summary;
  for (const About& lesson : contents()) {
    rows.push_back({std::to_string(std::stoi(lesson.slug)), lesson.title, progress(read_bookmark(lesson.slug))});
    if (next == lesson.slug) summary = fmt::format("\nLesson {}: {}", std::stoi(lesson.slug), lesson.summary);
  }
  return table(rows, style, 2) + (summary.empty() ? "" : wrapped(summary, style));
}

/// The lesson with this number or name, or the only one whose name contains `called`.
std::optional<std::string> find_lesson(const std::vector<std::string>& slugs, const std::string& called) {
  std::vector<std::string> like;
  for (const std::string& slug : slugs) {
    if (called == slug || called == slug.substr(3) || called == slug.substr(0, 2) ||
        called == std::to_string(std::stoi(slug)))
      return slug;
    if (!called.empty() && slug.find(called, 3) != std::string::npos) like.push_back(slug);
  }
  return like.size() == 1 ? std::optional(like.front()) : std::nullopt;
}

std::string unknown(const std::vector<std::string>& slugs, const std::string& called) {
  std::string names;
  for (const std::string& slug : slugs)
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", std::stoi(slug), slug.substr(3));
  return fmt::format("There is no lesson \"{}\"; there are {}.", shortened(called), names);
}

std::string output_of(const Arguments& arguments) {
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].starts_with("--output=")) return arguments[i].substr(9);
    if (arguments[i] == "--output" && i + 1 < arguments.size()) return arguments[i + 1];
  }
  return default_output().string();
}

bool has(const Arguments& arguments, const std::string& option) {
  return std::find(arguments.begin(), arguments.end(), option) != arguments.end();
}

/// What came of the lessons of a run with --all.
struct Outcome {
  std::vector<std::string> failed;  // "05_contact (status 1)"
  size_t run = 0, of = 0;
  std::string sentence() const {
    return fmt::format("{} of {} lessons ended well{}{}.\n", run - failed.size(), of,
                       failed.empty() ? "" : fmt::format("; not {}", fmt::join(failed, ", ")),
                       run < of ? fmt::format("; {} were not run", of - run) : "");
  }
};

/// A false claim or a crash is the lesson's own; any other failure would be that of the next lessons too.
bool concerns_all(const Ended& ended) {
  constexpr int false_claim = 1;
  return !ended.well() && ended.status != false_claim && (!ended.by_signal || ended.passed_on);
}

int run_all(const std::vector<std::string>& slugs, Arguments arguments) {
  if (const Ended built = build("lessons"); !built.well()) return status_of(built);
  const bool draws = !has(arguments, "--check") && !has(arguments, "--quiet") &&
                     !has(arguments, "--list-parameters") && !has(arguments, "--help");
  arguments.insert(arguments.begin(), "--no-interactive");
  Outcome outcome{{}, 0, slugs.size()};
  Ended worst;
  for (const std::string& slug : slugs) {
    const Ended ended = run_lesson(slug, arguments);
    ++outcome.run;
    if (!ended.well()) outcome.failed.push_back(fmt::format("{} (status {})", slug, ended.status));
    if (ended.status > worst.status) worst = ended;
    worst.passed_on = ended.passed_on;
    if (concerns_all(ended) || ended.passed_on) break;
  }
  constexpr int bad_usage = 2;
  const bool refused_at_once = outcome.run == 1 && worst.status == bad_usage;
  if (!worst.well() || outcome.run < outcome.of) {
    if (!refused_at_once) complain(outcome.sentence());
  } else if (draws) {
    fmt::print("\nAll pictures are in {}/LESSON/figures and frames, beside LESSON/lesson.md.\n",
               printable(output_of(arguments)));
  }
  return status_of(worst);
}

constexpr auto verify_help =
    "./lessons/run verify [FOLDER]\n\n"
    "Holds every lesson and the site in FOLDER (default output/), or the one that FOLDER is, against its "
    "manifest: each\n"
    "file that it lists is there with its SHA-256, and a lesson has no others.\n\n"
    "Exit status: 0 all files are as they were written, 1 some are not, 2 bad usage, 3 the environment.\n";

/// What is wrong with a folder; the sentence of an error is a difference too, so that the other folders are
/// judged.
std::vector<std::string> readable_differences(const fs::path& folder, int& files) {
  try {
    return differences(folder, files);
  } catch (const fs::filesystem_error& error) {
    return {"cannot be read: " + error.code().message()};
  }
}

/// Holds the folders in `output` that lessons and the site wrote against their manifests.
int verify(const fs::path& output) {
  std::error_code error;
  if (!fs::is_directory(output, error))
    throw std::invalid_argument(fmt::format(
        "verify {}: {}", shortened(output.string()),
        !error || error == std::errc::no_such_file_or_directory ? "there is no such folder" : error.message()));
  std::vector<fs::path> folders;
  if (!fs::exists(fs::symlink_status(output / "manifest.json", error)))
    for (const auto& entry : fs::directory_iterator(output))
      if (is_written_folder(entry.path())) folders.push_back(entry.path());
  if (folders.empty() && is_written_folder(output)) folders.push_back(output);
  if (folders.empty())
    throw std::invalid_argument(fmt::format("verify {}: there is no lesson in this folder", output.string()));
  std::sort(folders.begin(), folders.end());
  bool well = true;
  for (const fs::path& folder : folders) {
    int files = 0;
    const std::vector<std::string> wrong = readable_differences(folder, files);
    for (const std::string& line : wrong) fmt::print("{}\n", printable((folder / line).string()));
    if (wrong.empty()) fmt::print("{}: {} files as they were written\n", printable(folder.string()), files);
    well = well && wrong.empty();
  }
  return well ? 0 : 1;
}

int verify(const Arguments& typed) {
  if (has(typed, "--help")) return fmt::print("{}", verify_help), 0;
  if (typed.size() > 1)
    throw std::invalid_argument(fmt::format("verify takes one folder, but \"{}\" follows", shortened(typed[1])));
  if (typed.empty()) return verify(default_output());
  if (const std::string refusal = not_a_folder(typed.front()); !refusal.empty())
    throw std::invalid_argument("verify: " + refusal);
  return verify(fs::path(typed.front()));
}

/// The first lesson that is begun but not ended, else the first that is not finished.
std::optional<std::string> next_lesson(const std::vector<std::string>& slugs) {
  const auto begun =
      std::find_if(slugs.begin(), slugs.end(), [](const auto& slug) { return !read_bookmark(slug).step.empty(); });
  if (begun != slugs.end()) return *begun;
  const auto open =
      std::find_if(slugs.begin(), slugs.end(), [](const auto& slug) { return !read_bookmark(slug).finished; });
  return open == slugs.end() ? std::nullopt : std::optional(*open);
}

/// The options that a reader wants in every lesson, and not in one: how it looks and where it draws.
Arguments for_every_lesson(const Arguments& arguments) {
  Arguments kept;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string name = arguments[i].substr(0, arguments[i].find('='));
    const bool valued = name == "--output" || name == "--quality" || name == "--frames" || name == "--film";
    if (!valued && arguments[i] != "--plain") continue;
    kept.push_back(arguments[i]);
    if (valued && name == arguments[i] && i + 1 < arguments.size()) kept.push_back(arguments[++i]);
  }
  return kept;
}

/// Whether these options are meant for the lessons of a reader. Refuses them as a lesson would.
bool are_for_every_lesson(const Arguments& arguments) {
  if (for_every_lesson(arguments) != arguments) return false;
  std::vector<const char*> words = {"course"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  parse_command_line("", "./lessons/run", "", static_cast<int>(words.size()), words.data());
  return true;
}

/// `options` go to every lesson that is chosen.
int open_course(const std::vector<std::string>& slugs, const Arguments& options) {
  bool show_menu = true;
  while (true) {
    const auto next = next_lesson(slugs);
    const auto behind = build_behind(slugs, next.value_or(slugs.front()));
    std::optional<std::string> line;
    {
      // The lesson has a keyboard of its own.
      Keyboard keyboard;
      const Style style = Screen(keyboard, has(options, "--plain")).style();
      if (show_menu) fmt::print("\n{}\n\n{}", toned("Constraints by Hand", Tone::title, style), menu(style, next));
      const std::string go_on =
          next ? fmt::format("Enter goes on with lesson {}, a number chooses, q leaves.", std::stoi(*next))
               : "All lessons are finished: a number chooses one, q leaves.";
      fmt::print("\n{}", toned(wrapped(go_on, style), Tone::quiet, style));
      line = keyboard.line(style.plain ? "> " : "▸ ");
    }
    if (!line) fmt::print("\n");
    if (!line || *line == "q" || *line == "quit") return 0;
    const auto chosen = line->empty() ? next : find_lesson(slugs, *line);
    show_menu = chosen.has_value();
    if (!chosen) {
      fmt::print("{}",
                 line->empty() ? "Type the number of a lesson, or q.\n" : printable(unknown(slugs, *line)) + "\n");
      continue;
    }
    const Ended ended = build_and_read(slugs, *chosen, options);
    if (ended.status == back_to_menu && !ended.by_signal) continue;
    if (!ended.well() || ended.passed_on || !read_bookmark(*chosen).step.empty()) return status_of(ended);
  }
}

int run(Arguments arguments) {
  std::vector<std::string> slugs;
  for (const About& lesson : contents()) slugs.push_back(lesson.slug);
  const bool at_terminal = isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
  if (at_terminal && are_for_every_lesson(arguments)) return open_course(slugs, arguments);
  if (!arguments.empty() && arguments.front() == "verify")
    return verify(Arguments(arguments.begin() + 1, arguments.end()));
  if (arguments.empty() || arguments.front().starts_with("--")) {
    std::erase(arguments, "--all");
    return run_all(slugs, arguments);
  }
  if (arguments.front() == "symptoms") {
    arguments.front() = "--step=7";
    arguments.insert(arguments.begin(), "04_baumgarte");
  }
  for (const char* program : {"practise", "desk", "site", "scene", "case"})
    if (arguments.front() == program)
      return status_of(build_and_run(program, {arguments.begin() + 1, arguments.end()}));
  const auto slug = find_lesson(slugs, arguments.front());
  if (!slug) throw std::invalid_argument(unknown(slugs, arguments.front()));
  arguments.erase(arguments.begin());
  const Ended ended =
      at_terminal && arguments.empty() ? build_and_read(slugs, *slug, {}) : build_and_run(*slug, arguments);
  return ended.status == back_to_menu && !ended.by_signal ? open_course(slugs, for_every_lesson(arguments))
                                                          : status_of(ended);
}

}  // namespace

int main(int argc, char** argv) {
  return exit_status_of([&] { return run({argv + 1, argv + argc}); });
}
