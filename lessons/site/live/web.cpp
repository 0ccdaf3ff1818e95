// The lesson in a browser: a worker writes a request where `request` says, and reads the answer where `answer`
// says.

#include <optional>

#include "lessons/site/live/program.hpp"
#include "lessons/site/live/space_window.hpp"

/// The lesson's main, as the compiler calls it.
extern "C" int __main_argc_argv(int argc, char** argv);

namespace {

std::optional<byhand::site::Program> program;
std::string request_text, answer_text;

}  // namespace

/// The main of a lesson fills it and calls this at its end.
int byhand::course::Lesson::run(int, const char* const*) {
  program.emplace(std::move(*this), site::space_window());
  return 0;
}

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(request) char* request(int size) {
  request_text.assign(static_cast<std::size_t>(size), '\0');
  return request_text.data();
}

EXPORT(answer) const char* answer() {
  if (!program) __main_argc_argv(0, nullptr);
  answer_text = program->answer(request_text);
  return answer_text.data();
}

EXPORT(answer_size) int answer_size() { return static_cast<int>(answer_text.size()); }
