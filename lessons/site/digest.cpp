#include "lessons/site/digest.hpp"

#include "lessons/page/article_equations.hpp"
#include "lessons/page/html/markup.hpp"

namespace byhand::site {
namespace {

using namespace course;

/// Collects of each item what it adds to the digest.
struct Collect {
  Digest& lesson;
  Digest::Step& step;

  void operator()(const Text& text) const { add(text.words); }
  void operator()(const Equation& equation) const {
    if (equation.number > 0) add(article_equation(equation.number).plain);
    add(equation.numbers.plain);
  }
  void operator()(const Excerpt& excerpt) const { add(excerpt.file); }
  void operator()(const course::Table& table) const {
    for (const auto& row : table.rows)
      for (const std::string& cell : row) add(cell);
  }
  void operator()(const Derivation& derivation) const {
    add(derivation.title);
    for (const DerivationLine& line : derivation.lines) add(line.why + " " + line.plain);
    step.laws.push_back(derivation.title);
  }
  void operator()(const Measure& measure) const { add(measure.quantity); }
  void operator()(const Figure& figure) const {
    ++lesson.figures;
    add(figure.caption);
  }
  void operator()(const Sequence& film) const {
    ++lesson.films;
    ++step.films;
    add(film.caption);
  }
  void operator()(const Prediction& question) const {
    ++step.questions;
    add(question.ask);
  }
  void operator()(const Choice& question) const {
    ++step.questions;
    add(question.ask);
  }
  void operator()(const Claim&) const { ++lesson.claims; }

 private:
  void add(const std::string& words) const {
    if (!words.empty()) step.words += (step.words.empty() ? "" : " ") + plain_text(words);
  }
};

}  // namespace

Digest digest(const Lesson& lesson, const std::vector<RecordedStep>& steps) {
  Digest all{.slug = lesson.about().slug};
  for (const auto& [step, page, reads] : steps) {
    Digest::Step& here =
        all.steps.emplace_back(Digest::Step{.label = step->label, .title = step->title, .deeper = step->deeper});
    here.scene = step->hold.has_value();
    here.reads = reads;
    for (const Item& item : page.items()) std::visit(Collect{all, here}, item);
  }
  return all;
}

}  // namespace byhand::site
