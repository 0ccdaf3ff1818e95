// Exercises in which the learner writes the code. Started by `lessons/run practise`.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/error.hpp"
#include "lessons/practise/export_course.hpp"
#include "lessons/practise/handout.hpp"
#include "lessons/practise/judge/comparison.hpp"
#include "lessons/practise/watch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand::practise;
namespace course = byhand::course;

enum ExitStatus { right = 0, wrong = 1, does_not_compile = 3, environment = 4 };

struct Wanted {
  int number = 0, hint = 0;
  std::optional<std::uint64_t> seed;
  std::string folder = "my_exercises", check, film, unmask, grade, course, to, asked_in;
  std::vector<std::string> reports;
  bool solution = false, unconfined = false;
  std::string asked;  // which of the options that exclude each other was given: "--check"
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
  std::error_code error;
  if (!fs::is_regular_file(wanted.check, error))
    throw std::invalid_argument(fmt::format("{} is not a file", wanted.check));
  const Key answers = key(exercise, wanted.seed.value_or(1));
  const Verdict verdict = check(exercise, answers, wanted.check);
  fmt::print("{}", verdict_text(verdict));
  if (verdict.is_right()) note_solved(exercise);
  if (!wanted.film.empty() && !verdict.film.frames.empty()) {
    write_film(wanted.film, verdict.film, answers.film);
    course::write_whole(wanted.film + ".png", still_png(verdict.film, answers.film));
    fmt::print("Film: {}/0000.png …, and {}.png\n", wanted.film, wanted.film);
  }
  if (verdict.kind == Verdict::Kind::does_not_compile) return does_not_compile;
  return verdict.is_right() ? right : wrong;
}

std::vector<const Exercise*> all_or(int number) {
  std::vector<const Exercise*> wanted;
  for (const Exercise& exercise : exercises())
    if (number == 0 || exercise.number() == number) wanted.push_back(&exercise);
  if (wanted.empty()) wanted.push_back(&chosen(number));
  return wanted;
}

int grade_folder(const Wanted& wanted) {
  std::vector<Report> reports;
  for (const std::string& words : wanted.reports) reports.push_back(parse_report(words));
  if (reports.empty()) reports.push_back(parse_report("summary=-"));
  require_confinement(wanted.unconfined);
  const Keys keys = [&](const Exercise& exercise) { return key(exercise, wanted.seed.value_or(1)); };
  const auto graded = grade(all_or(wanted.number), wanted.grade, keys, reports);
  return std::all_of(graded.begin(), graded.end(), [](const Graded& one) { return one.verdict.is_right(); })
             ? right
             : wrong;
}

std::uint64_t drawn_seed() {
  std::random_device random;
  return (static_cast<std::uint64_t>(random()) << 32) | random();
}

int export_to(const Wanted& wanted) {
  if (wanted.to.empty()) throw std::invalid_argument("--export needs --to FOLDER");
  const bool questions = wanted.course == "moodle" || wanted.course == "qti";
  if (questions && wanted.number != 0)
    throw std::invalid_argument(
        fmt::format("--export {} takes the predictions of all lessons, and no exercise", wanted.course));
  require_empty(wanted.to);
  if (questions)
    export_questions(wanted.course, wanted.to, wanted.asked_in);
  else if (wanted.course == "handouts")
    for (const Exercise* exercise : all_or(wanted.number))
      write_handout(fs::path(wanted.to) / exercise->name, *exercise);
  else
    export_course(wanted.course, wanted.to, wanted.seed ? *wanted.seed : drawn_seed(), all_or(wanted.number));
  fmt::print("Written into {}\n", wanted.to);
  return right;
}

int run(const Wanted& wanted) {
  if (wanted.asked == "--export") return export_to(wanted);
  if (wanted.asked == "--grade") return grade_folder(wanted);
  if (wanted.number == 0) {
    fmt::print("Exercises: ./lessons/run practise N\n{}", overview());
    return right;
  }
  const Exercise& exercise = chosen(wanted.number);
  if (wanted.asked == "--hint") {
    fmt::print("{}", hint_text(exercise, wanted.hint));
  } else if (wanted.asked == "--solution") {
    fmt::print("{}", solution_text(exercise));
  } else if (wanted.asked == "--unmask" && !wanted.unmask.empty()) {
    std::string report;
    const bool unmasked = unmask(exercise, wanted.unmask, report);
    fmt::print("{}", report);
    return unmasked ? right : wrong;
  } else if (wanted.asked == "--unmask") {
    fmt::print("{}", unmask_text(exercise));
  } else if (wanted.asked == "--check") {
    return check_file(exercise, wanted);
  } else {
    refuse_output(wanted.folder);
    const fs::path file = learners_file(exercise, wanted.folder);
    if (isatty(STDIN_FILENO) && isatty(STDOUT_FILENO))
      return watch(exercise, key(exercise, wanted.seed.value_or(1)), file);
    fmt::print("{}\nEdit {}, then: ./lessons/run practise {} --check {}\n", task_text(exercise),
               course::printable(file.string()), wanted.number, course::printable(file.string()));
  }
  return right;
}

