#include "lessons/site/course/cover_scene.hpp"

#include <fmt/format.h>

#include <string_view>

#include "lessons/files/atomic_file.hpp"
#include "lessons/site/course/page_text.hpp"
#include "lessons/site/lesson_page.hpp"

namespace byhand::site {
namespace {

constexpr auto scene_of = "03_iterations", knob = "sweeps";

/// The stretch of a text from the first `begin` at or after `from` up to and with the next `end`; empty without
/// it.
std::string stretch(const std::string& text, std::string_view begin, std::string_view end, size_t from = 0) {
  const auto first = text.find(begin, from);
  const auto last = first == std::string::npos ? first : text.find(end, first);
  return last == std::string::npos ? "" : text.substr(first, last + end.size() - first);
}

/// The label of the step in which a place of the page lies.
std::string step_at(const std::string& page, size_t at) {
  constexpr std::string_view name = "data-step=\"";
  const auto begin = page.rfind(name, at) + name.size();
  return page.substr(begin, page.find('"', begin) - begin);
}

}  // namespace

CoverScene cover_scene(const std::filesystem::path& site) {
  const std::string page = course::read_whole(site / page_of(scene_of)).value_or("");
  constexpr std::string_view begin = "<figure class=\"figure hold\"";
  std::string figure = stretch(page, begin, "</figure>");
  if (figure.empty()) return {};
  replace_all(figure, "data-knobs=\"", "\"", fmt::format("data-knobs=\"{}\"", knob));
  replace_all(figure, "data-count=\"", "\"", "data-count=\"1\"");
  const std::string parameters =
      stretch(page, "<script type=\"application/json\" id=\"parameters\">", "</script>");
  const bool live = page.find(fmt::format("live/{}.js", scene_of)) != std::string::npos;
  return {fmt::format(
              "<article class=\"lesson scene\">\n<section class=\"step\" data-step=\"{}\" data-only=\"\">\n{}\n"
              "</section>\n</article>\n",
              step_at(page, page.find(begin)), figure),
          live ? live_head() : "", live ? parameters + live_scripts(scene_of) : ""};
}

}  // namespace byhand::site
