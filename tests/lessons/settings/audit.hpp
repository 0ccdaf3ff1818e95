#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lessons/files/picture_drawer.hpp"
#include "lessons/page/lesson.hpp"
#include "tests/lessons/settings/rules.hpp"
#include "tests/lessons/settings/settings.hpp"

namespace byhand::tests {

/// How much of a lesson to try.
struct Extent {
  int random = 200;                   // random settings
  unsigned seed = 1;                  // of them, and of the order of the pairs
  std::string step = {};              // only this one; empty: all
  bool pairs = true;                  // of ends of two parameters
  double seconds = 1e9;               // of the processor for each step; what does not fit is left out and counted
  bool all_steps = true;              // also those that no parameter changes
  bool pictures = false;              // draw them, too
  bool frames = false;                // what pictures show is inside them
  bool judgements = false;            // sentences that judge are verdicts
  Setting base = {};                  // instead of defaults where nothing else is said; random settings keep it
  Setting beyond = {};                // values that take longer than a step has: left out and counted
  std::vector<Suggestion> also = {};  // settings to try besides, whatever the time
};

/// Sentences alike but for their numbers that break the same rule in the same step.
struct Failure {
  std::string step, command;  // the first setting that does
  Finding finding;
  int settings = 0;  // how many do
};

/// Runs the steps of a lesson at many settings and holds each page against the rules. A step that does not change
/// with a parameter, as seen at the ends of its range, runs once for all its values. Where the time is short, the
/// ends may take half of it, the random settings most of the rest, and each seed tries other ones.
class Audit {
 public:
  Audit(course::Lesson& lesson, Extent extent);

  const std::vector<Failure>& failures() const { return failures_; }
  int runs() const { return runs_; }
  /// "step 7 at 120 of 300 settings, for want of time", for each step that took too long.
  std::vector<std::string> left_out() const;
  /// Of the processor: "180 s, 120 s of them for step 7".
  std::string time_taken() const;

 private:
  struct StepState {
    std::string page;               // at the base: all it says and draws
    std::set<std::string> depends;  // parameters that change it
    double seconds = 0;             // taken
    std::set<Setting> wanted;       // settings, each once
    int tried = 0;                  // of them
  };

  void try_ends();
  void try_all(const std::vector<Suggestion>& all);
  void try_random();
  void try_pairs();
  /// Turns what Lesson::answers gives to other steps: this one says the same.
  void try_foreign_parameters();
  /// What the step says at the setting, without those parameters that it does not depend on; nothing if its time
  /// is up.
  std::optional<std::string> try_step(const course::Step& step, const Setting& setting);
  std::vector<Finding> findings(const course::Step& step, const Setting& setting, std::string& page);
  bool may_depend(const course::Step& step, const course::ParameterRecord& parameter) const;
  Setting relevant(const course::Step& step, const Setting& setting) const;
  void report(const std::string& step, const std::string& command, Finding finding);
  std::string command(const std::string& step, const Setting& setting) const;

  course::Lesson& lesson_;
  Extent extent_;
  course::PictureDrawer pictures_{course::small_quality};
  double until_ = 0;  // seconds of a step that what is tried now may take
  std::map<std::string, StepState> steps_;
  std::vector<Failure> failures_;
  int runs_ = 0;
};

}  // namespace byhand::tests
