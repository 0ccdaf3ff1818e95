#include "lessons/files/streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <glib.h>
#include <unistd.h>

#include <cstdio>

namespace byhand::course {

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // open() returns the lowest free number, which is this one.
    [[maybe_unused]] const int opened = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
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

}  // namespace byhand::course
