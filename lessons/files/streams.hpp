#pragma once

#include <string>
#include <string_view>

namespace byhand::course {

/// Opens those of the descriptors 0, 1 and 2 that are closed, so that no file gets their numbers and with it what
/// is printed. Reading from or writing to them still fails. To be called before anything else is opened.
void open_standard_streams();

/// Prints on standard error. Never throws: a closed or full standard error must not end a good run.
void complain(std::string_view words) noexcept;

/// The words on one line, as a terminal may print them: control characters and invalid UTF-8 as \n, \t or \x1b.
std::string printable(std::string_view words);

}  // namespace byhand::course
