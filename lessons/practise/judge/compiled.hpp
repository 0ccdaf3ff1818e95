#pragma once

#include <cstddef>
#include <string>

#include "lessons/practise/judge/judge.hpp"
#include "lessons/practise/judge/messages.hpp"

// What a compiler adds to a verdict, at a terminal and in a page.
namespace byhand::practise {

inline constexpr std::size_t most_text = 64u << 10;  // bytes of a learner's file

/// Why a file of more bytes is not compiled.
std::string too_long(const std::string& name);

Verdict not_compiled(const std::string& sentence);
Verdict not_compiled(const std::string& sentence, const Messages& messages);

/// Adds the compiler's warnings where the code was judged and is not right, and leaves legible bytes alone.
void finish(Verdict& verdict, const std::string& warnings);

}  // namespace byhand::practise
