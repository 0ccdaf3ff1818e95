#pragma once

namespace byhand::course {

/// From now on a signal that ends this process first removes its temporary files, and writing beyond the largest
/// size of a file is an error instead of a signal. Signals that the caller ignores (nohup) stay ignored.
void leave_no_temporary_files();

}  // namespace byhand::course
