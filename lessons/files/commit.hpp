#pragma once

namespace byhand::course {

/// The commit that this program was built from, with "-dirty" if sources had changed since; "unknown" without git.
/// lessons/commit.cmake writes its source.
const char* commit();

/// When it was committed, "2026-11-22T17:35:02Z"; the beginning of 1970 without git.
const char* commit_time();

}  // namespace byhand::course
