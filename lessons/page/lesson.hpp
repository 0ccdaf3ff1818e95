#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lessons/page/about.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/held.hpp"
#include "lessons/page/page.hpp"
#include "lessons/page/parameter.hpp"

namespace byhand::course {

/// An experiment for the reader and its command: "./lessons/run baumgarte --set beta=2.1".
struct Try {
  std::string what, command;
};

struct Closing {
  std::vector<std::string> now_you_know = {};
  std::vector<Try> tries = {};
  std::string next = {};
};

using StepFunction = std::function<void(Page&)>;

/// One step. It runs anew each time it is shown, so its result may depend on the parameters alone.
struct Step {
  std::string label;  // "3"; "3a" for the first deeper step after it
  std::string title;
  bool deeper = false;
  StepFunction run;
  std::optional<Hold> hold = {};
};

/// A lesson: parameters, steps and closing. The main of a lesson fills one and returns `run(argc, argv)`.
///
///     int main(int argc, char** argv) {
///       Lesson lesson({.slug = "04_baumgarte", .title = "Baumgarte", .summary = "…", .method = "…"});
///       auto beta = lesson.parameter("beta", 0.2, "1", {0, 3}, "share of the error that one step removes");
///       auto h = lesson.parameter("h", 1.0 / 60, "s", {1e-4, 0.1}, "time step");
///       lesson.step("The error shrinks by (1 − β)", [=](Page& page) { page.text("β is @.", beta()); … });
///       lesson.deeper("…", [=](Page& page) { … });
///       lesson.closing({.now_you_know = {…}, .tries = {{"…", "./lessons/run 4 --set beta=2.1"}}, .next = "…"});
///       return lesson.run(argc, argv);
///     }
class Lesson {
 public:
  /// Throws LessonError unless the slug is two digits, "_" and [a-z0-9_]+.
  explicit Lesson(About about);

  /// Adds a number with its default, unit ("1" if dimensionless), range and meaning. The parameter "h" is the time
  /// step in manifest.json. Throws LessonError for a default out of range or a duplicate name.
  Parameter<double> parameter(std::string name, double initial, std::string unit, Range range,
                              std::string meaning);
  Parameter<int> parameter(std::string name, int initial, std::string unit, Range range, std::string meaning);
  /// Adds a choice among named values; names are [a-z0-9_]+.
  Parameter<std::string> parameter(std::string name, std::string initial, std::vector<std::string> choices,
                                   std::string meaning);

  /// Adds a core step. Throws LessonError for the eighth.
  void step(std::string title, StepFunction run);

  /// Adds an optional step after the last core step. A reader opens it with `d`; batch runs include it.
  void deeper(std::string title, StepFunction run);

  /// Declares that only the step added last depends on these parameters. If the command line sets them and no
  /// others, only that step runs.
  void answers(const std::vector<std::string>& parameters);

  /// Gives the step added last a scene that a reader of its live page can hold. The page shows how it begins;
  /// terminal and lesson.md do without.
  void hold(Hold hold);

  void closing(Closing closing);

  /// Runs the lesson with the options of the command line. Returns 0 for success, 1 for a false claim or a
  /// LessonError, 2 for bad usage or a bad value, 3 for an error of the environment. Each error is one sentence on
  /// standard error.
  int run(int argc, const char* const* argv);

  const About& about() const { return about_; }
  int number() const;
  const std::vector<Step>& steps() const { return steps_; }
  const Closing& closing() const { return closing_; }
  const std::deque<ParameterRecord>& parameters() const { return parameters_; }

  /// Throws std::invalid_argument for a bad value and for an unknown name, with the list of the known ones.
  void set(const std::string& name, std::string_view value);
  bool is_parameter(const std::string& name) const;
  /// Label of the only step that depends on these parameters; empty if there is no such step.
  std::string step_of(const std::vector<std::pair<std::string, std::string>>& settings) const;
  bool at_defaults() const;

 private:
  ParameterRecord& record(ParameterRecord record);

  About about_;
  std::deque<ParameterRecord> parameters_;  // a deque: Parameter keeps pointers to its elements
  std::vector<Step> steps_;
  Closing closing_;
};

}  // namespace byhand::course
