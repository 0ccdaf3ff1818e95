// The lesson on a computer as its page has it in the browser: a request a line, an answer a line. Tests compare
// both.

#include <iostream>

#include "lessons/site/live/program.hpp"

int byhand::course::Lesson::run(int, const char* const*) {
  site::Program program(std::move(*this));
  for (std::string request; std::getline(std::cin, request);) std::cout << program.answer(request) << std::endl;
  return 0;
}
