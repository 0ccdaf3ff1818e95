#include "lessons/page/html/step_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/claim_words.hpp"
#include "lessons/page/grading.hpp"
#include "lessons/page/html/alternative.hpp"
#include "lessons/page/html/code_html.hpp"
#include "lessons/page/html/colours.hpp"
#include "lessons/page/html/drawn.hpp"
#include "lessons/page/html/markup.hpp"
#include "lessons/page/html/mathml.hpp"

namespace byhand::site {
namespace {

using namespace course;

std::string equation_line(const std::string& latex, int number) {
  const std::string label =
      number == 0 ? "" : fmt::format("<a class=\"number\" href=\"equations.html#equation-{0}\">({0})</a>", number);
  return fmt::format("<div class=\"equation\"><div class=\"formula\">{}</div>{}</div>", display_mathml(latex),
                     label);
}

/// A drawing's caption. Panels that are side by side on a screen are one above the other on a phone.
std::string caption_html(const std::string& caption) {
  std::string html = inline_html(caption);
  for (const auto& [here, there] : {std::pair{"Left", "Above"}, {"Right", "Below"}}) {
    const std::string place = std::string(here) + ":",
                      both = fmt::format(
                          "<span class=\"on-screens\">{}</span><span class=\"on-phones\">{}</span>:", here, there);
    for (auto at = html.find(place); at != std::string::npos; at = html.find(place, at + both.size()))
      html.replace(at, place.size(), both);
  }
  return html;
}

std::string folded(const std::string& css_class, const std::string& summary, const std::string& inside) {
  return fmt::format("<details class=\"{}\"><summary>{}</summary>{}</details>", css_class, summary, inside);
}

/// A column without a name has no header cell.
template <class Head>
std::string table(const Head& head, const std::string& rows) {
  std::string cells;
  for (const std::string_view words : head)
    cells += words.empty() ? "<td></td>" : fmt::format("<th scope=\"col\">{}</th>", inline_html(words));
  return fmt::format("<div class=\"scroll\"><table><thead><tr>{}</tr></thead><tbody>{}</tbody></table></div>",
                     cells, rows);
}

/// Writes the children of a step's section. A run of claims, or of measures, becomes one child.
class ItemWriter {
 public:
  /// `held`: the figure of the step's scene to hold, which stands before its claims, and in the course's first
  /// step, which begins with it, after its first text; empty without one.
  ItemWriter(const RecordedStep& step, const Pictures& pictures, std::string held)
      : step_(step), pictures_(pictures), held_(std::move(held)) {}

  std::string all() {
    for (const Item& item : step_.page.items()) {
      std::visit(*this, item);
      ++index_;
      if (begins_with_it() && std::holds_alternative<Text>(item)) html_ += std::exchange(held_, {});
    }
    close_run();
    return html_ + std::exchange(held_, {});
  }

  void operator()(const Text& text) { block("text", prose_html(text.words)); }

  void operator()(const Equation& equation) {
    std::string lines;
    if (equation.number > 0) lines += equation_line(article_equation(equation.number).latex, equation.number);
    if (!equation.numbers.latex.empty()) lines += equation_line(equation.numbers.latex, 0);
    block("equations", lines);
  }

  void operator()(const Excerpt& excerpt) {
    const std::string caption = excerpt.line > 0
                                    ? fmt::format("<code>{}</code>, line {}", escaped(excerpt.file), excerpt.line)
                                    : escaped(excerpt.file);
    child(fmt::format("<figure class=\"excerpt\" data-item=\"{}\"><figcaption>{}</figcaption>{}</figure>", index_,
                      caption, code_html(excerpt.code)));
  }

  void operator()(const course::Table& data) {
    std::string rows;
    for (const auto& row : data.rows) {
      rows += "<tr>";
      for (const std::string& cell : row) rows += "<td>" + inline_html(cell) + "</td>";
      rows += "</tr>";
    }
    block("table", table(data.head, rows));
  }

  void operator()(const Derivation& derivation) {
    std::string lines;
    for (const DerivationLine& line : derivation.lines)
      lines += fmt::format("<li><p>{}</p>{}</li>", inline_html(line.why), equation_line(line.latex, 0));
    block("derivation",
          folded("lines", "Derivation: " + inline_html(derivation.title, Links::none), "<ol>" + lines + "</ol>"));
  }

