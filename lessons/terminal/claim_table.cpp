#include "lessons/terminal/claim_table.hpp"

#include <fmt/format.h>

#include <map>

#include "lessons/terminal/terminal_text.hpp"
#include "lessons/terminal/typeset.hpp"

namespace byhand::course {

std::string claim_table(const std::vector<RecordedStep>& steps) {
  std::vector<std::vector<std::string>> rows = {{"step", "verdict", "measured", "expected", "quantity (source)"}};
  std::map<std::string, int> count;
  for (const auto& [step, page, reads] : steps) {
    for (const Claim& claim : claims(page)) {
      ++count[verdict(claim)];
      rows.push_back({step->label, verdict(claim), measurement(claim), expectation(claim),
                      fmt::format("{} ({}){}", claim.quantity, claim.source,
                                  claim.claimed() ? "" : fmt::format(", only for {}", claim.range.words))});
    }
  }
  return table(rows) + fmt::format("{} hold, {} false, {} not claimed here\n", count["holds"], count["false"],
                                   count["not claimed"]);
}

std::string false_claims(const Lesson& lesson, const std::vector<RecordedStep>& steps) {
  std::string lines;
  for (const auto& [step, page, reads] : steps)
    for (const Claim& claim : claims(page))
      if (claim.is_false())
        lines += fmt::format("{} step {}: {} is false: measured {}, expected {} ({})\n", lesson.about().slug,
                             step->label, claim.quantity, measurement(claim), expectation(claim), claim.source);
  return lines;
}

}  // namespace byhand::course
