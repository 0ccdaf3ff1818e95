#pragma once

#include <filesystem>

#include "lessons/practise/judge/judge.hpp"

namespace byhand::practise {

/// Compiles a learner's file and judges it in a process of its own.
Verdict check(const Exercise& exercise, const Key& key, const std::filesystem::path& file);

}  // namespace byhand::practise