  void operator()(const Measure& measure) {
    begin_run(Run::measures);
    run_ += fmt::format("<div data-item=\"{}\"><dt>{}</dt><dd>{}</dd></div>", index_,
                        inline_html(measure.quantity), escaped(quantity(measure.value, measure.unit)));
  }

  void operator()(const Figure& figure) {
    picture("figure", figure, pictures_.figure(figure), std::holds_alternative<Drawing>(figure.picture));
  }
  void operator()(const Sequence& film) { picture("film", film, pictures_.film(film), true); }

  void operator()(const Prediction& question) {
    std::string answer = fmt::format("<p><strong>{}</strong>. {}</p>", escaped(printed_answer(question)),
                                     inline_html(question.right));
    for (const WrongAnswer& wrong : question.wrong)
      answer += fmt::format("<p>Not {}: {}</p>", escaped(quantity(wrong.value, question.unit, 4)),
                            inline_html(wrong.reply));
    const std::string unit = question.unit.empty() || question.unit == "1" ? "" : escaped(question.unit);
    const std::string field = fmt::format(
        "<p class=\"answer\"><label>Your prediction <input name=\"typed\" type=\"text\" autocomplete=\"off\" "
        "/></label>{} <button type=\"submit\">Check</button></p>",
        unit.empty() ? "" : " <span class=\"unit\">" + unit + "</span>");
    ask("number", question.ask, field, question.hints, answer);
  }

  void operator()(const Choice& question) {
    std::string options, answer;
    for (size_t i = 0; i < question.options.size(); ++i) {
      const Option& option = question.options[i];
      const bool right = static_cast<int>(i) == question.answer;
      options += fmt::format(
          "<li><label><input class=\"answer\" name=\"typed\" type=\"radio\" value=\"{}\" /> {}</label></li>",
          i + 1, inline_html(option.words));
      const std::string words = fmt::format("{}. {}", i + 1, inline_html(option.words));
      answer += fmt::format("<p>{} {}</p>", right ? "<strong>" + words + "</strong>." : "Not " + words + ":",
                            inline_html(option.reply));
    }
    ask("choice", question.ask, "<ol>" + options + "</ol>", question.hints, answer);
  }

  void operator()(const Claim& claim) {
    begin_run(Run::claims);
    const std::string range = claim.range.words.empty() ? ""
                                                        : fmt::format(" <span class=\"range\">(for {})</span>",
                                                                      inline_html(claim.range.words));
    const std::string said = verdict(claim);
    run_ += fmt::format(
        "<tr data-item=\"{}\" data-verdict=\"{}\"><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
        index_, said, inline_html(claim.quantity), range, escaped(in_plain_words(measurement(claim))),
        escaped(in_plain_words(expectation(claim))), inline_html(claim.source), said);
    ++(claim.is_false() ? false_ : claim.claimed() ? hold_ : not_claimed_);
  }

 private:
  enum class Run { none, measures, claims };

  bool begins_with_it() const { return step_.step->label == "1"; }

  void child(const std::string& html) {
    close_run();
    html_ += html + "\n";
  }
  void block(const char* css_class, const std::string& inside) {
    child(fmt::format("<div class=\"{}\" data-item=\"{}\">{}</div>", css_class, index_, inside));
  }

  template <class Drawn>
  void picture(const char* kind, const Drawn& it, const Shown& shown, bool has_panels) {
    constexpr auto save =
        R"(<button type="button" aria-label="Save as SVG">SVG</button> <button type="button" aria-label="Save as PNG">PNG</button> )";
    const Alternative other = alternative(it, shown.markup);
    const bool in_page = shown.markup.find("<svg") != std::string::npos;
    child(
        fmt::format("<figure class=\"{0}\" id=\"{0}-{1}\" data-item=\"{2}\" data-{0}=\"{1}\">"
                    "<div class=\"picture\"{8} role=\"img\" "
                    "aria-label=\"{3}\">{4}</div><figcaption>{5}{6}{7}</figcaption></figure>",
                    kind, it.name, index_, escaped(plain_text(it.caption + " " + other.label)), shown.markup,
                    has_panels ? caption_html(it.caption) : inline_html(it.caption),
                    fmt::format(" <details class=\"files\"><summary>Save</summary>{}{}</details>",
                                in_page ? save : "", shown.links),
                    other.words.empty() ? "" : folded("words", "In words", prose_html(other.words)),
                    shown.sideways ? " data-sideways=\"\"" : ""));
  }

