#include "lessons/practise/judge/compiled.hpp"

#include <fmt/format.h>

namespace byhand::practise {

std::string too_long(const std::string& name) {
  return fmt::format("{} has more than {} KB; a solution has less than one.", name, most_text >> 10);
}

Verdict not_compiled(const std::string& sentence) {
  Verdict verdict;
  verdict.kind = Verdict::Kind::does_not_compile;
  verdict.sentence = sentence;
  return verdict;
}

Verdict not_compiled(const std::string& sentence, const Messages& messages) {
  Verdict verdict = not_compiled(sentence);
  verdict.details = messages.errors;
  verdict.line = messages.line;
  return verdict;
}

void finish(Verdict& verdict, const std::string& warnings) {
  const bool judged =
      verdict.kind != Verdict::Kind::does_not_compile && verdict.kind != Verdict::Kind::not_written;
  if (judged && !verdict.is_right() && !warnings.empty()) verdict.details += "The compiler warns\n" + warnings;
  // All of it may quote the learner's bytes.
  verdict.sentence = legible(verdict.sentence, 1000);
  verdict.details = legible(verdict.details, 8192);
  verdict.printed = legible(verdict.printed, 2000);
}

}  // namespace byhand::practise
