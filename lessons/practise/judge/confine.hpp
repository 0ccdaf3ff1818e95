#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/practise/judge/process.hpp"

// What a process does to itself between fork and exec, without memory or exceptions. Each does nothing where the
// system cannot; missing_confinement() tells where that is.
namespace byhand::practise {

/// What this system cannot keep from a learner's program or its compiler, as a sentence; "" if it can confine
/// both.
std::string missing_confinement();

void limit(const Limits& limits, std::size_t file_bytes);

/// Allows memory, reading and writing open descriptors, and ending; anything else kills the process with SIGSYS.
void allow_computing_only();

/// Allows reading below `readable` and anything below `writable`, and no other file.
void allow_files(const std::vector<std::filesystem::path>& readable, const std::filesystem::path& writable);

}  // namespace byhand::practise
