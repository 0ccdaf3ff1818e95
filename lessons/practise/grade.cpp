// The judge of a course: grades a folder of submissions by keys, without any solution.
//
//   grade --keys FOLDER --submission FOLDER [--report FORMAT=FILE]… [--unconfined]
//
// Exit status: 0 whenever grading ran, 2 bad usage, 4 an error of the environment.

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "lessons/practise/judge/submission.hpp"

namespace {

using namespace byhand::practise;

constexpr const char* usage =
    "grade --keys FOLDER --submission FOLDER [--report FORMAT=FILE]… [--unconfined]\n\n"
    "Judges each exercise whose key lies in the one folder by the file of its name in the other.\n"
    "  --report      repeatable: gradescope, classroom50, prairielearn, junit, github or summary; - is the "
    "terminal\n"
    "  --unconfined  grade also where the system cannot keep a submission from reading the judge's files\n\n"
    "Exit status: 0 whenever grading ran, 2 bad usage, 4 an error of the environment.\n";

int run(const std::vector<std::string>& arguments) {
  std::filesystem::path keys, submission;
  std::vector<Report> reports;
  bool unconfined = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--help") {
      fmt::print("{}", usage);
      return 0;
    }
    if (arguments[i] == "--unconfined") {
      unconfined = true;
      continue;
    }
    if (i + 1 == arguments.size()) throw std::invalid_argument(arguments[i] + " needs a value; see --help");
    const std::string& value = arguments[++i];
    if (arguments[i - 1] == "--keys")
      keys = value;
    else if (arguments[i - 1] == "--submission")
      submission = value;
    else if (arguments[i - 1] == "--report")
      reports.push_back(parse_report(value));
    else
      throw std::invalid_argument(arguments[i - 1] + " is no option; see --help");
  }
  if (keys.empty() || submission.empty()) throw std::invalid_argument("--keys and --submission name folders");
  std::error_code error;
  if (!std::filesystem::is_directory(keys, error))
    throw std::invalid_argument(fmt::format("{} is not a folder of keys", keys.string()));

  std::vector<const Exercise*> wanted;
  const auto key_file = [&](const Exercise& exercise) { return keys / (exercise.name + ".json"); };
  for (const Exercise& exercise : exercises())
    if (std::filesystem::exists(key_file(exercise))) wanted.push_back(&exercise);
  if (wanted.empty())
    throw std::invalid_argument(keys.string() + " holds no key, such as 01_rod_between_particles.json");
  require_confinement(unconfined);
  const Keys read = [&](const Exercise& exercise) { return key_from_json(contents_of(key_file(exercise))); };
  grade(wanted, submission, read, reports);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int status = run({argv + 1, argv + argc});
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category(), "standard output");
    return status;
  } catch (const std::invalid_argument& bad) {
    fmt::print(stderr, "{}.\n", bad.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
