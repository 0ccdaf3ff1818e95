#pragma once

#include <string>
#include <vector>

namespace byhand::tests {

/// A solution with one change.
struct Mutant {
  std::string before, after;  // the changed line, blanks as one
  std::string text;           // the whole code without #include lines and comments
};

/// Changes code in one place at a time: signs, operators, factors, names for other names of the same function
/// (which swaps bodies, indices and values of different moments), numbers, arguments, statements left out, doubled
/// or swapped, and rows that a loop leaves out. Many do not compile.
std::vector<Mutant> mutants_of(const std::string& code);

}  // namespace byhand::tests
