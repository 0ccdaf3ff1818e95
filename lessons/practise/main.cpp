// Exercises in which the learner writes the code. Started by `lessons/run practise`.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "lessons/practise/desk.hpp"
#include "lessons/practise/judge/picture.hpp"
#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand::practise;

enum ExitStatus { right = 0, wrong = 1, bad_usage = 2, does_not_compile = 3, environment = 4 };

struct Wanted {
  int number = 0, hint = 0;
  std::uint64_t seed = 1;
  std::string folder = "my_exercises", check, film, unmask;
  bool solution = false, asked_unmask = false;
};

const Exercise& chosen(int number) {
  for (const Exercise& exercise : exercises())
    if (exercise.number() == number) return exercise;
  throw std::invalid_argument(
      fmt::format("There is no exercise {}; there are 1 to {}", number, exercises().size()));
}

void refuse_output(const fs::path& folder) {
  for (const fs::path& part : fs::absolute(folder))
    if (part == "output")
      throw std::invalid_argument(fmt::format(
          "{} lies inside output/, which lessons overwrite; choose another --folder", folder.string()));
}

int check_file(const Exercise& exercise, const Wanted& wanted) {
  if (!fs::is_regular_file(wanted.check))
    throw std::invalid_argument(fmt::format("{} is not a file", wanted.check));
  const Key answers = key(exercise, wanted.seed);
  const Verdict verdict = check(exercise, answers, wanted.check);
  fmt::print("{}", verdict_text(verdict));
  if (verdict.is_right()) note_solved(exercise);
  if (!wanted.film.empty() && !verdict.film.frames.empty()) {
    write_film(wanted.film, verdict.film, answers.film);
    byhand::renderer::write_whole(wanted.film + ".png", still_png(verdict.film, answers.film));
    fmt::print("Film: {}/0000.png …, and {}.png\n", wanted.film, wanted.film);
  }
  if (verdict.kind == Verdict::Kind::does_not_compile) return does_not_compile;
  return verdict.is_right() ? right : wrong;
}

int run(const Wanted& wanted) {
  if (wanted.number == 0) {
    fmt::print("Exercises: ./lessons/run practise N\n{}", overview());
    return right;
  }
  const Exercise& exercise = chosen(wanted.number);
  if (wanted.hint != 0) {
    fmt::print("{}", hint_text(exercise, wanted.hint));
  } else if (wanted.solution) {
    fmt::print("{}", solution_text(exercise));
  } else if (!wanted.unmask.empty()) {
    std::string report;
    const bool unmasked = unmask(exercise, wanted.unmask, report);
    fmt::print("{}", report);
    return unmasked ? right : wrong;
  } else if (wanted.asked_unmask) {
    fmt::print("{}", unmask_text(exercise));
  } else if (!wanted.check.empty()) {
    return check_file(exercise, wanted);
  } else {
    refuse_output(wanted.folder);
    const fs::path file = learners_file(exercise, wanted.folder);
    if (isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)) return watch(exercise, key(exercise, wanted.seed), file);
    fmt::print("{}\nEdit {}, then: ./lessons/run practise {} --check {}\n", task_text(exercise), file.string(),
               wanted.number, file.string());
  }
  return right;
}

}  // namespace

int main(int argc, char** argv) {
  Wanted wanted;
  CLI::App app("Exercises in which you write the code", "./lessons/run practise");
  app.set_help_flag("--help", "this page");
  app.add_option("N", wanted.number, "number of an exercise; without it, the list");
  app.add_option("--folder", wanted.folder,
                 "your folder (default my_exercises/); files in it are never overwritten");
  app.add_option("--check", wanted.check,
                 "judge this file once: exit status 0 right, 1 wrong, 2 bad usage,\n"
                 "3 does not compile, 4 an error of the environment")
      ->type_name("FILE");
  app.add_option("--film", wanted.film, "with --check: folder for the film of what the code does")
      ->type_name("DIR");
  app.add_option("--seed", wanted.seed, "of the random probes (default 1)");
  app.add_option("--hint", wanted.hint, "hint 1, 2 or 3");
  app.add_flag("--solution", wanted.solution, "the solution and its derivation");
  auto* unmask = app.add_option("--unmask", wanted.unmask, "choose numbers on which a wrong code is wrong")
                     ->expected(0, 1)
                     ->type_name("NUMBERS");
  try {
    app.parse(argc, argv);
    wanted.asked_unmask = unmask->count() > 0;
    if (wanted.number == 0 && argc > 1)
      throw std::invalid_argument("Name the exercise: ./lessons/run practise 2 …");
    const int status = run(wanted);
    return std::fflush(stdout) == 0 ? status : environment;
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return right;
  } catch (const CLI::ParseError& bad) {
    fmt::print(stderr, "{} (--help shows the options)\n", bad.what());
    return bad_usage;
  } catch (const std::invalid_argument& bad) {
    fmt::print(stderr, "{}.\n", bad.what());
    return bad_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return environment;
  }
}
