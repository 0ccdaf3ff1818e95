#include "lessons/files/streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <glib.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace byhand::course {

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // open() returns the lowest free number, which is this one.
    [[maybe_unused]] const int opened = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void flush_standard_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::system_error(errno != 0 ? errno : EIO, std::generic_category());
}

std::string sentence_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return "There is not enough memory.";
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  if (!of_system) return error.what();
  const std::string reason = of_system->code().message();
  if (std::ferror(stdout) != 0) return fmt::format("Cannot write to standard output: {}.", reason);
  if (const auto* const of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return fmt::format("Cannot use {}: {}.", of_file->path1().string(), reason);
  return error.what();
}

int exit_status_of(const std::function<int()>& body, int environment) {
  constexpr int bad_usage = 2;
  open_standard_streams();
  try {
    const int status = body();
    flush_standard_output();
    return status;
  } catch (const std::invalid_argument& error) {
    complain(printable(error.what()) + "\n");
    return bad_usage;
  } catch (const std::exception& error) {
    complain(printable(sentence_of(error)) + "\n");
    return environment;
  }
}

void complain(std::string_view words) noexcept {
  std::fwrite(words.data(), 1, words.size(), stderr);
  std::fflush(stderr);
}

std::string printable(std::string_view words) {
  std::string line;
  while (!words.empty()) {
    const gunichar character = g_utf8_get_char_validated(words.data(), static_cast<gssize>(words.size()));
    const bool valid = character < 0x110000 && character != 0;
    const auto length = valid ? static_cast<size_t>(g_unichar_to_utf8(character, nullptr)) : 1;
    if (valid && g_unichar_isprint(character))
      line += words.substr(0, length);
    else if (words.front() == '\n')
      line += "\\n";
    else if (words.front() == '\t')
      line += "\\t";
    else
      for (const char byte : words.substr(0, length))
        line += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    words.remove_prefix(length);
  }
  return line;
}

std::string shortened(const std::string& typed) {
  constexpr size_t longest = 60;
  return typed.size() > longest ? typed.substr(0, longest) + "…" : typed;
}

}  // namespace byhand::course
