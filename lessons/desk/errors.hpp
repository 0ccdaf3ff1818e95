#pragma once

#include <array>
#include <optional>
#include <string>

#include "lessons/desk/derivative.hpp"
#include "lessons/desk/judge.hpp"

// The names of wrong lines. A name is found by value: the right line is spoiled in the way that the name says, and
// the typed line agrees with that at all states. So it is found however the line is written, named and scaled.
namespace byhand::desk {

struct Error {
  const char* name;
  const char* sentence;  // {right}, {wrong}, {of}: the smallest line where it happened; {body}; {factor}
  const char* question;  // the first hint
  const char* rule;      // the second; the third is the right smallest line
};
/// All of them, for the tests and the page.
const std::vector<Error>& errors();
const Error& error(std::string_view name);

/// What is wrong with a line.
struct Finding {
  std::string name;  // of the error, "" if it has none
  std::string sentence;
  Expression of, right, wrong;       // the smallest line: of `of`, `right` follows and `wrong` was written
  std::array<std::string, 3> hints;  // in three degrees
};

/// Why a rate is not dC/dt.
Finding why_not_the_rate(const Judge& judge, const Expression& C, const Expression& typed);
/// Why a line does not follow from the one before; C where it is known.
Finding why_not_equal(const Judge& judge, const Expression& before, const Expression& typed,
                      const Expression& C = nullptr);
/// Why these parts are not those of J in a right rate; four, or two for particles.
Finding why_not_the_parts(const Judge& judge, const Expression& rate, const std::vector<Expression>& parts,
                          const Expression& C);

/// The velocities that the parts of J stand before, in the order of (6).
std::vector<const Symbol*> velocities(const Vocabulary& words);
/// "l1", "a1", "l2", "a2"
std::string part_name(const Vocabulary& words, std::size_t part);
/// JV of (8). Throws Misfit, pointing at the part, where a part does not fit its velocity.
Expression rate_by(const Vocabulary& words, const std::vector<Expression>& parts, Shape C, Span where);

}  // namespace byhand::desk
