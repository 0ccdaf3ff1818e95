#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lessons/page/condition.hpp"
#include "lessons/page/words.hpp"
#include "renderer/chart.hpp"

namespace byhand::renderer {
class Canvas;
}

namespace byhand::course {

struct Text {
  std::string words;
};

/// Equation (1) to (23) of the article, followed by the same with this scene's numbers, which may be empty. Number
/// 0: not from the article.
struct Equation {
  int number = 0;
  Formula numbers;
};

/// Lines of the compiled source, without markers and common indentation.
struct Excerpt {
  std::string file;  // path from the root of the repository; of code for a reader's own program, what it is
  int line = 0;      // of the first line shown; 0 where it is in no file
  std::string code;
};

/// Each row has as many cells as `head`.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// `why` names the rule or the equation that gives this line from the one before.
struct DerivationLine {
  std::string why, plain, latex;
};

/// A law, line by line. Folded: a reader opens it.
struct Derivation {
  std::string title;
  std::vector<DerivationLine> lines;
};

/// A result that is compared with its old value when a parameter changes.
struct Measure {
  std::string quantity;
  double value = 0;
  std::string unit;
};

using Drawing = std::function<void(renderer::Canvas&)>;
using FrameDrawing = std::function<void(renderer::Canvas&, double time)>;

/// A chart of measured running times. `chart` measures at its first call and then returns the same chart. It is
/// called only when the chart is shown or written, and nothing else runs then. No two runs agree, so manifest.json
/// lists its files as clocked.
struct TimedChart {
  std::function<const renderer::Chart&()> chart;
};

/// Writes figures/<name>.png and, for a chart or where there is `data`, data/<name>.csv.
struct Figure {
  std::string name, caption;
  std::variant<renderer::Chart, Drawing, TimedChart> picture;
  std::string data = {};  // the CSV file, where it is not the chart's own
};

/// The chart of the figure, measured now if it is a TimedChart; null for a drawing.
const renderer::Chart* chart_of(const Figure& figure);

/// Duration [s] in real time, at the frame rate of the quality. The drawing gets the time [s].
struct Seconds {
  double value = 0;
};
/// Number of frames, independent of the quality. The drawing gets the index 0, 1, 2, …
struct Frames {
  int value = 0;
};

/// Writes the animation frames/<name>/0000.png … and two key frames, one below the other, frames/<name>.png.
struct Sequence {
  std::string name, caption;
  std::variant<Seconds, Frames> length;
  FrameDrawing draw;
};

/// A frequent wrong answer, computed by the run like the right one, and the reply to it.
struct WrongAnswer {
  double value = 0;
  std::string reply;
};

/// Asks the reader to predict a number with its sign. An answer is right within `tolerance` (in `unit`); wrong
/// answers are recognised within it too. A missing sign and factors ½, 2, h, g, L are recognised by themselves;
/// `wrong` is for misconceptions with a sentence of their own. `hints` come one by one: what to look at, the
/// equation, the first line of the answer; whoever follows them to `hinted` is right as well. A wrong answer
/// within the tolerance of another answer is dropped; at the default parameters it is a LessonError.
struct Prediction {
  std::string ask = {};
  double answer = 0;
  std::string unit = {};
  double tolerance = 0;
  std::vector<WrongAnswer> wrong = {};
  std::vector<std::string> hints = {};
  double hinted = std::numeric_limits<double>::quiet_NaN();  // where the last hint leads, if it prints no sum
  std::string right = {};  // explains the answer: to a right answer, to a reader who passes, and on the page
};

struct Option {
  std::string words, reply;  // `reply`: to a reader who chooses it, after "Yes." or "No."
};

/// Multiple choice. `answer` is the index of the right option, found by the run.
struct Choice {
  std::string ask = {};
  std::vector<Option> options = {};
  int answer = 0;
  std::vector<std::string> hints = {};
};

/// Allowed difference between measured and expected value, inclusive. A value that is not finite never meets it.
struct Tolerance {
  enum class Kind { absolute, relative, at_most, at_least } kind = Kind::absolute;
  double size = 0;

  bool met(double expected, double measured) const;
};
inline Tolerance absolute(double size) { return {Tolerance::Kind::absolute, size}; }
inline Tolerance relative(double size) { return {Tolerance::Kind::relative, size}; }
/// measured ≤ expected
inline Tolerance at_most() { return {Tolerance::Kind::at_most, 0}; }
/// measured ≥ expected
inline Tolerance at_least() { return {Tolerance::Kind::at_least, 0}; }

/// What a claim expects: `is(2, "O(N)", relative(0.1))`.
struct Expected {
  double value = 0;
  std::string source = {};  // "elliptic integral", "law B1", …
  Tolerance tolerance = {};
};
inline Expected is(double value, std::string source, Tolerance tolerance) {
  return {value, std::move(source), tolerance};
}
inline Expected is_at_most(double limit, std::string source) { return {limit, std::move(source), at_most()}; }
inline Expected is_at_least(double limit, std::string source) { return {limit, std::move(source), at_least()}; }

/// A sentence and the condition under which it is true, made of measured numbers. `law` is what an independent
/// answer predicts where the sentence is said; it may be left out.
struct Judgement {
  Condition when;
  std::string say;
  Condition law = {};
};

/// A number of the text, checked against an independent answer. Outside its range of parameters it is shown as
/// "not claimed" and cannot fail.
struct Claim {
  std::string quantity = {}, unit = {};
  double expected = 0;
  std::string source = {};  // of the expected value
  double measured = 0;
  Tolerance tolerance = {};
  Condition range = {};  // of parameters; needs words if it can be missed
  /// Of a verdict, in place of numbers: its sentence is the quantity.
  std::optional<Condition> judged = {};

  bool claimed() const { return range.met; }
  bool holds() const { return judged ? judged->met : tolerance.met(expected, measured); }
  bool is_false() const { return claimed() && !holds(); }
};

using Item =
    std::variant<Text, Equation, Excerpt, Table, Derivation, Measure, Figure, Sequence, Prediction, Choice, Claim>;

}  // namespace byhand::course
