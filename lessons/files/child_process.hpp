#pragma once

#include <string>
#include <vector>

namespace byhand::course {

/// How a program ended. `status` is its exit status, or 128 and the number of the signal that ended it.
struct Ended {
  int status = 0;
  bool by_signal = false;
  int passed_on = 0;  // the last signal that came for us meanwhile, 0 for none

  bool well() const { return status == 0; }
};

enum class Group {
  ours,  // the program reads from the terminal, and Ctrl-C there reaches it by itself
  own    // signals go to the program and to all that it starts
};

/// Runs the program at a path, without a shell, and waits until it ends. Signals that ask us to end are passed on;
/// if we are killed, so is the program. The terminal is
/// afterwards as it was, whatever ended the program.
/// Throws std::system_error if it cannot be started. Only for processes of one thread.
Ended run_program(const std::string& path, const std::vector<std::string>& arguments, Group group);

/// A program that runs beside this one, in a group of its own, until it ends or this object or process is gone.
class Beside {
 public:
  Beside(const std::string& path, const std::vector<std::string>& arguments);
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  /// Asks the program and all that it started to end, and waits for it.
  ~Beside();

 private:
  int process_;
};

/// Ends this process by the signal, as its caller expects of a process that was asked to end.
void end_by(int signal);

}  // namespace byhand::course
