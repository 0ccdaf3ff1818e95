// The lesson in a browser: a worker asks, and the lesson answers.

#include <optional>

#include "lessons/page/answered.hpp"
#include "lessons/site/live/program.hpp"
#include "lessons/site/live/space_window.hpp"

/// The lesson's main, as the compiler calls it.
extern "C" int __main_argc_argv(int argc, char** argv);

namespace {

std::optional<byhand::site::Program> program;

}  // namespace

/// The main of a lesson fills it and calls this at its end.
int byhand::course::Lesson::run(int, const char* const*) {
  program.emplace(std::move(*this), site::space_windows());
  return 0;
}

std::string byhand::course::answered(const std::string& request) {
  if (!program) __main_argc_argv(0, nullptr);
  return program->answer(request);
}
