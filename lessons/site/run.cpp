// Lesson::run of the programs page_01_jacobian …, which write a lesson's page for the web site: page_01_jacobian
// FOLDER
// [--quiet]. The terminal's own stays in its library.

#include <stdexcept>
#include <string>
#include <vector>

#include "lessons/files/exit_status.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/site/page_writer.hpp"
#include "lessons/terminal/claim_table.hpp"

namespace byhand::course {

int Lesson::run(int argc, const char* const* argv) {
  return exit_status(about_.slug, [&] {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const bool quiet = words.size() == 2 && words.back() == "--quiet";
    if (words.size() != (quiet ? 2 : 1) || words.front().empty())
      throw std::invalid_argument(std::string(argv[0]) + " takes the folder of the site, and --quiet");
    const std::string wrong = false_claims(*this, site::write_page(*this, words.front(), quiet));
    complain(wrong);
    return wrong.empty() ? fine : false_claim;
  });
}

}  // namespace byhand::course
