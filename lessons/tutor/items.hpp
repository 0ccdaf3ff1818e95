#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "lessons/tutor/words.hpp"
#include "renderer/chart.hpp"

namespace byhand::renderer {
class Canvas;
}

namespace byhand::tutor {

struct Text {
  std::string words;
};

/// A formula of the article by its number, (1) to (23), and then the same with this scene's numbers in it
/// (may be empty); number 0 is a formula of the lesson's own.
struct Equation {
  int number = 0;
  Formula numbers;
};

/// Lines of the compiled source, without the markers around them and without their common indentation.
struct Excerpt {
  std::string file;  // from the root of the repository
  int line = 0;      // of the first line shown
  std::string code;
};

/// A result that is worth comparing when a parameter has changed.
struct Measure {
  std::string quantity;
  double value = 0;
  std::string unit;
};

using Drawing = std::function<void(renderer::Canvas&)>;
using FrameDrawing = std::function<void(renderer::Canvas&, double time)>;

/// A chart of what a clock measured. It is no two times the same, so it is measured only where it is wanted, when
/// nothing else of the lesson runs, once; and manifest.json names its files.
struct Clocked {
  std::function<const renderer::Chart&()> chart;
};

/// A still picture: figures/<name>.png; of a chart also data/<name>.csv.
struct Figure {
  std::string name, caption;
  std::variant<renderer::Chart, Drawing, Clocked> picture;
};

/// Its chart, measured now if it has not been yet; none if it is drawn otherwise.
const renderer::Chart* chart_of(const Figure& figure);

/// Real time: as many frames as the quality has in so many seconds. The drawing gets the time in seconds.
struct Seconds {
  double value = 0;
};
/// A number of frames whatever the quality. The drawing gets 0, 1, 2, …
struct Frames {
  int value = 0;
};

/// Moving pictures: frames/<name>/0000.png … and a strip of six of them, frames/<name>.png.
struct Sequence {
  std::string name, caption;
  std::variant<Seconds, Frames> length;
  FrameDrawing draw;
};

/// A wrong answer that people give, computed by the run as the right one is, and the sentence it deserves.
struct WrongAnswer {
  double value = 0;
  std::string reply;
};

/// Asks the reader to predict a number with its sign.
/// An answer is right within `tolerance` (in `unit`); wrong answers are recognised within it too. Where a
/// changed parameter makes a wrong answer meet another one, its reply is dropped; at the default parameters
/// that is an error of the lesson.
struct Prediction {
  std::string ask = {};
  double answer = 0;
  std::string unit = {};
  double tolerance = 0;
  std::vector<WrongAnswer> wrong = {};
  std::string hint = {};
  std::string right = {};  // said after a right answer, and beside the answer on the page
};

struct Option {
  std::string words, reply;  // the reply to whoever chooses it; of the right one, why it is right
};

/// Asks the reader to choose. `answer` is the index of the right option, found by the run.
struct Choice {
  std::string ask = {};
  std::vector<Option> options = {};
  int answer = 0;
  std::string hint = {};
};

/// How far a measurement may lie from what was expected; always inclusive, and never met by a value that is
/// not finite.
struct Tolerance {
  enum class Kind { absolute, relative, at_most, at_least } kind = Kind::absolute;
  double size = 0;

  bool met(double expected, double measured) const;
};
inline Tolerance absolute(double size) { return {Tolerance::Kind::absolute, size}; }
inline Tolerance relative(double size) { return {Tolerance::Kind::relative, size}; }
/// The expectation is a bound: measured ≤ expected.
inline Tolerance at_most() { return {Tolerance::Kind::at_most, 0}; }
/// The expectation is a bound: measured ≥ expected.
inline Tolerance at_least() { return {Tolerance::Kind::at_least, 0}; }

/// A statement in numbers, held against an independent answer. Outside the range of parameters in which it is
/// claimed it is shown as "not claimed" and is no failure.
struct Claim {
  std::string quantity = {}, unit = {};
  double expected = 0;
  std::string source = {};  // where the expectation comes from: "elliptic integral", "law B1", …
  double measured = 0;
  Tolerance tolerance = {};
  bool claimed = true;     // do the parameters lie in the range below?
  std::string range = {};  // "β < 2"; needed when `claimed` can be false

  bool holds() const { return tolerance.met(expected, measured); }
  bool is_false() const { return claimed && !holds(); }
};

using Item = std::variant<Text, Equation, Excerpt, Measure, Figure, Sequence, Prediction, Choice, Claim>;

}  // namespace byhand::tutor
