#include "lessons/terminal/batch.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>
#include <type_traits>

#include "lessons/files/lesson_json.hpp"
#include "lessons/files/markdown.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/terminal/claim_table.hpp"
#include "lessons/terminal/terminal_text.hpp"

namespace byhand::course {
namespace {

void print(const RecordedStep& recorded, const Lesson& lesson, const PictureWriter& pictures) {
  const Style style;
  std::string words = title_text(lesson, *recorded.step, style);
  for (const Item& item : recorded.page.items()) {
    words += "\n";
    std::visit(
        [&](const auto& it) {
          using Kind = std::decay_t<decltype(it)>;
          if constexpr (std::is_same_v<Kind, Figure>)
            words += item_text(it, style) + caption_text(it.caption, pictures.path(it), style);
          else if constexpr (std::is_same_v<Kind, Sequence>)
            words += caption_text(it.caption, pictures.path(it), style);
          else if constexpr (std::is_same_v<Kind, Derivation>)
            words += derivation_text(it, style);
          else if constexpr (std::is_same_v<Kind, Prediction> || std::is_same_v<Kind, Choice>)
            words += item_text(it, style) + "\n  Answer\n" + answer_text(it, style);
          else
            words += item_text(it, style);
        },
        item);
  }
  fmt::print("{}", words);
}

/// The files that hold what a clock measured.
std::set<std::string> clocked(const std::vector<RecordedStep>& steps) {
  std::set<std::string> names;
  for (const RecordedStep& step : steps)
    for (const Item& item : step.page.items())
      if (const auto* figure = std::get_if<Figure>(&item);
          figure && std::holds_alternative<TimedChart>(figure->picture))
        names.insert({figure_path(figure->name), data_path(figure->name)});
  return names;
}

}  // namespace

void write_pictures(const Page& page, PictureWriter& pictures) {
  for (const Item& item : page.items()) {
    if (const auto* figure = std::get_if<Figure>(&item)) pictures.write(*figure);
    if (const auto* sequence = std::get_if<Sequence>(&item)) pictures.write(*sequence);
  }
}

void finish_output(const Lesson& lesson, const std::vector<RecordedStep>& steps, const Options& options,
                   bool whole, PictureWriter& pictures) {
  OutputFolder& output = pictures.output();
  if (whole) output.write("lesson.md", markdown(lesson, steps, options.frames));
  output.finish(made_by(lesson, options, whole ? "" : options.step, pictures.gl()), clocked(steps), whole);
  if (whole && !options.quiet)
    fmt::print("\nThe lesson as a page:\n  {0}/lesson.md\nIts pictures:\n  {0}/figures\n  {0}/frames\n",
               printable(output.path().string()));
}

namespace {

int print_questions(const Lesson& lesson, const Options& options) {
  std::vector<RecordedStep> steps;
  for (const Step& step : lesson.steps())
    if (options.step.empty() || step.label == options.step)
      steps.push_back(record_step(lesson, step, options.quiet));
  fmt::print("{}", questions(lesson, steps));
  return 0;
}

/// Returns the exit status.
int complain_of_false_claims(const Lesson& lesson, const std::vector<RecordedStep>& steps) {
  const std::string wrong = false_claims(lesson, steps);
  complain(wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int run_batch(const Lesson& lesson, const Options& options) {
  if (options.questions) return print_questions(lesson, options);
  const bool whole = options.step.empty();
  const bool speaks = !options.quiet && !options.check;
  // Fails before the work begins rather than after a minute.
  std::optional<PictureWriter> pictures;
  if (!options.check) pictures.emplace(lesson, options);
  std::vector<RecordedStep> steps;
  if (speaks && whole) fmt::print("{}", heading_text(lesson, {}));
  for (const Step& step : lesson.steps()) {
    if (!whole && step.label != options.step) continue;
    steps.push_back(record_step(lesson, step, options.quiet));
    if (speaks) print(steps.back(), lesson, *pictures);
    if (pictures) write_pictures(steps.back().page, *pictures);
  }
  if (speaks && whole) fmt::print("{}", closing_text(lesson, {}));
  if (whole) validate(steps);
  if (pictures) finish_output(lesson, steps, options, whole, *pictures);
  if (options.check && !options.quiet) fmt::print("{}", claim_table(steps));
  return complain_of_false_claims(lesson, steps);
}

}  // namespace byhand::course
