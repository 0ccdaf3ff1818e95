#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>

namespace byhand::course {

/// Opens those of the descriptors 0, 1 and 2 that are closed, so that no file gets their numbers and with it what
/// is printed. Reading from or writing to them still fails. To be called before anything else is opened.
void open_standard_streams();

/// Throws std::system_error if anything that was printed on standard output did not get there.
void flush_standard_output();

/// What an exception means to a person, in a sentence: for an error of the system, what could not be used and why.
std::string sentence_of(const std::exception& error);

/// Runs the body of a program. What it throws becomes one printable line and the exit status: 2 for
/// std::invalid_argument, `environment` for everything else, as for standard output that cannot be written.
int exit_status_of(const std::function<int()>& body, int environment = 3);

/// Prints on standard error. Never throws: a closed or full standard error must not end a good run.
void complain(std::string_view words) noexcept;

/// The words on one line, as a terminal may print them: control characters and invalid UTF-8 as \n, \t or \x1b.
std::string printable(std::string_view words);

/// The beginning of something typed that is too long to be told.
std::string shortened(const std::string& typed);

}  // namespace byhand::course
