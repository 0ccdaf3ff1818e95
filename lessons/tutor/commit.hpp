#pragma once

namespace byhand::tutor {

/// The commit that this program was built from, with "-dirty" if sources had changed since; "unknown" without git.
/// lessons/commit.cmake writes its source.
const char* commit();

}  // namespace byhand::tutor
