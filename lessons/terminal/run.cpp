#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "lessons/files/options.hpp"
#include "lessons/files/signals.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/terminal/batch.hpp"
#include "lessons/terminal/dialogue.hpp"
#include "lessons/terminal/terminal_text.hpp"
#include "renderer/error.hpp"

namespace byhand::course {
namespace {

enum ExitStatus { fine = 0, false_claim = 1, bad_usage = 2, environment = 3 };

int refuse(ExitStatus status, std::string_view sentence) {
  complain(printable(sentence) + "\n");
  return status;
}

int answer(Lesson& lesson, int argc, const char* const* argv) {
  Options options = read_options(lesson, argc, argv, isatty(STDIN_FILENO) && isatty(STDOUT_FILENO));
  for (const auto& [name, value] : options.set) lesson.set(name, value);
  if (options.step.empty()) options.step = lesson.step_of(options.set);
  if (options.list_parameters)
    fmt::print("{}", parameters_text(lesson));
  else
    return options.interactive ? run_dialogue(lesson, options) : run_batch(lesson, options);
  return fine;
}

}  // namespace

int Lesson::run(int argc, const char* const* argv) {
  open_standard_streams();
  leave_no_temporary_files();
  try {
    int status = fine;
    try {
      status = answer(*this, argc, argv);
    } catch (const HelpRequested& help) {
      fmt::print("{}", help.text);
    }
    flush_standard_output();
    return status;
  } catch (const renderer::Unavailable& error) {
    return refuse(environment, error.what());
  } catch (const EnvironmentError& error) {
    return refuse(environment, error.what());
  } catch (const std::system_error& error) {
    return refuse(environment, sentence_of(error));
  } catch (const std::bad_alloc& error) {
    return refuse(environment, sentence_of(error));
  } catch (const std::invalid_argument& error) {
    return refuse(bad_usage, error.what());
  } catch (const std::exception& error) {
    return refuse(false_claim, fmt::format("{} is written wrongly: {}", about_.slug, error.what()));
  }
}

}  // namespace byhand::course
