#include "lessons/practise/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/bookmark.hpp"
#include "lessons/practise/handout.hpp"
#include "lessons/practise/judge/comparison.hpp"
#include "lessons/terminal/keyboard.hpp"
#include "lessons/terminal/typeset.hpp"
#include "renderer/error.hpp"

namespace byhand::practise {
namespace {

namespace fs = std::filesystem;
using namespace byhand::course;

const std::string requested = "requested";

std::string slug(const Exercise& exercise) { return "practise_" + exercise.name; }

Style style() {
  return {.width = 100, .colours = isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr};
}

std::string signature(const Exercise& exercise) {
  const std::string text = contents_of(exercise.folder() / "signature.hpp");
  const auto begin = text.find("#include \"practise.hpp\"\n") + 24;
  const auto end = text.find("#define FUNCTIONS");
  return text.substr(begin + 1, end - begin - 2);
}

/// Sources are at most 115 columns wide.
std::string code(const std::string& text) { return folded(text, {.width = 120}, 2); }

/// Statements are drawings too, so their lines stay; those that begin at the margin are wrapped.
std::string laid_out(const std::string& text) {
  std::string all, line;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    line = text.substr(at, end - at);
    at = end + 1;
    all += line.empty() || line.front() == ' ' ? line + "\n" : wrapped(line, style());
  }
  return all;
}

std::string command(const Exercise& exercise) {
  return fmt::format("./lessons/run practise {}", exercise.number());
}

/// Changes when the file is saved, also by an editor that replaces it.
std::pair<fs::file_time_type, std::uintmax_t> state(const fs::path& file) {
  std::error_code missing;
  return {fs::last_write_time(file, missing), fs::file_size(file, missing)};
}

void save_picture(const fs::path& file, const Verdict& verdict, const Key& key) {
  if (verdict.film.frames.empty()) return;
  const fs::path picture = fs::path(file).replace_extension(".png");
  try {
    course::write_whole(picture, still_png(verdict.film, key.film));
    fmt::print("{}", toned(fmt::format("Picture: {}\n", picture.string()), Tone::quiet, style()));
  } catch (const renderer::Unavailable& none) {
    fmt::print("No picture: {}\n", none.what());
  }
}

void judge_file(const Exercise& exercise, const Key& key, const fs::path& file) {
  const Verdict verdict = check(exercise, key, file);
  fmt::print("\n{}", verdict_text(verdict));
  std::fflush(stdout);
  save_picture(file, verdict, key);
  if (verdict.is_right()) {
    note_solved(exercise);
    fmt::print("\n{}\nNext: {} --unmask\n", solution_text(exercise), command(exercise));
  }
}

}  // namespace

std::string overview() {
  std::vector<std::vector<std::string>> rows;
  for (const Exercise& exercise : exercises()) {
    const Task about = task(exercise);
    const Bookmark kept = read_bookmark(slug(exercise));
    rows.push_back(
        {std::to_string(exercise.number()), about.title, "lesson " + about.lesson,
         (kept.finished ? "solved" : "") + std::string(kept.step == requested ? " (solution requested)" : "")});
  }
  return table(rows, 2);
}

std::string task_text(const Exercise& exercise) {
  const Task about = task(exercise);
  return toned(fmt::format("{}  {}", exercise.number(), about.title), Tone::title, style()) +
         fmt::format("   lesson {}, equations {}\n\n{}\n{}", about.lesson, about.equations,
                     laid_out(about.statement), toned(code(signature(exercise)), Tone::code, style())) +
         "\n" + given_types() + "The equations it rests on:\n" + equations_of(exercise);
}

std::string verdict_text(const Verdict& verdict) {
  std::string text =
      wrapped(toned(verdict.sentence, verdict.is_right() ? Tone::good : Tone::bad, style()), style());
  if (!verdict.details.empty()) text += verdict.details;
  if (!verdict.printed.empty())
    text += "Your code printed:\n" + folded(verdict.printed.substr(0, 2000), style(), 2);
  if (text.back() != '\n') text += "\n";
  return text;
}

std::string hint_text(const Exercise& exercise, int degree) {
  const auto hints = task(exercise).hints;
  if (degree < 1 || degree > static_cast<int>(hints.size()))
    throw std::invalid_argument(fmt::format("There is no hint {}; there are 1 to {}", degree, hints.size()));
  return wrapped(
      fmt::format("Hint {} of {}: {}", degree, hints.size(), hints[static_cast<std::size_t>(degree - 1)]),
      style());
}

std::string solution_text(const Exercise& exercise) {
  Bookmark kept = read_bookmark(slug(exercise));
  std::string note;
  if (!kept.finished) {
    kept.step = requested;
    save_bookmark(slug(exercise), kept);
    note = "\nThis solution was requested before the exercise was solved; the list of exercises says so.\n";
  }
  return toned("A solution\n", Tone::title, style()) + code(contents_of(exercise.folder() / "solution.cpp")) +
         toned("\nIts derivation\n", Tone::title, style()) + wrapped(task(exercise).derivation, style()) + note;
}

void note_solved(const Exercise& exercise) {
  Bookmark kept = read_bookmark(slug(exercise));
  kept.finished = true;
  save_bookmark(slug(exercise), kept);
}

fs::path learners_file(const Exercise& exercise, const fs::path& folder) {
  const fs::path file = folder / (exercise.name + ".cpp");
  if (!fs::exists(file)) course::write_whole(file, contents_of(exercise.folder() / "stub.cpp"));
  return file;
}

int watch(const Exercise& exercise, const Key& key, const fs::path& file) {
  fmt::print("{}\nEdit {} and save: each save is judged. h hint, s solution, t task, q or Ctrl-C ends.\n",
             task_text(exercise), file.string());
  Keyboard keyboard;
  int hints = 0;
  auto judged = state({});
  while (true) {
    if (auto now = state(file); now != judged && now.second > 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      if (now != state(file)) continue;  // an editor is still writing
      judged = now;
      judge_file(exercise, key, file);
      std::fflush(stdout);
    }
    const course::Key pressed = keyboard.key_within(100);
    if (pressed == course::Key::none) continue;
    const auto line = pressed == course::Key::other ? keyboard.line("▸ ") : std::optional<std::string>("");
    if (pressed == course::Key::ended || !line || *line == "q") break;
    if (*line == "h")
      fmt::print("{}", hint_text(exercise, hints = std::min(hints + 1, 3)));
    else if (*line == "s")
      fmt::print("{}", solution_text(exercise));
    else if (*line == "t")
      fmt::print("{}", task_text(exercise));
    else
      fmt::print("h hint, s solution, t task, q or Ctrl-C ends.\n");
    std::fflush(stdout);
  }
  fmt::print("\n{} goes on with {}.\n", command(exercise), file.string());
  return 0;
}

std::string unmask_text(const Exercise& exercise) {
  return fmt::format(
      "This code is wrong, and it passes this test:\n\n  {}\n\n{}\n"
      "Give numbers on which it is wrong; those that you leave out stay as above:\n"
      "  {} --unmask \"NAME=NUMBER NAME=NUMBER,NUMBER\"\n",
      blind_test(exercise), code(masked_code(exercise)), command(exercise));
}

}  // namespace byhand::practise
