#include <fmt/format.h>
#include <unistd.h>

#include "lessons/files/exit_status.hpp"
#include "lessons/files/options.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/terminal/batch.hpp"
#include "lessons/terminal/dialogue.hpp"
#include "lessons/terminal/terminal_text.hpp"

namespace byhand::course {
namespace {

int answer(Lesson& lesson, int argc, const char* const* argv) {
  try {
    Options options = read_options(lesson, argc, argv, isatty(STDIN_FILENO) && isatty(STDOUT_FILENO));
    for (const auto& [name, value] : options.set) lesson.set(name, value);
    if (options.step.empty()) options.step = lesson.step_of(options.set);
    if (!options.list_parameters)
      return options.interactive ? run_dialogue(lesson, options) : run_batch(lesson, options);
    fmt::print("{}", parameters_text(lesson));
  } catch (const HelpRequested& help) {
    fmt::print("{}", help.text);
  }
  return fine;
}

}  // namespace

int Lesson::run(int argc, const char* const* argv) {
  return exit_status(about_.slug, [&] { return answer(*this, argc, argv); });
}

}  // namespace byhand::course