/// Which of the options that exclude each other is given; empty for none. Throws std::invalid_argument for two,
/// and for an option without the one that it goes with.
std::string only_one(const CLI::App& app) {
  std::string given;
  for (const char* option : {"--check", "--hint", "--solution", "--unmask", "--grade", "--export", "--folder"}) {
    if (app.count(option) == 0) continue;
    if (!given.empty()) throw std::invalid_argument(fmt::format("{} and {}: choose one of them", given, option));
    given = option;
  }
  for (const auto& [option, with] : {std::pair{"--film", "--check"},
                                     {"--report", "--grade"},
                                     {"--unconfined", "--grade"},
                                     {"--to", "--export"},
                                     {"--questions", "--export"}})
    if (app.count(option) > 0 && given != with)
      throw std::invalid_argument(fmt::format("{} needs {}", option, with));
  return given;
}

std::string not_a_seed(const std::string& typed) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), seed);
  if (error == std::errc{} && end == typed.data() + typed.size()) return "";
  return fmt::format("{} is not a whole number from 0 to {}", course::shortened(typed),
                     std::numeric_limits<std::uint64_t>::max());
}

std::string nothing(const std::string& typed) { return typed.empty() ? "\"\" names nothing" : ""; }

int command(int argc, const char* const* argv) {
  Wanted wanted;
  CLI::App app("Exercises in which you write the code", "./lessons/run practise");
  app.set_help_flag("--help", "this page");
  auto* number = app.add_option("N", wanted.number, "number of an exercise; without it, the list");
  app.add_option("--folder", wanted.folder,
                 "your folder (default my_exercises/); files in it are never overwritten")
      ->check(nothing);
  app.add_option("--check", wanted.check,
                 "judge this file once: exit status 0 right, 1 wrong, 2 bad usage,\n"
                 "3 does not compile, 4 an error of the environment")
      ->type_name("FILE")
      ->check(nothing);
  app.add_option("--film", wanted.film, "with --check: folder for the film of what the code does")
      ->type_name("DIR")
      ->check(nothing);
  app.add_option("--seed", wanted.seed, "of the random probes (default 1; --export draws a secret one)")
      ->check(not_a_seed);
  app.add_option("--hint", wanted.hint, "hint 1, 2 or 3");
  app.add_flag("--solution", wanted.solution, "the solution and its derivation");
  app.add_option("--grade", wanted.grade, "judge all exercises in a folder, or exercise N of it")
      ->type_name("DIR")
      ->check(nothing);
  app.add_option("--report", wanted.reports,
                 "with --grade; repeatable: gradescope, classroom50, prairielearn, junit,\n"
                 "github or summary, into a file or - for the terminal")
      ->type_name("FORMAT=FILE")
      ->take_all();
  app.add_option("--export", wanted.course,
                 "for a course: gradescope, classroom50, prairielearn, junit; what its\n"
                 "learners get: handouts; or the predictions of all lessons: moodle, qti")
      ->check(nothing);
  app.add_option("--to", wanted.to, "new folder for --export")->type_name("DIR");
  app.add_option("--questions", wanted.asked_in,
                 "with --export moodle or qti: what the lessons print under\n"
                 "--questions, as DIR/01_jacobian.json and so on; they are run without it")
      ->type_name("DIR");
  app.add_flag("--unconfined", wanted.unconfined,
               "with --grade: also where the system cannot keep a submission from\nreading the judge's files");
  app.add_option("--unmask", wanted.unmask, "choose numbers on which a wrong code is wrong")
      ->expected(0, 1)
      ->type_name("NUMBERS")
      ->check(nothing);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return right;
  } catch (const CLI::ParseError& bad) {
    throw std::invalid_argument(fmt::format("{}; --help shows the options", bad.what()));
  }
  wanted.asked = only_one(app);
  if (number->count() > 0) chosen(wanted.number);
  if (number->count() == 0 && argc > 1 && wanted.asked != "--grade" && wanted.asked != "--export")
    throw std::invalid_argument("Name the exercise: ./lessons/run practise 2 …");
  return run(wanted);
}

}  // namespace

int main(int argc, char** argv) {
  return byhand::course::exit_status_of([&] { return command(argc, argv); }, environment);
}
