// What a page asks of the program that hosts it, where there is one thread and no terminal.

#include <algorithm>
#include <cctype>

#include "lessons/page/lower_case.hpp"
#include "lessons/page/progress.hpp"
#include "lessons/page/side_by_side.hpp"

/// Told to the page: `done` of `total` pieces of a step's work are done.
__attribute__((import_module("page"), import_name("progress"))) void report_progress(int done, int total);

namespace byhand::course {

struct Progress::Reporter {
  int done, total;
};

Progress::Progress(std::string, int total, bool) : reporter_(std::make_unique<Reporter>(Reporter{0, total})) {}
Progress::~Progress() = default;
void Progress::advance() { report_progress(++reporter_->done, reporter_->total); }
void Progress::expect(int more) { reporter_->total += more; }

void side_by_side(int count, const std::function<void(int)>& work, Progress* progress) {
  if (progress) progress->expect(count);
  for (int i = 0; i < count; ++i) {
    work(i);
    if (progress) progress->advance();
  }
}

/// Of ASCII alone: pages send the number of an option, not its words.
std::string in_lower_case(const std::string& words) {
  std::string lower = words;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char letter) {
    return static_cast<char>(letter < 0x80 ? std::tolower(letter) : letter);
  });
  return lower;
}

}  // namespace byhand::course
