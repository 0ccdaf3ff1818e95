#include "lessons/tutor/straight.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <system_error>
#include <type_traits>

#include "lessons/tutor/check.hpp"
#include "lessons/tutor/manifest.hpp"
#include "lessons/tutor/markdown.hpp"
#include "lessons/tutor/speech.hpp"
#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace byhand::tutor {
namespace {

void print(const Told& told, const Lesson& lesson, const Studio& studio) {
  const Style style;
  std::string words = say_title(lesson, *told.step, style);
  for (const Item& item : told.page.items()) {
    words += "\n";
    std::visit(
        [&](const auto& it) {
          using Kind = std::decay_t<decltype(it)>;
          if constexpr (std::is_same_v<Kind, Figure>)
            words += say(it, style) + say_caption(it.caption, studio.path(it), style);
          else if constexpr (std::is_same_v<Kind, Sequence>)
            words += say_caption(it.caption, studio.path(it), style);
          else if constexpr (std::is_same_v<Kind, Prediction> || std::is_same_v<Kind, Choice>)
            words += say(it, style) + "\n  Answer\n" + say_answer(it, style);
          else
            words += say(it, style);
        },
        item);
  }
  fmt::print("{}", words);
}

}  // namespace

Studio studio_of(const Lesson& lesson, const Options& options) {
  const std::filesystem::path folder = options.output / lesson.about().slug;
  std::error_code error;
  // Better refused now than after a minute's work.
  if (!options.check && !std::filesystem::create_directories(folder, error) && error)
    throw renderer::EnvironmentError(
        fmt::format("Cannot make the folder {}: {}.", folder.string(), error.message()));
  return {folder, options.quality, options.frames, options.quiet};
}

void write_pictures(const Page& page, Studio& studio) {
  for (const Item& item : page.items()) {
    if (const auto* figure = std::get_if<Figure>(&item)) studio.write(*figure);
    if (const auto* sequence = std::get_if<Sequence>(&item)) studio.write(*sequence);
  }
}

void publish(const Lesson& lesson, const std::vector<Told>& told, const Options& options, const Studio& studio) {
  renderer::write_whole(studio.folder() / "lesson.md", markdown(lesson, told, options.frames));
  renderer::write_whole(studio.folder() / "manifest.json", manifest(lesson, told, options, studio.gl()));
  if (!options.quiet)
    fmt::print("\nThe lesson as a page: {0}/lesson.md; its pictures: {0}/figures and {0}/frames\n",
               studio.folder().string());
}

int run_straight(const Lesson& lesson, const Options& options) {
  const bool whole = options.step.empty();
  const bool speaks = !options.quiet && !options.check;
  Studio studio = studio_of(lesson, options);
  std::vector<Told> told;
  if (speaks && whole) fmt::print("{}", say_heading(lesson, {}));
  for (const Step& step : lesson.steps()) {
    if (!whole && step.label != options.step) continue;
    told.push_back(tell(lesson, step, options.quiet));
    if (speaks) print(told.back(), lesson, studio);
    if (!options.check) write_pictures(told.back().page, studio);
  }
  if (speaks && whole) fmt::print("{}", say_closing(lesson, {}));
  if (whole) require_whole(told);
  if (whole && !options.check) publish(lesson, told, options, studio);
  if (options.check && !options.quiet) fmt::print("{}", check_table(told));
  const std::string wrong = false_claims(lesson, told);
  fmt::print(stderr, "{}", wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace byhand::tutor