  void ask(const char* kind, const std::string& words, const std::string& field,
           const std::vector<std::string>& hints, const std::string& answer) {
    std::string folds;
    for (size_t i = 0; i < hints.size(); ++i)
      folds += folded("hint", hints.size() == 1 ? "Hint" : fmt::format("Hint {}", i + 1), prose_html(hints[i]));
    folds += folded("solution", "Answer", answer);
    ++questions_;
    child(fmt::format(
        R"(<form class="question" data-item="{0}" data-question="{1}.{2}" data-kind="{3}" aria-label="Question {1}.{2}">)"
        R"(<p class="before">Before you read on</p>{4}{5}<p class="reply" role="status"></p>{6}</form>)",
        index_, step_.step->label, questions_, kind, prose_html(words), field, folds));
  }

  void begin_run(Run run) {
    if (kind_ == run) return;
    close_run();
    kind_ = run;
    first_ = index_;
  }

  void close_run() {
    if (kind_ == Run::measures)
      html_ += fmt::format("<dl class=\"measures\" data-item=\"{}\">{}</dl>\n", first_, run_);
    if (kind_ == Run::claims) {
      html_ += std::exchange(held_, {});
      constexpr std::array head{"claim", "measured", "expected", "according to", "verdict"};
      html_ += fmt::format(
          "<details class=\"claims\" data-item=\"{}\" data-false=\"{}\"{}><summary>{}</summary>{}</details>\n",
          first_, false_, false_ ? " open=\"open\"" : "", claims_in_short(), table(head, run_));
    }
    kind_ = Run::none;
    run_.clear();
    hold_ = false_ = not_claimed_ = 0;
  }

  /// "7 claims hold, 1 is false, 2 are not made here"
  std::string claims_in_short() const {
    std::string words;
    const auto add = [&](int n, const char* one, const char* many) {
      if (n == 0) return;
      words += words.empty() ? several(n, "claim") + " " : fmt::format(", {} ", n);
      words += n == 1 ? one : many;
    };
    add(hold_, "holds", "hold");
    add(false_, "is false", "are false");
    add(not_claimed_, "is not made here", "are not made here");
    return words;
  }

  const RecordedStep& step_;
  const Pictures& pictures_;
  std::string held_, html_, run_;
  Run kind_ = Run::none;
  int index_ = 0, first_ = 0, questions_ = 0, hold_ = 0, false_ = 0, not_claimed_ = 0;
};

/// The scene as it begins; a live page lets a reader hold it. data-parts: whether a step of it has parts to tell.
std::string hold_figure(const course::Hold& hold) {
  const auto scene = hold.scene();
  const std::string svg = drawn(
      hold.name, [&](renderer::Canvas& canvas) { scene->draw(canvas); }, {}, course::Held::width);
  return fmt::format(
      R"(<figure class="figure hold" id="hold-{0}" data-item="hold" data-hold="{0}" data-parts="{5}">)"
      R"(<div class="picture" role="img" aria-label="{1} {2}">{3}</div>)"
      "<figcaption>{4}</figcaption></figure>\n",
      hold.name, escaped(plain_text(hold.caption)), escaped(scene->words()), svg, inline_html(hold.caption),
      scene->words(0.0) == scene->words() ? "no" : "yes");
}

}  // namespace

std::string step_html(const RecordedStep& recorded, const Pictures& pictures) {
  const Step& step = *recorded.step;
  return fmt::format(
      R"(<section class="step{0}" id="step-{1}" data-step="{1}">
<h2><span class="label">{1}</span> {2}{3}</h2>
{4}</section>
)",
      step.deeper ? " deeper" : "", step.label, inline_html(step.title),
      step.deeper ? " <span class=\"depth\">deeper</span>" : "",
      with_colours(ItemWriter(recorded, pictures, step.hold ? hold_figure(*step.hold) : "").all()));
}

}  // namespace byhand::site
