#pragma once

#include <functional>
#include <string>

namespace byhand::course {

enum ExitStatus { fine = 0, false_claim = 1, bad_usage = 2, environment = 3 };

/// What a program of the lesson `slug` exits with: the status that `work` returns, or that of what it throws, of
/// which it complains in one sentence.
int exit_status(const std::string& slug, const std::function<int()>& work);

}  // namespace byhand::course
