#include "lessons/tutor/check.hpp"

#include <fmt/format.h>

#include <map>

#include "lessons/tutor/speech.hpp"
#include "lessons/tutor/typeset.hpp"

namespace byhand::tutor {

std::string check_table(const std::vector<Told>& lesson) {
  std::vector<std::vector<std::string>> rows = {{"step", "verdict", "measured", "expected", "quantity (source)"}};
  std::map<std::string, int> count;
  for (const Told& told : lesson) {
    for (const Claim& claim : claims(told.page)) {
      ++count[verdict(claim)];
      rows.push_back({told.step->label, verdict(claim), measurement(claim), expectation(claim),
                      fmt::format("{} ({}){}", claim.quantity, claim.source,
                                  claim.claimed ? "" : fmt::format(", only for {}", claim.range))});
    }
  }
  return table(rows) + fmt::format("{} hold, {} false, {} not claimed here\n", count["holds"], count["false"],
                                   count["not claimed"]);
}

std::string false_claims(const Lesson& lesson, const std::vector<Told>& told) {
  std::string lines;
  for (const Told& t : told)
    for (const Claim& claim : claims(t.page))
      if (claim.is_false())
        lines += fmt::format("{} step {}: {} is false: measured {}, expected {} ({})\n", lesson.about().slug,
                             t.step->label, claim.quantity, measurement(claim), expectation(claim), claim.source);
  return lines;
}

}  // namespace byhand::tutor
