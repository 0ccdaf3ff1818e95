// The judge of a course: grades a folder of submissions by keys, without any solution.
//
//   grade --keys FOLDER --submission FOLDER [--report FORMAT=FILE]…
//
// Exit status: 0 whenever grading ran, 2 bad usage, 4 an error of the environment.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "lessons/practise/judge/grading.hpp"

namespace {

using namespace byhand::practise;

int run(const std::vector<std::string>& arguments) {
  std::filesystem::path keys, submission;
  std::vector<Report> reports;
  for (std::size_t i = 0; i + 1 < arguments.size(); i += 2) {
    const std::string& value = arguments[i + 1];
    if (arguments[i] == "--keys")
      keys = value;
    else if (arguments[i] == "--submission")
      submission = value;
    else if (arguments[i] == "--report")
      reports.push_back(parse_report(value));
    else
      throw std::invalid_argument(arguments[i] + " is no option; there are --keys, --submission and --report");
  }
  if (keys.empty() || submission.empty()) throw std::invalid_argument("--keys and --submission name folders");

  std::vector<const Exercise*> wanted;
  const auto key_file = [&](const Exercise& exercise) { return keys / (exercise.name + ".json"); };
  for (const Exercise& exercise : exercises())
    if (std::filesystem::exists(key_file(exercise))) wanted.push_back(&exercise);
  const Keys read = [&](const Exercise& exercise) { return key_from_json(contents_of(key_file(exercise))); };
  grade(wanted, submission, read, reports);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::invalid_argument& bad) {
    fmt::print(stderr, "{}.\n", bad.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
