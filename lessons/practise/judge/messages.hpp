#pragma once

#include <string>

// What a compiler says about a learner's file, which it knows by a path that means nothing to the learner.
namespace byhand::practise {

struct Messages {
  std::string errors, warnings;  // about the learner's own lines, in order; or where a header's error comes from
  int line = 0;                  // of the first error

  Messages(const std::string& said, const std::string& file);
};

/// Why a program could not be linked, as a sentence; `text` is the learner's.
std::string about_linking(const std::string& said, const std::string& text);

/// What follows the last `before` in a text, to the end of the line.
std::string rest_of_line(const std::string& text, const std::string& before);

/// At most `most` bytes of a text, without what is no UTF-8, no character of XML, a control of the terminal or one
/// of the direction of writing.
std::string legible(const std::string& text, std::size_t most);

}  // namespace byhand::practise
