#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/page/items.hpp"
#include "lessons/page/side_by_side.hpp"

namespace byhand::course {

/// The items that one step records, in reading order. Terminal, Markdown and the table of claims are made from the
/// same page, so text, numbers and figures agree.
///
/// Words may use *emphasis*, **strong** and `code`; a blank line starts a new paragraph, lines that begin
/// with "- " are a list. Each `@` is replaced by the next value (see Value). Greek, dots and superscripts are
/// written in Unicode: "JM⁻¹Jᵀ".
///
/// All prose (texts, captions, questions with their replies, the closing of a lesson) may be written over several
/// lines of the source; how they are indented and where they end makes no difference (see unwrapped):
///
///     page.text(
///         R"(The rod pulls along d only, so it cannot change the
///         speed across it: @ m/s, before and after.)",
///         speed);
class Page {
 public:
  template <class... T>
  void text(std::string_view words, const T&... values) {
    add(Text{fill(words, {Value(values)...})});
  }

  /// Equation `number`, 1 to 23, of the article. Throws LessonError for any other number.
  void equation(int number);

  /// The same, followed by the equation with this scene's numbers:
  /// `page.equation(17, "λ = −(@ + @) / @ = @ N·s", R"(\lambda = \frac{-(@ + @)}{@} = @\,\mathrm{N\,s})", jv,
  /// b, k, lambda)`.
  template <class... T>
  void equation(int number, std::string_view plain, std::string_view latex, const T&... values) {
    equation(number, fill(plain, latex, {Value(values)...}));
  }

  /// An equation that is not in the article.
  template <class... T>
  void formula(std::string_view plain, std::string_view latex, const T&... values) {
    add(Equation{0, fill(plain, latex, {Value(values)...})});
  }

  /// The lines between two lines `//! [tag]` of `file` (a path from the root of the repository,
  /// "solver/row.hpp"). Throws LessonError when the file or the pair of markers is missing.
  void excerpt(const std::string& file, const std::string& tag);

  /// Code for a reader's own program, under a caption.
  void code(std::string caption, std::string lines) { add(Excerpt{std::move(caption), 0, std::move(lines)}); }

  /// `page.table({"symbol", "meaning", "unit"}, {{"d", "P₂ − P₁", "m"}, …})`; cells may use emphasis.
  void table(std::vector<std::string> head, std::vector<std::vector<std::string>> rows);

  /// A derivation, folded: <details> on the page; `why` opens it at a terminal.
  /// `page.derivation("Why β < 2", {{"(21) with JV = 0", "C′ = C + hJV", R"(C' = C + hJV)"}, …})`
  void derivation(std::string title, std::vector<DerivationLine> lines);

  /// A result. When a parameter changes, its old and new value are printed on one line.
  void measure(std::string quantity, double value, std::string unit);

  /// A chart: figures/<name>.png and data/<name>.csv, which holds `data` where it is not empty. Names are
  /// [a-z0-9_]+ and unique in a lesson.
  void figure(std::string name, std::string caption, renderer::Chart chart, std::string data = {});

  /// A picture. `draw` runs later, and only if pictures are written: capture by value.
  void figure(std::string name, std::string caption, Drawing draw, std::string data = {});

  /// A chart of measured running times, the only output that differs between runs. `measure` runs later, while
  /// nothing else does, and only if the chart is shown or written: capture by value.
  void clocked(std::string name, std::string caption, std::function<renderer::Chart()> measure);

  /// An animation, drawn later by a copy of `draw` at times that never decrease; `--frames last` asks for the last
  /// time only. So `draw` should capture its simulation by value, be `mutable`, and advance the simulation to the
  /// given time.
  void sequence(std::string name, std::string caption, std::variant<Seconds, Frames> length, FrameDrawing draw);

  void predict(Prediction question);
  void choose(Choice question);
  void claim(Claim claim);
  /// `page.claim("period", 2 * fine - coarse, "s", is(exact.period(), "elliptic integral", relative(1e-3)),
  /// where(Quantity("h·√(g/L)", step) <= 0.06))`.
  void claim(std::string quantity, double measured, std::string unit, Expected expected, Condition range = {});

  /// The first of these sentences whose condition is met, for the text that is added next, and a claim below that
  /// text. "" if none is met: then nothing is claimed either. Throws LessonError for a condition without words.
  ///
  ///     page.text("After @ s the rod is @ m off. @", t, C, page.verdict({{.when = Quantity("C/L", C / L) < 0.01,
  ///     .say = "That is too little to be seen."}}));
  std::string verdict(const std::vector<Judgement>& sentences);

  /// Computes work(0), …, work(count − 1) in parallel on all cores and returns them in this order, with a progress
  /// bar. The result does not depend on the number of threads if work(i) depends on i alone.
  template <class F>
  auto side_by_side(int count, const F& work) const {
    std::vector<decltype(work(0))> results(static_cast<std::size_t>(count));
    course::side_by_side(
        count, [&](int i) { results[static_cast<std::size_t>(i)] = work(i); }, progress_);
    return results;
  }
  /// Sets the progress bar of that work; null for none.
  void watch(Progress* progress) { progress_ = progress; }

  const std::vector<Item>& items() const { return items_; }
  std::vector<Item>& items() { return items_; }

 private:
  void equation(int number, Formula numbers);
  void add(Item item);

  std::vector<Item> items_;
  std::vector<Claim> verdicts_;  // of the text that is added next
  Progress* progress_ = nullptr;
};

}  // namespace byhand::course
