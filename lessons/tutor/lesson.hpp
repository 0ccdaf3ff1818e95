#pragma once

#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lessons/tutor/about.hpp"
#include "lessons/tutor/error.hpp"
#include "lessons/tutor/page.hpp"
#include "lessons/tutor/parameter.hpp"

namespace byhand::tutor {

/// Something to try, with the command that does it: "./lessons/run baumgarte --set beta=2.1".
struct Try {
  std::string what, command;
};

struct Closing {
  std::vector<std::string> now_you_know = {};
  std::vector<Try> tries = {};
  std::string next = {};
};

using StepFunction = std::function<void(Page&)>;

/// One step. It is run from the start each time it is shown, so it must depend on nothing but the parameters.
struct Step {
  std::string label;  // "3", or "3a" for the first deeper step after it
  std::string title;
  bool deeper = false;
  StepFunction run;
};

/// A lesson: its parameters, its steps, its end. The main of a lesson fills one and returns `run(argc,
/// argv)`.
///
///     int main(int argc, char** argv) {
///       Lesson lesson({.slug = "04_baumgarte", .title = "Baumgarte", .summary = "…", .method = "…"});
///       auto beta = lesson.parameter("beta", 0.2, "1", {0, 3}, "share of the error that one step removes");
///       auto h = lesson.parameter("h", 1.0 / 60, "s", {1e-4, 0.1}, "time step");
///       lesson.step("The error shrinks by (1 − β)", [=](Page& page) { page.text("β is @.", beta()); … });
///       lesson.deeper("…", [=](Page& page) { … });
///       lesson.closing({.now_you_know = {…}, .tries = {{"…", "./lessons/run 4 --set beta=2.1"}}, .next =
///       "…"}); return lesson.run(argc, argv);
///     }
class Lesson {
 public:
  /// Throws LessonError unless the slug is two digits, "_" and [a-z0-9_]+.
  explicit Lesson(About about);

  /// A parameter with its default, unit ("1" for none), range and meaning. T is double or int: 10 makes an
  /// int, 10.0 a double. The parameter called "h" is the time step in manifest.json. Throws LessonError for a
  /// default out of range or a name twice.
  Parameter<double> parameter(std::string name, double initial, std::string unit, Range range,
                              std::string meaning);
  Parameter<int> parameter(std::string name, int initial, std::string unit, Range range, std::string meaning);
  /// One of `choices`, typed by its name; names are [a-z0-9_]+.
  Parameter<std::string> parameter(std::string name, std::string initial, std::vector<std::string> choices,
                                   std::string meaning);

  /// A core step; at most seven, else LessonError.
  void step(std::string title, StepFunction run);

  /// A step that goes deeper, after the last core step: opened by a reader with `d`, always run without a
  /// terminal.
  void deeper(std::string title, StepFunction run);

  /// Says that the step added last is the only one that looks at these parameters: setting them and no others on
  /// the command line asks for that step alone.
  void answers(const std::vector<std::string>& parameters);

  void closing(Closing closing);

  /// Runs as the options say. Returns 0 fine, 1 a claim is false (or the lesson is written wrongly), 2 bad
  /// usage or value, 3 the environment; every error is one sentence on standard error.
  int run(int argc, const char* const* argv);

  const About& about() const { return about_; }
  int number() const;
  const std::vector<Step>& steps() const { return steps_; }
  const Closing& closing() const { return closing_; }
  const std::deque<ParameterRecord>& parameters() const { return parameters_; }

  /// Throws std::invalid_argument for an unknown name, saying which there are, or for a bad value.
  void set(const std::string& name, std::string_view value);
  bool is_parameter(const std::string& name) const;
  /// The label of the step that alone looks at all these parameters; empty if there is none.
  std::string step_of(const std::vector<std::pair<std::string, std::string>>& settings) const;
  bool at_defaults() const;

 private:
  ParameterRecord& record(ParameterRecord record);

  About about_;
  std::deque<ParameterRecord> parameters_;  // a deque: the parameters handed out point into it
  std::vector<Step> steps_;
  Closing closing_;
};

}  // namespace byhand::tutor
