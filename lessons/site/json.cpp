#include "lessons/site/json.hpp"

#include <nlohmann/json.hpp>

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

std::string parameters_json(const tutor::Lesson& lesson) {
  Json all = Json::array();
  for (const tutor::ParameterRecord& p : lesson.parameters())
    all.push_back({{"name", p.name},
                   {"unit", p.unit},
                   {"meaning", p.meaning},
                   {"low", p.range.low},
                   {"high", p.range.high},
                   {"whole", p.integer},
                   {"choices", p.choices},
                   {"initial", p.typed(p.initial)},
                   {"value", p.typed(p.value)},
                   {"step", p.step}});
  return for_script(all);
}

}  // namespace byhand::site
