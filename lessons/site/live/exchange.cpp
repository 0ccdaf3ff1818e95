// A script and the program that it has loaded: the script writes a request where `request` says, and reads the
// answer where `answer` says.

#include "lessons/page/answered.hpp"

namespace {

std::string request_text, answer_text;

}  // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(request) char* request(int size) {
  request_text.assign(static_cast<std::size_t>(size), '\0');
  return request_text.data();
}

EXPORT(answer) const char* answer() {
  answer_text = byhand::course::answered(request_text);
  return answer_text.data();
}

EXPORT(answer_size) int answer_size() { return static_cast<int>(answer_text.size()); }
