#include "lessons/files/exit_status.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "lessons/files/signals.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/error.hpp"
#include "renderer/error.hpp"

namespace byhand::course {
namespace {

int refuse(ExitStatus status, std::string_view sentence) {
  complain(printable(sentence) + "\n");
  return status;
}

}  // namespace

int exit_status(const std::string& slug, const std::function<int()>& work) {
  open_standard_streams();
  leave_no_temporary_files();
  try {
    const int status = work();
    flush_standard_output();
    return status;
  } catch (const EnvironmentError& error) {
    return refuse(environment, error.what());
  } catch (const renderer::Unavailable& error) {
    return refuse(environment, error.what());
  } catch (const std::system_error& error) {
    return refuse(environment, sentence_of(error));
  } catch (const std::bad_alloc& error) {
    return refuse(environment, sentence_of(error));
  } catch (const std::invalid_argument& error) {
    return refuse(bad_usage, error.what());
  } catch (const std::exception& error) {
    return refuse(false_claim, fmt::format("{} is written wrongly: {}", slug, error.what()));
  }
}

}  // namespace byhand::course
