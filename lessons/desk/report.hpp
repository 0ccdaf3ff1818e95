#pragma once

#include "lessons/desk/sheet.hpp"

namespace byhand::desk {

/// A part of J: its name, formula, unit and rank.
struct Part {
  std::string name, characters, latex, unit;
  int rank = 0;
};

/// What a derived constraint is, once its J stands.
struct Report {
  struct OfRow {
    std::string name;  // "", "1", …
    std::vector<Part> parts;
    std::string ours;  // the constraint of the course that it is, and its J
    std::vector<std::string> remarks;
  };
  std::vector<OfRow> rows;
  int count = 0, rank = 0;  // of all rows together
};

Report report(const Sheet& sheet);
std::string text_of(const Report& report);

/// The derived kind as a struct that the solver takes, with a row or more; nothing unless every row has a J, and
/// all have a C or none has.
std::string cpp_struct(const Sheet& sheet);

/// Where a formula of positions has no derivative, and where its J vanishes: a sentence each.
std::vector<std::string> singularities(const Vocabulary& words, const Expression& C);

}  // namespace byhand::desk
