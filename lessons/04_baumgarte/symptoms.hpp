#pragma once

#include <functional>

#include "lessons/04_baumgarte/faults.hpp"

namespace byhand::baumgarte {

/// What is measured of a rod.
struct Reading {
  std::string name, unit;
  std::function<double(const RodBetween&)> of;
};

/// A rod, the step that is wrong for it and the right one, and what is measured after so many wrong steps.
struct FaultyRun {
  RodBetween start;
  Recipe recipe, right;
  int steps;
  Reading read;
};

/// Something that readers see in programs of their own, what is behind it, and how to make sure. The wrong step is
/// run, and so is the right one.
struct Symptom {
  std::string seen;       // "A hanging bob sinks at a steady speed"
  std::string quantity;   // what is measured: "speed downwards after 1 s"
  std::string unit = {};  // that of what is read, if it is run
  double law = 0;         // what the wrong step should give, in `unit`
  std::string source;     // of that number: "gh"
  std::string cause, test;
  std::string more;                          // the step and the exercise
  double wrong = 0, right = 0;               // measured, in `unit`
  std::string compared = "correct program";  // what gave `right`
  double tolerance = 1e-9;                   // of the law, relative to the larger of it and 1
  std::optional<FaultyRun> run = {};         // to be filmed
};

/// Those of a rod that is not corrected, of its correction, of bodies that turn, and of several rows.
struct SymptomGroup {
  std::string title;
  std::vector<Symptom> symptoms;
};
std::vector<SymptomGroup> all_symptoms();

}  // namespace byhand::baumgarte
