#include "lessons/site/controls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>
#include <variant>

#include "lessons/files/commit.hpp"
#include "lessons/page/html/markup.hpp"

namespace byhand::site {
namespace {

using namespace course;

/// Whether the words name a parameter, as a text does: "β" or "beta", "end mass".
bool name_it(const std::string& words, std::string name) {
  if (name == "beta" && words.find("β") != std::string::npos) return true;
  std::replace(name.begin(), name.end(), '_', ' ');
  const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !letter(words[at - 1])) && (end == words.size() || !letter(words[end]))) return true;
  }
  return false;
}

/// What opens the figure of a picture, and the parameters below it.
struct Place {
  std::string id;
  std::vector<std::string> knobs;
};

std::vector<Place> places(const RecordedStep& step, const std::vector<RecordedStep>& lesson,
                          const Changes& changes) {
  std::vector<Place> all;
  const auto add = [&](const char* kind, const std::string& name, const std::string& caption) {
    all.push_back({fmt::format("id=\"{}-{}\"", kind, name), knobs(step, name, caption, lesson, changes)});
  };
  for (const Item& item : step.page.items()) {
    if (const auto* figure = std::get_if<Figure>(&item)) add("figure", figure->name, figure->caption);
    if (const auto* film = std::get_if<Sequence>(&item)) add("film", film->name, film->caption);
  }
  if (step.step->hold) add("hold", step.step->hold->name, step.step->hold->caption);
  return all;
}

/// Why a step of a live page has nothing to change.
std::string recorded() {
  return fmt::format(
      "This step reads no parameter: its numbers are those of the program that wrote this page, commit "
      "{} of {}.",
      escaped(std::string(commit()).substr(0, 12)), std::string(commit_time()).substr(0, 10));
}

}  // namespace

std::vector<std::string> knobs(const RecordedStep& step, const std::string& picture, const std::string& caption,
                               const std::vector<RecordedStep>& lesson, const Changes& changes) {
  const std::string words = plain_text(caption), title = plain_text(step.step->title);
  const auto rank = [&](const std::string& name) {
    const auto readers = std::count_if(lesson.begin(), lesson.end(), [&](const RecordedStep& other) {
      return std::find(other.reads.begin(), other.reads.end(), name) != other.reads.end();
    });
    return std::tuple(!name_it(words, name), !name_it(title, name), readers);
  };
  std::vector<std::string> names = step.reads;
  std::erase(names, "resolution");  // of a map: how finely it is drawn, not what it shows
  std::stable_sort(names.begin(), names.end(),
                   [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
  std::vector<std::string> all;
  for (const std::string& name : names)
    if (all.size() < 2 && changes(picture, name)) all.push_back(name);
  return all;
}

std::string with_controls(std::string section, const RecordedStep& step, const std::vector<RecordedStep>& lesson,
                          const Changes& changes) {
  for (const auto& [id, names] : places(step, lesson, changes)) {
    const std::size_t figure = section.find(id), caption = section.find("<figcaption>", figure);
    if (caption == std::string::npos) continue;
    section.insert(caption, fmt::format("<div class=\"controls\" data-knobs=\"{}\" data-count=\"{}\"></div>",
                                        fmt::join(names, " "), names.size()));
  }
  section.insert(section.rfind("</section>"), step.reads.empty() ? "<p class=\"recorded\">" + recorded() + "</p>\n"
                                                                 : "<div class=\"others\"></div>\n");
  return section;
}

}  // namespace byhand::site
