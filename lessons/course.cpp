// The menu of the course: lists the lessons with the reader's progress, builds and runs the chosen one. Started by
// `lessons/run`.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lessons/tutor/about.hpp"
#include "lessons/tutor/bookmark.hpp"
#include "lessons/tutor/dialogue.hpp"
#include "lessons/tutor/keyboard.hpp"
#include "lessons/tutor/options.hpp"
#include "lessons/tutor/screen.hpp"
#include "lessons/tutor/typeset.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand::tutor;
using Arguments = std::vector<std::string>;

constexpr auto usage = R"(./lessons/run [LESSON] [OPTIONS]

Without a lesson: the course at a terminal, every lesson straight through otherwise.

  LESSON        its number or name: ./lessons/run 3, ./lessons/run baumgarte
  --all         every lesson straight through; further options go to each
  --no-install  list the Debian packages that are missing and stop
  --help        this page; ./lessons/run LESSON --help shows the options of a lesson

Lessons:
)";

fs::path program(const std::string& slug) { return fs::read_symlink("/proc/self/exe").parent_path() / slug; }

/// Builds a target with the command in BYHAND_BUILD, if it is set, so that a reader waits for one lesson only.
/// Returns its exit status.
int build(const std::string& target) {
  const char* builder = std::getenv("BYHAND_BUILD");
  if (builder == nullptr) return 0;
  std::fflush(stdout);
  const int status = std::system(fmt::format("'{}' {}", builder, target).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 3;
}

/// Runs a lesson and returns its exit status. The lesson alone handles Ctrl-C meanwhile.
int run_lesson(const std::string& slug, Arguments arguments) {
  const std::string path = program(slug).string();
  arguments.insert(arguments.begin(), path);
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process could be started for " + slug);
  if (child == 0) {
    execv(path.c_str(), argv.data());
    fmt::print(stderr, "{} could not be started\n", path);
    _exit(3);
  }
  const auto former = std::signal(SIGINT, SIG_IGN);
  int status = 0;
  waitpid(child, &status, 0);
  std::signal(SIGINT, former);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int build_and_run(const std::string& slug, const Arguments& arguments) {
  if (const int failed = build(slug)) return failed;
  return run_lesson(slug, arguments);
}

std::string progress(const Bookmark& bookmark) {
  if (!bookmark.step.empty()) return fmt::format("at step {}", bookmark.step);
  return bookmark.finished ? "finished" : "";
}

std::string overview() {
  std::string lines;
  for (const About& lesson : contents()) {
    lines += fmt::format("  {}  {}\n", std::stoi(lesson.slug), lesson.title);
    lines += wrapped(lesson.summary, {}, 5);
  }
  return lines;
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
  return fmt::format("There is no lesson \"{}\"; there are {}.\n", called, names);
}

std::string output_of(const Arguments& arguments) {
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].starts_with("--output=")) return arguments[i].substr(9);
    if (arguments[i] == "--output" && i + 1 < arguments.size()) return arguments[i + 1];
  }
  return default_output().string();
}

int run_all(const std::vector<std::string>& slugs, Arguments arguments) {
  if (const int failed = build("lessons")) return failed;
  arguments.insert(arguments.begin(), "--no-interactive");
  int worst = 0;
  for (const std::string& slug : slugs) {
    const int status = run_lesson(slug, arguments);
    if (status != 0) fmt::print(stderr, "{} ended with status {}\n", slug, status);
    worst = std::max(worst, status);
  }
  if (std::find(arguments.begin(), arguments.end(), "--check") == arguments.end())
    fmt::print("\nAll pictures are in {}/LESSON/figures and frames, beside LESSON/lesson.md.\n",
               output_of(arguments));
  return worst;
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

int open_course(const std::vector<std::string>& slugs) {
  bool show_menu = true;
  while (true) {
    const auto next = next_lesson(slugs);
    std::optional<std::string> line;
    {
      // The lesson has a keyboard of its own.
      Keyboard keyboard;
      const Style style = Screen(keyboard, false).style();
      if (show_menu) fmt::print("\n{}\n\n{}", toned("Constraints by Hand", Tone::title, style), menu(style, next));
      const std::string go_on =
          next ? fmt::format("Enter goes on with lesson {}, a number chooses, q leaves.", std::stoi(*next))
               : "All lessons are finished: a number chooses one, q leaves.";
      fmt::print("\n{}", toned(wrapped(go_on, style), Tone::quiet, style));
      line = keyboard.line("▸ ");
    }
    if (!line) fmt::print("\n");
    if (!line || *line == "q" || *line == "quit") return 0;
    const auto chosen = line->empty() ? next : find_lesson(slugs, *line);
    show_menu = chosen.has_value();
    if (!chosen) {
      fmt::print("{}", line->empty() ? "Type the number of a lesson, or q.\n" : unknown(slugs, *line));
      continue;
    }
    const int status = build_and_run(*chosen, {});
    if (status == back_to_menu) continue;
    if (status != 0 || !read_bookmark(*chosen).step.empty()) return status;
  }
}

int run(Arguments arguments) {
  std::vector<std::string> slugs;
  for (const About& lesson : contents()) slugs.push_back(lesson.slug);
  const bool at_terminal = isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
  if (arguments.empty() && at_terminal) return open_course(slugs);
  if (!arguments.empty() && arguments.front() == "--help") {
    fmt::print("{}{}", usage, overview());
    return 0;
  }
  if (arguments.empty() || arguments.front().starts_with("--")) {
    const auto all = std::remove(arguments.begin(), arguments.end(), "--all");
    arguments.erase(all, arguments.end());
    return run_all(slugs, arguments);
  }
  const auto slug = find_lesson(slugs, arguments.front());
  if (!slug) {
    fmt::print(stderr, "{}", unknown(slugs, arguments.front()));
    return 2;
  }
  const int status = build_and_run(*slug, {arguments.begin() + 1, arguments.end()});
  return status == back_to_menu ? open_course(slugs) : status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
}
