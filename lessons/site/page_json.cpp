#include "lessons/site/page_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lessons/files/commit.hpp"
#include "lessons/page/about.hpp"
#include "lessons/page/article_equations.hpp"
#include "lessons/page/html/mathml.hpp"
#include "lessons/site/lesson_page.hpp"

namespace byhand::site {
namespace {

using Json = nlohmann::ordered_json;

/// "</script>" within a string would end the element.
std::string for_script(const Json& json) {
  std::string all;
  for (const char c : json.dump()) all += c == '<' ? "\\u003c" : c == '&' ? "\\u0026" : std::string(1, c);
  return all;
}

}  // namespace

std::string parameters_json(const course::Lesson& lesson, const std::vector<course::RecordedStep>& steps) {
  Json all = Json::array();
  for (const course::ParameterRecord& p : lesson.parameters())
    all.push_back({{"name", p.name},
                   {"unit", p.unit},
                   {"meaning", p.meaning},
                   {"low", p.range.low},
                   {"high", p.range.high},
                   {"whole", p.integer},
                   {"choices", p.choices},
                   {"initial", p.initial},
                   {"typed", p.typed(p.initial)}});
  Json reads = Json::object();
  for (const course::RecordedStep& step : steps) reads[step.step->label] = step.reads;
  return for_script({{"parameters", all}, {"steps", reads}});
}

std::string to_json(const Digest& digest) {
  Json steps = Json::array();
  for (const Digest::Step& step : digest.steps)
    steps.push_back({{"label", step.label},
                     {"title", step.title},
                     {"deeper", step.deeper},
                     {"words", step.words},
                     {"questions", step.questions},
                     {"films", step.films},
                     {"scene", step.scene},
                     {"reads", step.reads},
                     {"laws", step.laws}});
  return Json{{"slug", digest.slug},
              {"steps", steps},
              {"claims", digest.claims},
              {"figures", digest.figures},
              {"films", digest.films}}
      .dump();
}

Digest digest_from_json(const std::string& text) {
  const Json json = Json::parse(text);
  Digest digest{.slug = json.at("slug"),
                .claims = json.at("claims"),
                .figures = json.at("figures"),
                .films = json.at("films")};
  for (const Json& step : json.at("steps"))
    digest.steps.push_back({.label = step.at("label"),
                            .title = step.at("title"),
                            .deeper = step.at("deeper"),
                            .words = step.at("words"),
                            .questions = step.at("questions"),
                            .films = step.at("films"),
                            .scene = step.at("scene"),
                            .reads = step.at("reads"),
                            .laws = step.at("laws")});
  return digest;
}

std::string search_index(const std::vector<Digest>& lessons) {
  Json pages = Json::array();
  for (const Digest& lesson : lessons) {
    Json steps = Json::array();
    for (const Digest::Step& step : lesson.steps)
      // A search finds the parameters of a step too.
      steps.push_back(
          {"step-" + step.label, step.label + " " + step.title,
           fmt::format("{}{}{}", step.words, step.reads.empty() ? "" : " ", fmt::join(step.reads, " "))});
    pages.push_back({page_of(lesson.slug), lesson_title(lesson.slug), steps});
  }
  return pages.dump();
}

std::string equations_script() {
  Json all = Json::object();
  for (int i = 1; i <= course::article_equations; ++i)
    all[std::to_string(i)] = display_mathml(course::article_equation(i).latex);
  return "'use strict';\nvar equations = " + all.dump() + ";\n";
}

std::string site_manifest(const std::map<std::string, std::string>& files) {
  return Json{{"site", "Constraints by Hand"}, {"commit", course::commit()}, {"files", files}}.dump(2) + "\n";
}

}  // namespace byhand::site
